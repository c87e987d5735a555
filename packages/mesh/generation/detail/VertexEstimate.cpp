#include "mesh/generation/detail/VertexEstimate.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <limits>

namespace asperity::mesh::detail
{
namespace
{
// The measure of a regular simplex, which is the largest simplex of this diameter.
template <int Dim>
double largestMeasure(double diameter)
{
  return Dim == 2 ? 0.25 * std::sqrt(3.0) * diameter * diameter
                  : diameter * diameter * diameter / (6.0 * std::sqrt(2.0));
}

// A lower estimate of the number of vertices that a cell gets: none of its parts is larger than a
// regular simplex of the largest diameter allowed at its corners, and a mesh has about two cells
// for each vertex in 2D and seven in 3D. Where the allowed diameter varies much, the estimates of
// the two halves of the cell are added.
template <int Dim>
double fewestInCell(std::array<Point<Dim>, Dim + 1> const& cell,
                    SizeFunction<Dim> const& largest_diameter, int depth)
{
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0, longest = 0.0;
  int first = 0, second = 0; // of the longest edge
  for (int i = 0; i <= Dim; ++i) {
    std::array<Point<Dim>, Dim + 1> corner;
    corner.fill(cell[i]);
    const double allowed = largest_diameter(corner);
    smallest = std::min(smallest, allowed);
    largest = std::max(largest, allowed);
    for (int j = 0; j < i; ++j) {
      const double length = distance<Dim>(cell[i], cell[j]);
      if (length > longest) {
        longest = length;
        first = i;
        second = j;
      }
    }
  }
  if (depth == 0 || largest <= 2.0 * smallest) {
    constexpr double cells_per_vertex = Dim == 2 ? 2.0 : 7.0;
    return std::abs(signedMeasure(cell)) / largestMeasure<Dim>(largest) / cells_per_vertex;
  }
  double sum = 0.0;
  const auto middle = centroid(std::array<Point<Dim>, 2>{cell[first], cell[second]});
  for (int end : {first, second}) {
    auto half = cell;
    half[end] = middle;
    sum += fewestInCell<Dim>(half, largest_diameter, depth - 1);
  }
  return sum;
}
} // namespace

template <int Dim>
double fewestVertices(GlobalMesh<Dim> const& mesh, SizeFunction<Dim> const& largest_diameter)
{
  constexpr int depth = 12;
  double sum = 0.0;
  for (auto const& cell : mesh.cells) {
    sum += fewestInCell<Dim>(corners(mesh, cell), largest_diameter, depth);
  }
  return sum;
}

template double fewestVertices<2>(GlobalMesh<2> const&, SizeFunction<2> const&);
template double fewestVertices<3>(GlobalMesh<3> const&, SizeFunction<3> const&);
} // namespace asperity::mesh::detail
