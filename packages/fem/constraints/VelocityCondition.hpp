#pragma once

#include "mesh/Mesh.hpp"

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// The kinds of condition on the velocity v of a boundary, and the list of them, VelocityCondition.
//
// n is the unit inward normal of the boundary at a node. A vector d along the axes has as many
// components as the displacement, and any length but zero. Each kind states its equation and has
//
//   normal        which normal n is: that of the boundary's own facets, that of a wall, or that of
//                 the fault. Where the fault ends at walls, its normal lies in their planes.
//   prescribes    whether the velocity along its direction is prescribed; otherwise that is free,
//                 and only the frames of the nodes follow the direction
//   holds_across  whether v . n = 0, so that the boundary bears a reaction across it
//   is_turned     whether its direction is a tangent that already has the sense of the condition's
//                 `turn`, so that the frame of a node must not be turned once more
//   velocity      the value that is prescribed, a function of x and t
//
// VelocityCondition.cpp adds the direction of each kind.
namespace asperity::fem
{
enum class Normal
{
  of_boundary,
  of_wall,
  of_fault
};

// A velocity [m/s] as a function of x and the time t [s]. With depends_on_time = false a body in
// equilibrium need not evaluate it in each step.
template <int Dim>
class VelocityFunction
{
public:
  template <class Function>
  VelocityFunction(Function function, bool depends_on_time = true)
      : function_(std::move(function))
      , depends_on_time_(depends_on_time)
  {
  }

  double operator()(Point<Dim> const& x, double t) const { return function_(x, t); }
  bool dependsOnTime() const { return depends_on_time_; }

private:
  std::function<double(Point<Dim> const& x, double t)> function_;
  bool depends_on_time_;
};

struct ZeroVelocity
{
  constexpr bool dependsOnTime() const { return false; }
  template <class Place>
  constexpr double operator()(Place const&, double) const
  {
    return 0;
  }
};

// Names of boundaries.
using Boundaries = std::vector<std::string>;

// v . d / |d| = velocity(x, t).
template <int Dim>
struct PrescribedVelocity
{
  static constexpr auto normal = Normal::of_boundary;
  static constexpr bool prescribes = true, holds_across = false, is_turned = false;
  std::vector<double> d;
  VelocityFunction<Dim> velocity;
};

// v . d / |d| = 0.
struct AtRestAlong
{
  static constexpr auto normal = Normal::of_boundary;
  static constexpr bool prescribes = true, holds_across = false, is_turned = false;
  static constexpr ZeroVelocity velocity = {};
  std::vector<double> d;
};

// v . n = 0: the body slides along the boundary.
struct SlidingWall
{
  static constexpr auto normal = Normal::of_wall;
  static constexpr bool prescribes = true, holds_across = true, is_turned = false;
  static constexpr ZeroVelocity velocity = {};
};

// v . n = 0: the body slides on a rigid foundation along the fault, or along a boundary that
// continues it. On a fault inside the body v is the jump over the fault, which then does not open.
struct ContactAcrossFault
{
  static constexpr auto normal = Normal::of_fault;
  static constexpr bool prescribes = true, holds_across = true, is_turned = false;
  static constexpr ZeroVelocity velocity = {};
  Boundaries continuations; // the normal is the mean over their facets, too
};

// No equation: the body, or one side of a fault inside it, moves freely across the fault, or across
// its continuation. The frames of the nodes follow n.
struct FreeAcrossFault
{
  static constexpr auto normal = Normal::of_fault;
  static constexpr bool prescribes = false, holds_across = false, is_turned = false;
  static constexpr ZeroVelocity velocity = {};
  Boundaries continuations; // the normal is the mean over their facets, too
};

// v . t = velocity(x, t) in the plane, where the tangent t is the first row of the node's frame.
template <int Dim>
struct SlipAlongTangent
{
  static constexpr auto normal = Normal::of_fault;
  static constexpr bool prescribes = true, holds_across = false, is_turned = true;
  VelocityFunction<Dim> velocity;
  Boundaries continuations; // the normal is the mean over their facets, too
};

// v . t = velocity(x, t) in space, where t is the direction of d - (d . n) n.
template <int Dim>
struct SlipTowards
{
  static constexpr auto normal = Normal::of_fault;
  static constexpr bool prescribes = true, holds_across = false, is_turned = false;
  std::vector<double> d;
  VelocityFunction<Dim> velocity;
  Boundaries continuations; // the normal is the mean over their facets, too
};

// v . s = 0 in space, where s is the direction of n x d, in the fault and at right angles to d.
struct NoSlipSideways
{
  static constexpr auto normal = Normal::of_fault;
  static constexpr bool prescribes = true, holds_across = false, is_turned = false;
  static constexpr ZeroVelocity velocity = {};
  std::vector<double> d;
  Boundaries continuations; // the normal is the mean over their facets, too
};

// A condition of one of these kinds on one boundary.
template <int Dim>
struct VelocityCondition
{
  using Kind =
    std::variant<PrescribedVelocity<Dim>, AtRestAlong, SlidingWall, ContactAcrossFault,
                 FreeAcrossFault, SlipAlongTangent<Dim>, SlipTowards<Dim>, NoSlipSideways>;

  std::string name; // for messages, e.g. "Boundary Conditions / Backstop"
  std::string boundary;
  Kind kind;
  // For a condition with the normal of a fault in two dimensions: see detail::tangentOf.
  // Constraints sets it.
  int turn = 0;

  // These return the members of the kind, see above.
  Normal normal() const;
  bool prescribes() const;
  bool isTurned() const;
  bool holdsAcross() const;
  double velocity(Point<Dim> const& x, double t) const;
  bool dependsOnTime() const; // whether the velocity may depend on time

  // The boundaries over whose facets n is the mean: this one and its continuations, sorted.
  Boundaries boundariesOfNormal() const;

  // The unit vector along which the velocity is prescribed or free at a node with this inward
  // normal, which may have any length above zero. Throws InputError where there is no such vector.
  std::vector<double> unitDirection(std::vector<double> const& inward_normal) const;
};
} // namespace asperity::fem
