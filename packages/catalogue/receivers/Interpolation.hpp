#pragma once

#include "catalogue/receivers/PointLocation.hpp"
#include "io/OutputDomain.hpp"

#include <string>
#include <vector>

namespace asperity::catalogue
{
// Interpolates nodal values of the run of --restart-from at the nodes of the new run's domain.
class Interpolation
{
public:
  using Values = std::vector<double>;

  // Refers to the domains; `run` is for messages.
  Interpolation(io::OutputDomain const& from, io::OutputDomain const& to, std::string const& run);

  // Where a fault cuts the bodies, nodes of its two sides lie at one place: these points, one for
  // each node of the new domain and close to it, say on which side it is.
  void searchAt(Values const& points) { searched_ = points; }

  // Fields of (num_owned, components) each, in the order of the nodes of the domains. All at once,
  // because finding the points costs most. InputError for a node that lies outside the other
  // domain. Collective.
  std::vector<Values> operator()(std::vector<Values> const& fields, int components) const;

private:
  std::vector<LocatedPoint> find(Values const& points, Values const& searched) const;

  io::OutputDomain const& from_;
  io::OutputDomain const& to_;
  PointLocation location_;
  Values searched_;
  std::string run_;
};
} // namespace asperity::catalogue
