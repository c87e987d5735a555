#pragma once

#include "fem/FaultPoints.hpp"
#include "fem/FaultSurface.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace asperity::fem
{
// A facet of a fault: a segment in two dimensions, with two corners, or a triangle with three.
struct FaultFacet
{
  std::array<int, 3> nodes{}; // of the corners: those of the surface first, then those of others
  std::array<std::array<double, 3>, 3> corners{}; // [m]; z = 0 in two dimensions
  double measure = 0;                             // length [m] or area [m^2]
};

// All faults of a surface as a mesh of its own, for what varies and flows along them: linear finite
// elements on its facets. What varies has a value at each node, distributed over the ranks as in
// FaultSurface; what flows has an unknown at each point (FaultPoints.hpp), so that it is continuous
// where faults cross or join, and what leaves one fault enters the others. The facets of a rank are
// all that touch its nodes, so that its rows of a matrix need no communication.
class FaultMesh
{
public:
  // Numbers of this rank by ids that are the same on all ranks. columns: those of `owned`, then
  // those of others.
  struct Numbering
  {
    RCP<const Map> owned, columns;
  };

  // facets: with the nodes of the columns, each of which has a point of the columns. Collective.
  FaultMesh(int num_corners, std::vector<FaultFacet> facets, Numbering nodes, Numbering points,
            std::vector<int> point_of_column);

  int numCorners() const { return num_corners_; } // of a facet
  std::vector<FaultFacet> const& facets() const { return facets_; }
  // The nodes of the surface, in its order.
  RCP<const Map> const& owned() const { return nodes_.owned; }
  FaultPoints const& points() const { return points_; }

  // K_ij = integral over the faults of c grad(phi_i) . grad(phi_j) at points, with the gradients
  // along the faults and c linear on each facet between its values at the nodes: c(num_nodes). Its
  // rows sum to zero. Collective.
  RCP<const CrsMatrix> stiffness(std::vector<double> const& c) const;

  // (num_nodes, 3) gradient along the fault of p(num_nodes), linear on each facet: the mean over
  // the facets of its fault at a node, weighted by their measures. Collective.
  std::vector<double> gradient(std::vector<double> const& p) const;

  // The point of the fault that is nearest to a place.
  struct Nearest
  {
    double distance;  // of the place [m], the same on all ranks
    double cell_size; // the longest edge of the facet there [m], the same on all ranks
    // Nodes of this rank with the values of their basis functions at the point; over all ranks they
    // sum to one.
    std::vector<std::pair<int, double>> shares;
  };
  Nearest nearest(std::array<double, 3> const& place) const; // collective

private:
  std::vector<double> withGhosts(std::vector<double> const& values) const;
  std::optional<std::size_t> chosen(std::vector<double> const& distances, double least) const;

  int num_corners_;
  std::vector<FaultFacet> facets_;
  Numbering nodes_, numbering_of_points_;
  std::vector<int> point_of_column_; // of a node
  FaultPoints points_;
};

// The facets of `surface`, which was made from this mesh. Collective.
template <int Dim>
std::shared_ptr<const FaultMesh> makeFaultMesh(Mesh<Dim> const& mesh, FaultSurface const& surface);
} // namespace asperity::fem
