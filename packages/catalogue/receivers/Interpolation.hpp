#pragma once

#include "catalogue/receivers/PointLocation.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"

#include <string>
#include <vector>

namespace asperity::catalogue
{
// Values of the run of --restart-from at points of the new run, different ones on each rank.
class Interpolation
{
public:
  using Values = std::vector<double>;

  // Refers to the domain of the other run; points: (num_points, dimension) [m]; `run` is for
  // messages.
  Interpolation(io::OutputDomain const& from, Values points, std::string const& run);

  // Where a fault cuts the bodies, nodes of its two sides lie at one place. `searched` has a point
  // for each of `points`, close to it and inside a cell of its side: the value is that of the side.
  Interpolation(io::OutputDomain const& from, Values points, Values searched,
                std::string const& run);

  // Fields of (num_owned, components) each, in the order of the nodes of the domain, linear between
  // them; or of (num_owned_elements, components), constant in each element. All at once, because
  // finding the points costs most. InputError for a point that lies outside the domain. Collective.
  std::vector<Values> operator()(std::vector<Values> const& fields, int components,
                                 io::Centring centring = io::Centring::nodes) const;

private:
  std::vector<LocatedPoint> find(Values const& points, Values const& searched) const;

  io::OutputDomain const& from_;
  PointLocation location_;
  Values points_, searched_;
  std::string run_;
};
} // namespace asperity::catalogue
