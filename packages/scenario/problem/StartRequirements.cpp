#include "scenario/problem/StartRequirements.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/Simplex.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "fem/motions/FreeMotions.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace asperity::scenario
{
namespace
{
// Marks the dofs that springs resist whatever the others do: those that a block does not couple
// with others, and all dofs of a block that is positive definite.
void markSprings(fem::NodalDampers const& springs, fem::DofMap const& dofs,
                 std::vector<int>& resisting)
{
  const int components = dofs.components();
  for (auto const& [nodes, block] : springs) {
    if (nodes.first != nodes.second) {
      continue;
    }
    // Cholesky's pivots
    double L[3][3] = {};
    bool is_definite = true;
    for (int i = 0; i < components && is_definite; ++i) {
      for (int j = 0; j <= i; ++j) {
        double rest = block[i * components + j];
        for (int k = 0; k < j; ++k) {
          rest -= L[i][k] * L[j][k];
        }
        is_definite = is_definite && (j < i || rest > 1e-12 * block[i * components + i]);
        L[i][j] = j < i ? rest / L[j][j] : std::sqrt(std::max(rest, 0.));
      }
    }
    for (int i = 0; i < components; ++i) {
      bool is_alone = block[i * components + i] > 0;
      for (int j = 0; j < components; ++j) {
        is_alone = is_alone && (i == j || std::abs(block[i * components + j]) <=
                                            1e-12 * block[i * components + i]);
      }
      if (is_definite || is_alone) {
        resisting[dofs.dof(nodes.first, i)] = 1;
      }
    }
  }
}

// Every rigid motion of the body is stopped or resisted by a held dof, a spring of a boundary or
// the fault, if one is given. `why` says what does not exist otherwise, `cure` what else helps.
template <int Dim>
void requireNoFreeMotion(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                         fem::FaultSurface const* resisting_fault, std::string const& why,
                         std::string const& cure)
{
  std::vector<int> resisting(body.numOwnedDofs(), 0);
  for (const int dof : body.held.owned()) {
    resisting[dof] = 1;
  }
  if (resisting_fault != nullptr) {
    for (auto const& node : *resisting_fault) {
      for (const int dof : node.dofs) {
        resisting[dof] = 1;
      }
    }
  }
  for (auto const& resistance : discretisation.boundary.resistances) {
    if (resistance.against == fem::BoundaryResistance::Against::displacement) {
      markSprings(fem::resistanceOf<Dim>(discretisation.mesh, resistance, discretisation.frames(),
                                         discretisation.rock.materials),
                  *discretisation.dofs, resisting);
    }
  }
  auto const free =
    fem::freeMotions(discretisation.mesh, discretisation.components(), *body.near_null_space,
                     resisting, discretisation.dofs->communicator());
  ASPERITY_REQUIRE(
    free.empty(), "Asperity / Boundary Conditions: nothing stops or resists the body when it moves "
                    << free.front() << ", and " << why
                    << " does not exist or is not unique. Add a condition on a boundary that "
                       "stops this motion: Fixed, Sliding Wall, or Prescribed Velocity in that "
                       "direction, with a Velocity of 0 if it is to rest"
                    << cure << ".");
}
} // namespace

template <int Dim>
void requireNormalStress(SetupContext<Dim> const& context, bool stress_given, bool has_load)
{
  auto const& surface = *context.site.surface;
  auto const& friction = context.settings.friction;
  ASPERITY_REQUIRE(stress_given || context.components() == Dim,
                   "Asperity / Friction / Normal Stress is missing: an antiplane model has no "
                   "normal stress of its own. Give it.");
  ASPERITY_REQUIRE(stress_given || !surface.otherSide().is_mirrored,
                   "Asperity / Friction / Normal Stress is missing: on an antisymmetric fault it "
                   "does not follow from the static solution. Give that of the undisturbed state.");
  const bool follows = friction.followsAtOnce(); // Prakash-Clifton also follows pressure and time
  ASPERITY_REQUIRE(!follows || context.components() == Dim,
                   "Asperity / Friction / Normal Stress Change = "
                     << friction.change
                     << ", but antiplane motion does not press across the fault. Choose Fixed.");
  ASPERITY_REQUIRE(!follows || !surface.otherSide().is_mirrored,
                   "Asperity / Friction / Normal Stress Change = "
                     << friction.change
                     << ", but by symmetry the normal stress of an Antisymmetric Fault does not "
                        "change. Choose Fixed.");
  ASPERITY_REQUIRE(stress_given || has_load,
                   "Asperity / Friction / Normal Stress is missing, and without gravity or a "
                   "Prescribed Traction it cannot follow from the static solution. Give one of "
                   "them.");
}

template <int Dim>
void requireStaticSolution(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                           bool stress_given)
{
  requireNoFreeMotion(discretisation, body, nullptr,
                      "its static displacement, for which the fault slides without friction,",
                      stress_given ? "; or choose Initial State / Displacement = Zero, if the load "
                                     "is to set the body in motion"
                                   : "");
}

template <int Dim>
void requireMasslessVelocity(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                             fem::FaultSurface const& fault)
{
  requireNoFreeMotion(discretisation, body, &fault, "the velocity of a quasi-dynamic body", "");
}

template <int Dim>
void requireNoInitialYield(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                           Vector const& u)
{
  if (!body.cells) {
    return;
  }
  auto const beyond = body.cells->largestExcess(u);
  onEveryRank(*discretisation.dofs->communicator(), [&] {
    ASPERITY_REQUIRE(!beyond,
                     "Asperity / Bulk: at the start the rock at "
                       << mesh::text(fem::simplexOf(discretisation.mesh, beyond->cell).centroid)
                       << " bears a shear stress of " << beyond->shear_stress
                       << " Pa, but it yields at " << beyond->kept
                       << " Pa (sqrt(s : s / 2) of the deviatoric stress s). Check the strength of "
                          "the rock, Initial Stress and gravity.");
  });
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template void requireNormalStress(SetupContext<Dim> const&, bool, bool);                         \
  template void requireStaticSolution(Discretisation<Dim> const&, dynamics::Body const&, bool);    \
  template void requireMasslessVelocity(Discretisation<Dim> const&, dynamics::Body const&,         \
                                        fem::FaultSurface const&);                                 \
  template void requireNoInitialYield(Discretisation<Dim> const&, dynamics::Body const&,           \
                                      Vector const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
