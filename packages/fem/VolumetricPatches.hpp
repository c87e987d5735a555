#pragma once

#include "fem/bulk/Material.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::fem
{
// Patches of cells that share a volumetric strain. Cells whose strain is constant have more
// constraints than unknowns where each has to keep its volume, and lock near a Poisson's ratio of
// 1/2. Patches around vertices are at most as many as vertices. The elastic energy of volume is
//   1/2 sum over cells |c| k_c t_c^2 + 1/2 sum over patches |P| k_P t_P^2
// with t_c = tr eps(u) in a cell c and its mean t_P over a patch P, the modulus k_c <= K that a
// cell has for itself, and the mean k_P of K - k_c over the patch. The stress of volume in c is
// k_c t_c + k_P t_P: with it the forces are the ordinary ones of the cells (selective reduced
// integration; Hughes 1980, with a part that is not reduced).
struct VolumetricPatches
{
  struct Patch
  {
    std::vector<int> cells; // ascending local numbers, at least two
    double measure;         // |P| [m^Dim]
    double modulus;         // k_P [Pa]
  };
  std::vector<Patch> patches;      // those of this rank's cells, complete
  std::vector<int> patch_of_cell;  // (num_cells) the cell's patch, or -1; empty without patches
  std::vector<double> own_modulus; // (num_cells) k_c [Pa]; empty without patches

  bool empty() const { return patches.empty(); }
  // With k_c as bulk modulus.
  std::vector<Material> ownMaterials(std::vector<Material> materials) const;
};

// What a cell has for itself: the bulk modulus that rock of this Poisson's ratio has, and no more.
// Below this ratio cells are as stiff for themselves as P1 cells are; -1: all is shared.
constexpr double own_poissons_ratio = 0.3;
double ownModulus(Material const& material, double own_ratio);

// The vertex around which each cell's patch would lie, (num_cells) local vertices: the least of its
// global ids, those at faults before others, so that patches there are large. The same on every
// rank. faults: names of boundaries. Collective.
template <int Dim>
std::vector<int> patchVertices(Mesh<Dim> const& mesh, std::vector<std::string> const& faults,
                               Communicator const& communicator);

// The patches of a mesh that has all cells of each (mesh::completeGroups). The cells of a patch
// have one vertex (patchVertices), one region, and moduli that differ by less than a factor of two.
// own_moduli(num_cells): K in cells that have no part in a patch.
template <int Dim>
VolumetricPatches makeVolumetricPatches(Mesh<Dim> const& mesh, std::vector<int> const& vertices,
                                        std::vector<Material> const& materials,
                                        std::vector<double> const& own_moduli);
} // namespace asperity::fem
