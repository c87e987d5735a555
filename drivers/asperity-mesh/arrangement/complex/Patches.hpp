#pragma once

#include "arrangement/complex/Complex.hpp"

#include <vector>

namespace asperity::geometry
{
// A connected part of one surface between lines where it meets others or ends.
struct Patch
{
  int surface = 0;
  double area = 0;              // [m^2]
  int largest = 0;              // its largest triangle
  bool has_free_border = false; // an edge at which there is no other triangle
  bool meets_others = false;    // an edge at which there are triangles of another surface
};

struct Patches
{
  std::vector<Patch> list;
  std::vector<int> patch_of_triangle; // (num_triangles)
};

// Triangles are in one patch if they are the only two at an edge, and of one surface.
Patches findPatches(Complex const& complex);
} // namespace asperity::geometry
