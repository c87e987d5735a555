#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Mesh`.
RCP<const ParameterList> meshParameters();

// Names of its entries, for messages.
namespace mesh_entries
{
inline constexpr char const* file = "File"; // a value of `Type`, with its list
inline constexpr char const* file_name = "File Name";
inline constexpr char const* most_vertices = "Most Vertices";
inline constexpr char const* refinements = "Refinements";
inline constexpr char const* flat_cells = "Flat Cells Beside";
inline constexpr char const* regions = "Regions";
inline constexpr char const* boundaries = "Boundaries";
inline constexpr char const* faults = "Faults";
} // namespace mesh_entries

// The entries of the list. What only the mesh can evaluate stays a list: conditions in x, y and z.
struct MeshSettings
{
  std::string type = "Wedge";
  int most_vertices = 500000;
  int num_refinements = 0;
  std::optional<std::vector<std::string>> flat_cells; // names of boundaries or faults
  double flat_height = 0.3;                           // of the first layer [-]
  std::string file_name;                              // where isInFile()
  ParameterList shape;                                // the list of the type
  ParameterList regions, boundaries, faults;

  // `list` must be complete.
  static MeshSettings from(ParameterList const& list);

  bool isInFile() const; // else the mesh is one of generatedMeshes()
};
} // namespace asperity::scenario
