#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "meshing/CellSize.hpp"

#include <vector>

namespace asperity::geometry
{
// Sample points of surfaces, about three cells apart.
struct Samples
{
  std::vector<Point<3>> places;
  std::vector<double> areas; // that each stands for [m^2]
};
void addSamples(Samples& samples, Complex const& complex, Triangle const& triangle,
                CellSize const& size);

// The area of a facet of cells of this size [m]: of an equilateral triangle with this side [m^2].
double facetArea(double size);

// Expected numbers of a mesh that is not made yet.
struct CellEstimate
{
  double cells = 0, vertices = 0;
  double fault_facets = 0;
};

// From the integral of 1 / size^3 over the body, under a flat ground of its mean height, and of
// 1 / size^2 over the faults; accurate to a factor of `estimate_factor`
// (docs/first_model/your_fault.md has measured ones).
CellEstimate expectedCells(Complex const& complex, Model const& model, CellSize const& size);
constexpr double estimate_factor = 1.5;
} // namespace asperity::geometry
