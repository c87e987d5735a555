#pragma once

#include "fem/bulk/Material.hpp"

#include <vector>

namespace asperity::fem
{
// A part of the shear modulus whose stress relaxes, in a generalised Maxwell body
//   G(t) = G_inf + sum_k G_k exp(-t / t_k),   G = G(0) = Material::shear_modulus:
//   s_k' = 2 G_k e' - s_k / t_k,   s_k, e: deviatoric stress of the branch and strain.
// The relaxation time is the same in all cells, so that s_k = 2 G_k dev eps(d_k) with a
// displacement d_k' = u' - d_k / t_k: the history of a branch is a vector of the body.
struct MaxwellBranch
{
  double time = 0;            // t_k [s]
  std::vector<double> moduli; // G_k(num_cells) [Pa]
};

// The same materials with G_inf as shear modulus, (num_cells).
std::vector<Material> longTerm(std::vector<Material> materials,
                               std::vector<MaxwellBranch> const& branches);

// The materials of the branch, which have its shear moduli alone, (num_cells).
std::vector<Material> materialsOf(MaxwellBranch const& branch);
} // namespace asperity::fem
