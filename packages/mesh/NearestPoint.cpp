#include "mesh/NearestPoint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::mesh
{
double Simplex::dot(int i, int j) const
{
  double sum = 0;
  for (int d = 0; d < dimension; ++d) {
    sum += edge(i, d) * edge(j, d);
  }
  return sum;
}

double Simplex::longestEdge() const
{
  double largest = 0;
  for (int i = 0; i <= numEdges(); ++i) {
    for (int j = 0; j < i; ++j) {
      largest = std::max(largest, dot(i, i) - 2 * dot(i, j) + dot(j, j));
    }
  }
  return std::sqrt(largest);
}

double distance(double const* left, double const* right, int dimension)
{
  double square = 0;
  for (int d = 0; d < dimension; ++d) {
    square += (left[d] - right[d]) * (left[d] - right[d]);
  }
  return std::sqrt(square);
}

namespace
{
// Solves the symmetric positive definite system of n <= 3 unknowns; the solution replaces b.
void solve(std::array<std::array<double, 3>, 3> A, std::array<double, 3>& b, int n)
{
  for (int k = 0; k < n; ++k) {
    for (int i = k + 1; i < n; ++i) {
      const double factor = A[i][k] / A[k][k];
      for (int j = k; j < n; ++j) {
        A[i][j] -= factor * A[k][j];
      }
      b[i] -= factor * b[k];
    }
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int j = i + 1; j < n; ++j) {
      b[i] -= A[i][j] * b[j];
    }
    b[i] /= A[i][i];
  }
}

// Barycentric coordinates of the orthogonal projection of the point to the plane of the simplex.
std::vector<double> barycentric(Simplex const& simplex, double const* point)
{
  const int n = simplex.numEdges();
  std::array<std::array<double, 3>, 3> gram{};
  std::array<double, 3> weights{};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      gram[i][j] = simplex.dot(i + 1, j + 1);
    }
    for (int d = 0; d < simplex.dimension; ++d) {
      weights[i] += simplex.edge(i + 1, d) * (point[d] - simplex.corners[0][d]);
    }
  }
  solve(gram, weights, n);
  std::vector<double> result{1};
  for (int i = 0; i < n; ++i) {
    result[0] -= weights[i];
    result.push_back(weights[i]);
  }
  return result;
}
} // namespace

// The projection, if it is inside; else the nearest point of the faces that are opposite to corners
// with a negative barycentric coordinate.
NearestPoint nearestPoint(Simplex const& simplex, double const* point)
{
  constexpr double rounding = 1e-12; // a point at a node has that node's value
  NearestPoint nearest{barycentric(simplex, point), std::numeric_limits<double>::infinity()};
  auto const weights = nearest.weights;
  for (std::size_t corner = 0; corner < weights.size(); ++corner) {
    if (weights[corner] < rounding && simplex.numEdges() > 0) {
      Simplex face = simplex;
      face.corners.erase(face.corners.begin() + static_cast<std::ptrdiff_t>(corner));
      NearestPoint candidate = nearestPoint(face, point);
      if (candidate.distance < nearest.distance) {
        candidate.weights.insert(candidate.weights.begin() + static_cast<std::ptrdiff_t>(corner),
                                 0);
        nearest = std::move(candidate);
      }
    }
  }
  if (std::isfinite(nearest.distance)) {
    return nearest;
  }
  std::vector<double> place(simplex.dimension, 0);
  for (std::size_t corner = 0; corner < weights.size(); ++corner) {
    for (int d = 0; d < simplex.dimension; ++d) {
      place[d] += weights[corner] * simplex.corners[corner][d];
    }
  }
  nearest.distance = distance(place.data(), point, simplex.dimension);
  return nearest;
}
} // namespace asperity::mesh
