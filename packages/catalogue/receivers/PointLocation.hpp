#pragma once

#include "io/OutputDomain.hpp"

#include <vector>

namespace asperity::catalogue
{
// The point of a domain that is nearest to a given one.
struct LocatedPoint
{
  double distance = 0;              // [m] between the two
  double element_size = 0;          // [m] longest edge of the element
  std::vector<GlobalOrdinal> nodes; // (nodes_per_element) numbers within the domain
  std::vector<double> weights;      // (nodes_per_element) barycentric, >= 0, sum 1
  std::vector<double> coordinates;  // (dimension) [m] of the point of the domain
};

// points: (num_points, dimension) [m], the same on every rank, as is the result. A point between
// elements belongs to that with the least node numbers, on any number of ranks. The domain may
// not be empty. Collective.
std::vector<LocatedPoint> locate(io::OutputDomain const& domain, std::vector<double> const& points);

// The size of the smallest element [m], over all ranks: its longest edge or, of a triangle in
// space, the leg of a right one of the same area. Collective.
double shortestElement(io::OutputDomain const& domain);

// Linear interpolation of nodal values at located points.
class Sampling
{
public:
  Sampling(io::OutputDomain const& domain, std::vector<LocatedPoint> const& points);

  // nodal: (num_owned, components) of this rank; (num_points, components) on every rank.
  // Collective.
  std::vector<double> operator()(std::vector<double> const& nodal, int components) const;

private:
  struct Term
  {
    std::size_t point, node; // an owned node
    double weight;
  };
  RCP<const Communicator> comm_;
  std::size_t num_points_;
  std::vector<Term> terms_;
};
} // namespace asperity::catalogue
