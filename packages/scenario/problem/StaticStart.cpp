#include "scenario/problem/StaticStart.hpp"

#include "dynamics/initial/StaticNormalStress.hpp"
#include "dynamics/initial/StaticSolver.hpp"
#include "dynamics/initial/WithHeld.hpp"
#include "fem/SupportWeights.hpp"
#include "scenario/problem/StartRequirements.hpp"

#include <Tpetra_Vector.hpp>

#include <vector>

namespace asperity::scenario
{
namespace
{
// Whether the normal stress need not follow from the static solution, as where no friction asks for
// it.
template <int Dim>
bool isStressGiven(SetupContext<Dim> const& context)
{
  auto const& settings = context.settings;
  return settings.friction.gives_normal_stress || !settings.friction.laws.hasFrictionLaw() ||
         context.site.surface->numGlobalNodes() == 0;
}

// The body whose fault does not open.
dynamics::Body withFaultShut(fem::FaultSurface const& surface, dynamics::Body const& body)
{
  std::vector<int> across;
  for (auto const& node : surface) {
    across.push_back(node.across);
  }
  return dynamics::withHeld(body, across);
}
} // namespace

template <int Dim>
StaticStart staticStart(SetupContext<Dim> const& context, dynamics::Body const& body,
                        Vector const& load)
{
  auto const& discretisation = context.discretisation;
  auto const& surface = *context.site.surface;
  const bool stress_given = isStressGiven(context);
  const bool start_static = context.settings.initial.is_static;
  const bool has_load = load.normInf() > 0;
  requireNormalStress(context, stress_given, has_load);
  StaticStart start{body.vector(), std::vector<double>(surface.numNodes(), 0.)};
  if (!has_load || (stress_given && !start_static)) {
    return start;
  }
  auto const at_rest = surface.mayOpen() ? withFaultShut(surface, body) : body;
  requireStaticSolution(discretisation, at_rest, stress_given);
  auto const u = dynamics::StaticSolver(at_rest, context.solver).solve(load);
  if (!stress_given) {
    auto const support =
      fem::supportWeights(discretisation.mesh, surface, discretisation.boundary.velocities);
    start.normal_stress =
      dynamics::staticNormalStress(body, discretisation.frames(), surface, support, load, *u);
  }
  if (start_static) {
    start.displacement = u;
  }
  return start;
}

template StaticStart staticStart(SetupContext<2> const&, dynamics::Body const&, Vector const&);
template StaticStart staticStart(SetupContext<3> const&, dynamics::Body const&, Vector const&);
} // namespace asperity::scenario
