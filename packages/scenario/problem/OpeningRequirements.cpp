#include "scenario/problem/OpeningRequirements.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "mesh/Crossings.hpp"
#include "mesh/Joints.hpp"
#include "mesh/PointText.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/TimeSchemes.hpp"

#include <initializer_list>
#include <map>
#include <set>
#include <variant>

namespace asperity::scenario
{
namespace
{
constexpr char const* unilateral =
  "Asperity / Boundary Conditions: a fault has the Contact 'Unilateral'";

// An open fault bears no shear stress.
void requireNoCohesion(dynamics::Fault const& fault, FieldNodes const& nodes)
{
  auto const cohesion = toHost(fault.laws().cohesion);
  for (int node = 0; node < fault.surface().numNodes(); ++node) {
    ASPERITY_REQUIRE(!fault.surface().opens(node) || !(cohesion(node) > 0),
                     unilateral << ", but " << friction_path << " / Cohesion is " << cohesion(node)
                                << " Pa at x = " << nodes.text(node)
                                << ", which an open fault would bear, too. Set it to zero there.");
  }
}

// Forces across the fault are made once for a step.
void requireKnownPressure(dynamics::Fault const& fault)
{
  for (auto const& process : fault.laws().processes) {
    for (auto const& unknown : process->unknowns()) {
      ASPERITY_REQUIRE(unknown->followsFrom() == dynamics::FollowsFrom::start,
                       unilateral << ", and a process of " << friction_path
                                  << " depends on the slip of the step: heat, or a permeability "
                                     "that changes. Opening takes only what is known when a step "
                                     "begins. Turn the process off, or choose Bilateral.");
    }
  }
}
} // namespace

template <int Dim>
void requireNoJunction(BoundaryConditions<Dim> const& boundary, Mesh<Dim> const& mesh,
                       Communicator const& communicator)
{
  if (!boundary.other_side.may_open) {
    return;
  }
  std::set<int> opening; // vertices of facets of faults that may open
  for (auto const& condition : boundary.velocities) {
    if (std::holds_alternative<fem::FreeAcrossFault>(condition.kind)) {
      for (auto const& facet : mesh.boundaries.at(condition.boundary)) {
        opening.insert(facet.begin(), facet.end());
      }
    }
  }
  const auto refuse = [&](std::initializer_list<int> plus_of_faults) {
    for (const int vertex : plus_of_faults) {
      ASPERITY_REQUIRE(opening.count(vertex) == 0,
                       unilateral << ", and at x = " << mesh::text(mesh.vertices[vertex])
                                  << " it meets another fault: how both open there is not in the "
                                     "model. Choose Bilateral, or end one of them before the "
                                     "other.");
    }
  };
  onEveryRank(communicator, [&] {
    for (auto const& crossing : mesh::crossingsOf(mesh.splits)) {
      refuse({crossing.plus[0], crossing.plus[1], crossing.both});
    }
    for (auto const& joint : mesh::jointsOf(mesh.splits)) {
      refuse({joint.plus, joint.main});
    }
    std::map<int, int> plus_of; // of both vertices of a pair
    for (auto const& split : mesh.splits) {
      if (!split.is_tip) {
        plus_of[split.plus] = plus_of[split.minus] = split.plus;
      }
    }
    for (auto const& split : mesh.splits) { // a branch has its tip at a pair of the other fault
      const auto pair = split.is_tip ? plus_of.find(split.minus) : plus_of.end();
      if (pair != plus_of.end()) {
        refuse({pair->second});
      }
    }
  });
}

template void requireNoJunction(BoundaryConditions<2> const&, Mesh<2> const&, Communicator const&);
template void requireNoJunction(BoundaryConditions<3> const&, Mesh<3> const&, Communicator const&);

template <int Dim>
void requireOpening(SetupContext<Dim> const& context, dynamics::Fault const& fault)
{
  auto const& surface = fault.surface();
  if (!surface.mayOpen()) {
    return;
  }
  auto const& settings = context.settings;
  ASPERITY_REQUIRE(settings.friction.followsAtOnce() && settings.friction.normalStressChange() ==
                                                          dynamics::NormalStressChange::coupled,
                   unilateral << ", but " << friction_path
                              << " / Normal Stress Change = " << settings.friction.change
                              << ": friction would not know where the fault is open. Choose "
                                 "Coupled.");
  ASPERITY_REQUIRE(settings.friction.floor == 0,
                   unilateral << ", but " << friction_path
                              << " / Normal Stress Floor = " << settings.friction.floor
                              << " Pa, which an open fault would bear, too. Remove it.");
  ASPERITY_REQUIRE(settings.bulk.isQuasiDynamic() || makeRateUpdate(settings.time).allowsContact(),
                   unilateral << ", and Time Stepping / Scheme = '" << settings.time.scheme
                              << "', as it is, would throw back with inertia what contact stops. "
                                 "Choose 'Newmark' with beta = 0.25, which it is by default, or "
                                 "'Backward Euler'.");
  requireKnownPressure(fault);
  onEveryRank(context.communicator(), [&] { requireNoCohesion(fault, context.site.nodes); });
}

template void requireOpening(SetupContext<2> const&, dynamics::Fault const&);
template void requireOpening(SetupContext<3> const&, dynamics::Fault const&);
} // namespace asperity::scenario
