#pragma once

#include "base/Views.hpp"
#include "fem/VolumetricPatches.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/bulk/MaxwellBranch.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::fem
{
// The components of symmetric tensors, for a displacement of 1 (antiplane), 2 or 3 components:
//   1: xz, yz    2: xx, xy, yy, zz    3: xx, xy, xz, yy, yz, zz, the order of XDMF's Tensor6.
std::vector<std::string> const& tensorComponents(int displacement_components);

namespace detail
{
// The patches of cells, by their vertices: b [1/m] is that of meanStrainForm along the axes.
template <int Dim>
struct PatchesOfCells
{
  template <class Value>
  using View = Kokkos::View<Value, MemorySpace>;

  View<const int*> patch_of_cell;   // (cells) number of the patch, or -1; empty without patches
  View<const int*> entries_begin;   // (patches + 1)
  View<const int*> vertices;        // (entries) places in CellStress::vertices()
  View<const double* [Dim]> slopes; // (entries, Dim)
  View<const double*> moduli;       // (patches) k_P [Pa]
};
} // namespace detail

// Strain and stress of P1 elements, constant in each cell, along the axes, positive in tension:
//   eps(u) = (grad u + grad u^T) / 2,   sigma = B : eps(u) + A : eps(v)   (Material)
// where the stress of Maxwell branches comes from their own displacements (MaxwellBranch), and that
// of volume also from the mean volumetric strain of a patch (VolumetricPatches).
template <int Dim>
class CellStress
{
public:
  // The stress in these local cells; materials(num cells of the mesh). components: of the
  // displacement.
  CellStress(Mesh<Dim> const& mesh, int components, std::vector<Material> const& materials,
             std::vector<int> const& cells, std::vector<MaxwellBranch> const& branches = {},
             VolumetricPatches const& patches = {});

  // The local vertices of the cells and their patches, ascending, ghosts among them. u and v below
  // are displacement [m] and velocity [m/s] there, (vertices, components), along the axes.
  std::vector<int> const& vertices() const { return vertices_; }
  bool isViscous() const { return is_viscous_; } // on any of this rank's cells

  // (cells, tensor components), in the order of the cells. v may be empty where nothing is viscous;
  // d(num_branches): displacements of the Maxwell branches.
  std::vector<double> strain(std::vector<double> const& u) const; // [-]
  std::vector<double> stress(std::vector<double> const& u, std::vector<double> const& v,
                             std::vector<std::vector<double>> const& d = {}) const; // [Pa]

private:
  int components_;
  std::vector<int> vertices_;
  bool is_viscous_ = false;
  Kokkos::View<const int * [Dim + 1], MemorySpace> corners_;           // places in vertices_
  Kokkos::View<const double * [Dim + 1][Dim], MemorySpace> gradients_; // 1/m
  Kokkos::View<const Material*, MemorySpace> materials_;               // without branches
  std::vector<Kokkos::View<const Material*, MemorySpace>> branches_;   // their shear moduli alone
  detail::PatchesOfCells<Dim> patches_;
};

// Takes the stress of an inelastic strain [-] in cells of these materials from `stress` [Pa]; both
// (cells, tensor components).
void subtractStress(std::vector<Material> const& materials, std::vector<double> const& strain,
                    std::vector<double>& stress);
} // namespace asperity::fem
