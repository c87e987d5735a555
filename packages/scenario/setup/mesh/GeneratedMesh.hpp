#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "parameters/Parameters.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// A value of the entry `Mesh / Type` for a body that is meshed here, as the rest of the program
// sees it. Generators.hpp has one for each, with the function that makes it.
struct GeneratedMesh
{
  std::string name;
  int dimension = 0; // of space
  RCP<const ParameterList> entries;
  std::string sizes; // those of its entries that decide on the number of vertices, for messages
  // A sentence that says how the cells beside a fault become lower, for the log.
  std::string lower_cells = lower_cells_beside;
  // Of wedges: the shape in the plane, by the list of the type. Empty of others.
  std::function<mesh::WedgeShape(ParameterList const&)> wedge_shape;

  static constexpr char const* lower_cells_beside =
    "'Mesh / Flat Cells Beside' makes them in meshes that are not periodic.";
};

// All of them, in the order of the list of parameters.
std::vector<GeneratedMesh> generatedMeshes();
// The one of this name; empty for a mesh from a file.
std::optional<GeneratedMesh> generatedMesh(std::string const& type);

// The whole mesh of the type that its list describes; Dim is the dimension of the type. Throws
// InputError if it would have more than most_vertices, or if the numbers of the list make no mesh.
template <int Dim>
GlobalMesh<Dim> generateMesh(ParameterList const& list, std::string const& type, int most_vertices);
} // namespace asperity::scenario
