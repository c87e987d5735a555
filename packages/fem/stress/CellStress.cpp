#include "fem/stress/CellStress.hpp"

#include "base/Errors.hpp"
#include "fem/Simplex.hpp"
#include "fem/bulk/TensorKernels.hpp"
#include "fem/detail/PatchViews.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace asperity::fem
{
namespace
{
template <int Dim, int Components>
struct CellKernel
{
  using Result =
    Kokkos::View<double * [numTensorComponents(Components)], Kokkos::LayoutRight, MemorySpace>;
  using Motion = Kokkos::View<const double*, MemorySpace>; // (vertices, Components)

  Kokkos::View<const int * [Dim + 1], MemorySpace> corners;
  Kokkos::View<const double * [Dim + 1][Dim], MemorySpace> gradients;
  Kokkos::View<const Material*, MemorySpace> materials;
  Motion u, v; // v: empty without viscosity
  bool is_strain;
  detail::PatchesOfCells<Dim> patches;
  Result result;

  KOKKOS_FUNCTION Gradient<Dim, Components> gradientOf(Motion const& motion, int cell) const
  {
    Gradient<Dim, Components> gradient;
    for (int corner = 0; corner <= Dim; ++corner) {
      for (int i = 0; i < Components; ++i) {
        for (int k = 0; k < Dim; ++k) {
          gradient.entry[i][k] +=
            motion(corners(cell, corner) * Components + i) * gradients(cell, corner, k);
        }
      }
    }
    return gradient;
  }

  // k_P t_P of the displacement in the patch of a cell.
  KOKKOS_FUNCTION double stressOfPatch(int cell) const
  {
    const int patch = patches.patch_of_cell.extent(0) > 0 ? patches.patch_of_cell(cell) : -1;
    if (patch < 0) {
      return 0;
    }
    double mean = 0;
    for (int e = patches.entries_begin(patch); e < patches.entries_begin(patch + 1); ++e) {
      for (int axis = 0; axis < Components; ++axis) {
        mean += patches.slopes(e, axis) * u(patches.vertices(e) * Components + axis);
      }
    }
    return patches.moduli(patch) * mean;
  }

  KOKKOS_FUNCTION void operator()(int cell) const
  {
    double tensor[numTensorComponents(Components)] = {};
    auto const of_displacement = gradientOf(u, cell);
    if (is_strain) {
      of_displacement.strain(tensor);
    } else {
      auto const& m = materials(cell);
      of_displacement.add(m.bulk_modulus - 2. / 3 * m.shear_modulus, m.shear_modulus, tensor);
      const double of_patch = stressOfPatch(cell);
      for (int k = 0; k < numTensorComponents(Components); ++k) {
        tensor[k] += isOnDiagonal(numTensorComponents(Components), k) ? of_patch : 0;
      }
      if (v.extent(0) > 0) {
        gradientOf(v, cell).add(m.bulk_viscosity - 2. / 3 * m.shear_viscosity, m.shear_viscosity,
                                tensor);
      }
    }
    for (int k = 0; k < numTensorComponents(Components); ++k) {
      result(cell, k) = tensor[k];
    }
  }

  std::vector<double> run() &&
  {
    const auto cells = static_cast<int>(corners.extent(0));
    result = Result("asperity::fem::cellTensors", cells);
    Kokkos::parallel_for("asperity::fem::cellTensors", RangePolicy(0, cells), *this);
    auto const host = toHost(result);
    return {host.data(), host.data() + host.size()};
  }
};

template <int Dim, int Components, class Corners, class Gradients, class Materials>
std::vector<double> tensors(Corners const& corners, Gradients const& gradients,
                            Materials const& materials, std::vector<double> const& u,
                            std::vector<double> const& v, bool is_strain,
                            detail::PatchesOfCells<Dim> const& patches = {})
{
  return CellKernel<Dim, Components>{corners,
                                     gradients,
                                     materials,
                                     toDevice(u, "asperity::fem::displacement"),
                                     toDevice(v, "asperity::fem::velocity"),
                                     is_strain,
                                     patches,
                                     {}}
    .run();
}

// With the number of components at run time.
template <int Dim, class... Arguments>
std::vector<double> tensors(int components, Arguments const&... arguments)
{
  if constexpr (Dim == 2) {
    if (components == 1) {
      return tensors<2, 1>(arguments...);
    }
  }
  return tensors<Dim, Dim>(arguments...);
}
// The patches of `cells`, whose vertices are among `vertices`, ascending.
template <int Dim>
detail::PatchesOfCells<Dim> patchesOf(Mesh<Dim> const& mesh, std::vector<int> const& cells,
                                      std::vector<int> const& vertices,
                                      VolumetricPatches const& patches)
{
  std::map<int, int> numbers; // of patches
  std::vector<int> of_cell, begin = {0}, places;
  std::vector<Point<Dim>> slopes;
  std::vector<double> moduli;
  const NodalFrames along_axes(static_cast<int>(mesh.vertices.size()), Dim);
  for (const int cell : cells) {
    const int patch = patches.patch_of_cell[cell];
    if (patch < 0) {
      of_cell.push_back(-1);
      continue;
    }
    auto const [entry, is_new] = numbers.emplace(patch, static_cast<int>(moduli.size()));
    of_cell.push_back(entry->second);
    if (is_new) {
      moduli.push_back(patches.patches[patch].modulus);
      for (auto const& [vertex, slope] :
           detail::meanStrainForm(patches.patches[patch], mesh, along_axes)) {
        places.push_back(static_cast<int>(
          std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin()));
        slopes.push_back(slope);
      }
      begin.push_back(static_cast<int>(places.size()));
    }
  }
  return {toDevice(of_cell, "asperity::fem::patchOfCell"),
          toDevice(begin, "asperity::fem::entriesOfPatches"),
          toDevice(places, "asperity::fem::verticesOfPatches"), detail::slopesOnDevice<Dim>(slopes),
          toDevice(moduli, "asperity::fem::moduliOfPatches")};
}
} // namespace

std::vector<std::string> const& tensorComponents(int displacement_components)
{
  static const std::array<std::vector<std::string>, 3> names = {
    {{"xz", "yz"}, {"xx", "xy", "yy", "zz"}, {"xx", "xy", "xz", "yy", "yz", "zz"}}};
  ASPERITY_ASSERT(displacement_components >= 1 && displacement_components <= 3);
  return names[displacement_components - 1];
}

template <int Dim>
CellStress<Dim>::CellStress(Mesh<Dim> const& mesh, int components,
                            std::vector<Material> const& materials, std::vector<int> const& cells,
                            std::vector<MaxwellBranch> const& branches,
                            VolumetricPatches const& patches)
    : components_(components)
{
  ASPERITY_ASSERT(materials.size() == mesh.cells.size());
  for (int cell : cells) {
    vertices_.insert(vertices_.end(), mesh.cells[cell].begin(), mesh.cells[cell].end());
    if (!patches.empty() && patches.patch_of_cell[cell] >= 0) {
      for (const int other : patches.patches[patches.patch_of_cell[cell]].cells) {
        vertices_.insert(vertices_.end(), mesh.cells[other].begin(), mesh.cells[other].end());
      }
    }
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());

  const Kokkos::View<int * [Dim + 1], MemorySpace> corners("asperity::fem::corners", cells.size());
  const Kokkos::View<double * [Dim + 1][Dim], MemorySpace> gradients("asperity::fem::gradients",
                                                                     cells.size());
  auto const host_corners = Kokkos::create_mirror_view(corners);
  auto const host_gradients = Kokkos::create_mirror_view(gradients);
  auto const elastic = patches.ownMaterials(longTerm(materials, branches));
  std::vector<Material> of_cells;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    auto const simplex = simplexOf(mesh, cells[c]);
    for (int corner = 0; corner <= Dim; ++corner) {
      const int vertex = mesh.cells[cells[c]][corner];
      host_corners(c, corner) = static_cast<int>(
        std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin());
      for (int k = 0; k < Dim; ++k) {
        host_gradients(c, corner, k) = simplex.gradients[corner][k];
      }
    }
    of_cells.push_back(elastic[cells[c]]);
    is_viscous_ =
      is_viscous_ || of_cells.back().shear_viscosity > 0 || of_cells.back().bulk_viscosity > 0;
  }
  Kokkos::deep_copy(corners, host_corners);
  Kokkos::deep_copy(gradients, host_gradients);
  if (!patches.empty()) {
    patches_ = patchesOf(mesh, cells, vertices_, patches);
  }
  corners_ = corners;
  gradients_ = gradients;
  materials_ = toDevice(of_cells, "asperity::fem::materialsOfCells");
  for (auto const& branch : branches) {
    auto const of_branch = materialsOf(branch);
    std::transform(cells.begin(), cells.end(), of_cells.begin(),
                   [&](int cell) { return of_branch[cell]; });
    branches_.push_back(toDevice(of_cells, "asperity::fem::branchOfCells"));
  }
}

template <int Dim>
std::vector<double> CellStress<Dim>::strain(std::vector<double> const& u) const
{
  ASPERITY_ASSERT(u.size() == vertices_.size() * components_);
  return tensors<Dim>(components_, corners_, gradients_, materials_, u, std::vector<double>(),
                      true);
}

template <int Dim>
std::vector<double> CellStress<Dim>::stress(std::vector<double> const& u,
                                            std::vector<double> const& v,
                                            std::vector<std::vector<double>> const& d) const
{
  ASPERITY_ASSERT(u.size() == vertices_.size() * components_ &&
                  (v.size() == u.size() || (v.empty() && !is_viscous_)) &&
                  d.size() == branches_.size());
  auto result = tensors<Dim>(components_, corners_, gradients_, materials_, u, v, false, patches_);
  for (std::size_t k = 0; k < d.size(); ++k) {
    auto const of_branch = tensors<Dim>(components_, corners_, gradients_, branches_[k], d[k],
                                        std::vector<double>(), false);
    std::transform(result.begin(), result.end(), of_branch.begin(), result.begin(),
                   std::plus<double>());
  }
  return result;
}

void subtractStress(std::vector<Material> const& materials, std::vector<double> const& strain,
                    std::vector<double>& stress)
{
  if (materials.empty()) {
    return;
  }
  const auto size = static_cast<int>(strain.size() / materials.size());
  for (std::size_t cell = 0; cell < materials.size(); ++cell) {
    auto const& m = materials[cell];
    double const* const of_cell = &strain[cell * size];
    double trace = 0;
    for (int k = 0; k < size; ++k) {
      trace += isOnDiagonal(size, k) ? of_cell[k] : 0;
    }
    const double of_volume = (m.bulk_modulus - 2. / 3 * m.shear_modulus) * trace;
    for (int k = 0; k < size; ++k) {
      stress[cell * size + k] -=
        2 * m.shear_modulus * of_cell[k] + (isOnDiagonal(size, k) ? of_volume : 0);
    }
  }
}

template class CellStress<2>;
template class CellStress<3>;
} // namespace asperity::fem
