#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include "base/Errors.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/mesh/Generators.hpp"
#include "scenario/setup/mesh/MeshSettings.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
namespace
{
// In the order of the list of parameters. The dimension of a type is that of the list in which it
// stands.
template <int Dim>
std::vector<Generator<Dim>> generators()
{
  if constexpr (Dim == 2) {
    return {wedgeGenerator(), rectangleGenerator()};
  } else {
    return {deepWedgeGenerator(), boxGenerator()};
  }
}

// The limit of a mesh of the type, with the advice for a mesh that is too large.
mesh::VertexLimit vertexLimit(GeneratedMesh const& type, int most_vertices)
{
  return {static_cast<double>(most_vertices),
          "Is one of the entries of " + joinPath(mesh_path, type.name) +
            " missing, or not in m: " + type.sizes + "? A larger mesh is made where " +
            joinPath(mesh_path, mesh_entries::most_vertices) + " allows it."};
}
} // namespace

std::vector<GeneratedMesh> generatedMeshes()
{
  std::vector<GeneratedMesh> types;
  const auto add = [&types](auto const& rows, int dimension) {
    for (GeneratedMesh type : rows) {
      type.dimension = dimension;
      types.push_back(type);
    }
  };
  add(generators<2>(), 2);
  add(generators<3>(), 3);
  return types;
}

std::optional<GeneratedMesh> generatedMesh(std::string const& type)
{
  auto const types = generatedMeshes();
  auto const found = std::find_if(types.begin(), types.end(),
                                  [&](GeneratedMesh const& each) { return each.name == type; });
  return found == types.end() ? std::nullopt : std::optional<GeneratedMesh>(*found);
}

template <int Dim>
GlobalMesh<Dim> generateMesh(ParameterList const& list, std::string const& type, int most_vertices)
{
  auto const rows = generators<Dim>();
  auto const chosen =
    std::find_if(rows.begin(), rows.end(), [&](auto const& row) { return row.name == type; });
  ASPERITY_ASSERT(chosen != rows.end());
  return chosen->make(list, vertexLimit(*chosen, most_vertices));
}

template GlobalMesh<2> generateMesh(ParameterList const&, std::string const&, int);
template GlobalMesh<3> generateMesh(ParameterList const&, std::string const&, int);
} // namespace asperity::scenario
