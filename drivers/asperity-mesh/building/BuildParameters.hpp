#pragma once

#include "arrangement/complex/Box.hpp"

#include "parameters/fields/Field.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// What a deck of `asperity-mesh build` says.
struct BuildSettings
{
  Model model;                       // surfaces as given, checked
  std::vector<Field> sizes;          // of cells at each fault [m]
  double growth = 0;                 // of the size of cells, for each metre of distance
  double largest = 0;                // size of cells [m]
  double snap = 0;                   // [m]
  double stub_share = 0;             // of the area of a fault
  double short_share = 0;            // of the size of cells
  bool is_y_up = false;              // the mesh gets x to the east, y up and z to the south
  std::string deck;                  // of asperity that is to use the mesh; "" for none
  std::vector<std::string> overlays; // laid over that deck, in their order (--overlay)
  std::vector<std::string> remarks;  // on faults that were divided
  std::optional<double> tolerance;   // [m], of the distance of facets from the given surface
};

// The valid parameters of the root list `Asperity`.
Teuchos::RCP<const ParameterList> buildParameters();

// Reads the files that the list names; those with relative names from `folder`. `list` gets the
// defaults. InputError, with path or file, if something is wrong.
BuildSettings readBuildSettings(ParameterList& list, std::string const& folder);
} // namespace asperity::geometry
