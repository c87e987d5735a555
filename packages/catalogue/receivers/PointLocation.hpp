#pragma once

#include "catalogue/receivers/ElementTree.hpp"
#include "io/FieldRegistry.hpp"
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

// Finds points in a domain, which must not be empty and must outlive this object.
class PointLocation
{
public:
  explicit PointLocation(io::OutputDomain const& domain);

  // points: (num_points, dimension) [m], the same on every rank, as is the result. A point between
  // elements belongs to that with the least node numbers, on any number of ranks. Collective.
  std::vector<LocatedPoint> operator()(std::vector<double> const& points) const;

  // The same, but in the element that is nearest to the corresponding point of `searched`: on a
  // fault inside the body, whose two sides lie at one place, that point says on which side.
  // Collective.
  std::vector<LocatedPoint> operator()(std::vector<double> const& points,
                                       std::vector<double> const& searched) const;

private:
  LocatedPoint nearestOfRank(double const* point, std::size_t& nearest_element) const;
  void locateBatch(double const* points, double const* searched, std::size_t size,
                   std::vector<LocatedPoint>& result) const;

  io::OutputDomain const& domain_;
  ElementTree tree_;
  double largest_element_ = 0; // [m]
};

// With a PointLocation made for these points alone.
std::vector<LocatedPoint> locate(io::OutputDomain const& domain, std::vector<double> const& points);

// The size of the smallest element [m], over all ranks: its longest edge or, of a triangle in
// space, the leg of a right one of the same area. Collective.
double shortestElement(io::OutputDomain const& domain);

// Values of a field at located points: linear between nodes, or those of the elements.
class Sampling
{
public:
  Sampling(io::OutputDomain const& domain, std::vector<LocatedPoint> const& points,
           io::Centring centring = io::Centring::nodes);

  // The owned nodes, or elements, whose values count, ascending.
  std::vector<std::size_t> const& places() const { return places_; }

  // all: (num_owned, components) of this rank, or (num_owned_elements, components);
  // (num_points, components) on every rank. Collective.
  std::vector<double> operator()(std::vector<double> const& all, int components) const;
  // The same from values at the places alone, (places, components).
  std::vector<double> fromPlaces(std::vector<double> const& values, int components) const;

private:
  struct Term
  {
    std::size_t point, place; // a place among places_
    double weight;
  };
  RCP<const Communicator> comm_;
  std::size_t num_points_;
  std::vector<std::size_t> places_;
  std::vector<Term> terms_;
};
} // namespace asperity::catalogue
