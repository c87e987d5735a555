#pragma once

#include "arrangement/complex/Complex.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// The body: between four walls, the bottom and the ground.
struct Box
{
  Point<3> low{}, high{}; // [m]; high[2] is the height of a flat ground
};

// All surfaces of a model; their numbers follow this order: faults, ground, west, east, south,
// north, bottom.
struct Model
{
  std::vector<NamedSurface> surfaces;
  int num_faults = 0;
  Box box;

  bool isFault(int surface) const { return surface < num_faults; }
  int ground() const { return num_faults; }
  bool isGround(int surface) const { return surface == num_faults; }
  std::string const& name(int surface) const { return surfaces[surface].name; }
};

struct BoxNames
{
  std::string west = "west", east = "east", south = "south", north = "north", bottom = "bottom",
              ground = "ground";
};

// An empty `ground` means a flat one. Walls extend above the ground, and the ground beyond the
// walls; these parts are removed after the arrangement (keepBody).
Model makeModel(std::vector<NamedSurface> faults, TriangleSurface ground, Box const& box,
                BoxNames const& names);
} // namespace asperity::geometry
