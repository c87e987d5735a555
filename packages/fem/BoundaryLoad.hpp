#pragma once

#include "fem/constraints/NodalFrames.hpp"
#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace asperity::fem
{
// A traction on a boundary of the body [Pa].
struct BoundaryTraction
{
  // The traction at the place x [m], where the unit normal n points out of the body, and the time t
  // [s]: as many components as the displacement has, along the axes; z = 0 in x and n in two
  // dimensions.
  using Value = std::function<std::array<double, 3>(std::array<double, 3> const& x,
                                                    std::array<double, 3> const& n, double t)>;
  std::string boundary;
  Value value;
  bool depends_on_time = true;
};

// The load l_i = integral of phi_i T over boundaries with tractions T, by quadrature on each facet
// that is exact where T is linear. At a split vertex it acts on mean and jump (VertexTerms).
class BoundaryLoad
{
public:
  BoundaryLoad() = default;
  // Throws InputError on all ranks if the mesh lacks a boundary, or a traction cannot be evaluated
  // at t = 0. Collective.
  template <int Dim>
  BoundaryLoad(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
               std::vector<BoundaryTraction> const& tractions);

  bool isEmpty() const { return steady_.empty() && varying_.empty(); } // on this rank
  // load += the part that does not depend on time; that which does, at the time t [s].
  void addSteady(Vector& load) const;
  void addVarying(double t, Vector& load) const;

private:
  // The force at a dof per traction at a point.
  struct Share
  {
    int dof;
    std::array<double, 3> factors; // of the components along the axes
  };
  struct Point
  {
    std::array<double, 3> x, n;
    BoundaryTraction::Value value;
    std::vector<Share> shares;
  };
  static void add(std::vector<Point> const& points, double t, Vector& load);

  std::vector<Point> steady_, varying_;
};
} // namespace asperity::fem
