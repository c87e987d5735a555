#pragma once

#include <vector>

namespace asperity::mesh
{
// Some corners of an element; all of them, or those of a face.
struct Simplex
{
  std::vector<double const*> corners; // (dimension) each [m]
  int dimension;

  int numEdges() const { return static_cast<int>(corners.size()) - 1; }
  double edge(int corner, int d) const { return corners[corner][d] - corners[0][d]; }
  double dot(int i, int j) const; // of the edges from corner 0
  double longestEdge() const;     // [m]
};

double distance(double const* left, double const* right, int dimension);

// The point of a simplex that is nearest to a given one.
struct NearestPoint
{
  std::vector<double> weights; // barycentric, >= 0, sum 1
  double distance;             // [m]
};
NearestPoint nearestPoint(Simplex const& simplex, double const* point);
} // namespace asperity::mesh
