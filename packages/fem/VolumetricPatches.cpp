#include "fem/VolumetricPatches.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Directory.hpp"
#include "fem/Simplex.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace asperity::fem
{
namespace
{
constexpr double rounding = 1e-12;

// 1 at local vertices of faults, else 0. A rank sees that of a ghost at its owner.
template <int Dim>
std::vector<GlobalOrdinal> areAtFaults(Mesh<Dim> const& mesh,
                                       std::vector<std::string> const& faults,
                                       Communicator const& communicator)
{
  std::vector<GlobalOrdinal> result(mesh.vertices.size(), 0);
  for (auto const& name : faults) {
    const auto found = mesh.boundaries.find(name);
    if (found != mesh.boundaries.end()) {
      for (auto const& facet : found->second) {
        for (const int v : facet) {
          result[v] = 1;
        }
      }
    }
  }
  for (auto const& pair : mesh.splits) {
    result[pair.plus] = result[pair.minus] = 1;
  }
  auto const middle = mesh.global_ids.begin() + mesh.num_owned;
  const std::vector<GlobalOrdinal> owned(mesh.global_ids.begin(), middle);
  const std::vector<GlobalOrdinal> ghosts(middle, mesh.global_ids.end());
  auto const of_ghosts =
    Directory(mesh.num_global_vertices, communicator)
      .valuesAt(ghosts, owned, {result.begin(), result.begin() + mesh.num_owned});
  std::copy(of_ghosts.begin(), of_ghosts.end(), result.begin() + mesh.num_owned);
  return result;
}

// A factor of two between two values gives another number.
int magnitude(double modulus) { return static_cast<int>(std::floor(std::log2(modulus))); }
} // namespace

std::vector<Material> VolumetricPatches::ownMaterials(std::vector<Material> materials) const
{
  for (std::size_t cell = 0; cell < own_modulus.size(); ++cell) {
    materials[cell].bulk_modulus = own_modulus[cell];
  }
  return materials;
}

double ownModulus(Material const& material, double own_ratio)
{
  const double most = 2 * material.shear_modulus * (1 + own_ratio) / (3 * (1 - 2 * own_ratio));
  return material.bulk_modulus <= (1 + rounding) * most ? material.bulk_modulus : most;
}

template <int Dim>
std::vector<int> patchVertices(Mesh<Dim> const& mesh, std::vector<std::string> const& faults,
                               Communicator const& communicator)
{
  auto const at_fault = areAtFaults(mesh, faults, communicator);
  auto const rank = [&](int v) {
    return std::make_pair(at_fault[v] == 1 ? 0 : 1, mesh.global_ids[v]);
  };
  std::vector<int> vertices;
  vertices.reserve(mesh.cells.size());
  for (auto const& cell : mesh.cells) {
    vertices.push_back(
      *std::min_element(cell.begin(), cell.end(), [&](int a, int b) { return rank(a) < rank(b); }));
  }
  return vertices;
}

template <int Dim>
VolumetricPatches makeVolumetricPatches(Mesh<Dim> const& mesh, std::vector<int> const& vertices,
                                        std::vector<Material> const& materials,
                                        std::vector<double> const& own_moduli)
{
  ASPERITY_ASSERT(vertices.size() == mesh.cells.size() && materials.size() == mesh.cells.size() &&
                  own_moduli.size() == mesh.cells.size());
  using Group =
    std::tuple<GlobalOrdinal, int, int, int>; // vertex, region, magnitudes of the moduli
  std::map<Group, std::vector<int>> groups;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    auto const& m = materials[cell];
    if (own_moduli[cell] < m.bulk_modulus) {
      groups[{mesh.global_ids[vertices[cell]], mesh.cell_regions[cell], magnitude(m.shear_modulus),
              magnitude(m.bulk_modulus)}]
        .push_back(static_cast<int>(cell));
    }
  }
  VolumetricPatches result;
  for (auto& entry : groups) {
    auto& cells = entry.second;
    if (cells.size() == 1) { // its mean is its own
      continue;
    }
    if (result.empty()) {
      result.patch_of_cell.assign(mesh.cells.size(), -1);
      for (auto const& m : materials) {
        result.own_modulus.push_back(m.bulk_modulus);
      }
    }
    double measure = 0, shared = 0;
    for (const int cell : cells) {
      const double of_cell = simplexOf(mesh, cell).measure;
      measure += of_cell;
      shared += of_cell * (materials[cell].bulk_modulus - own_moduli[cell]);
      result.patch_of_cell[cell] = static_cast<int>(result.patches.size());
      result.own_modulus[cell] = own_moduli[cell];
    }
    result.patches.push_back({std::move(cells), measure, shared / measure});
  }
  return result;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<int> patchVertices(Mesh<Dim> const&, std::vector<std::string> const&,       \
                                          Communicator const&);                                    \
  template VolumetricPatches makeVolumetricPatches(Mesh<Dim> const&, std::vector<int> const&,      \
                                                   std::vector<Material> const&,                   \
                                                   std::vector<double> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
