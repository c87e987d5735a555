#pragma once

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

// A fault as a mesh of its own, for what varies and flows along it: linear finite elements on its
// facets, whose unknowns are its nodes, distributed over the ranks as in FaultSurface. The facets
// of a rank are all that touch its nodes, so that its rows of a matrix need no communication.
class FaultMesh
{
public:
  // facets: with the nodes of the columns. columns: the nodes of `owned`, then those of others.
  FaultMesh(int num_corners, std::vector<FaultFacet> facets, RCP<const Map> const& owned,
            RCP<const Map> const& columns);

  int numCorners() const { return num_corners_; } // of a facet
  std::vector<FaultFacet> const& facets() const { return facets_; }
  RCP<const Map> const& owned() const { return owned_; } // the nodes of the surface, in its order

  // K_ij = integral over the fault of c grad(phi_i) . grad(phi_j), with the gradients along it and
  // c linear between its values at the nodes: c(num_nodes). Its rows sum to zero. Collective.
  RCP<const CrsMatrix> stiffness(std::vector<double> const& c) const;

  // (num_nodes, 3) gradient along the fault of p(num_nodes), linear on each facet: the mean over
  // the facets at a node, weighted by their measures. Collective.
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
  RCP<const Map> owned_, columns_;
};

// The facets of `surface`, which was made from this mesh. Collective.
template <int Dim>
std::shared_ptr<const FaultMesh> makeFaultMesh(Mesh<Dim> const& mesh, FaultSurface const& surface);
} // namespace asperity::fem
