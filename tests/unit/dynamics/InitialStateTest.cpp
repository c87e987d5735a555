#include "dynamics/initial/InitialAcceleration.hpp"
#include "dynamics/initial/InitialAlpha.hpp"
#include "dynamics/initial/StaticSolver.hpp"

#include "unit/base/Refusal.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
RCP<const Communicator> alone() { return fem::test::selfCommunicator(); }

RCP<Vector> loadOf(Model const& model)
{
  auto load = model.body.vector();
  model.body.load(0, *load);
  return load;
}

std::vector<int> freeDofs(Model const& model)
{
  std::vector<int> dofs;
  for (int dof = 0; dof < model.body.numOwnedDofs(); ++dof) {
    if (!model.body.held[dof]) {
      dofs.push_back(dof);
    }
  }
  return dofs;
}

Eigen::VectorXd accelerationOf(Model const& model, State const& state, Vector const& prescribed,
                               Correction correction = Correction::direct)
{
  return denseOf(*initialAcceleration(model.body, model.fault, tightSettings(correction),
                                      *loadOf(model), {*state.u, *state.v, prescribed, {}},
                                      {state.alpha, state.sigma_n}));
}

Eigen::VectorXd residualOf(Model const& model, State const& state, Eigen::VectorXd const& a)
{
  return denseOf(*loadOf(model)) - denseOf(*model.body.matrices.mass) * a -
         denseOf(*model.body.matrices.viscosity) * denseOf(*state.v) -
         denseOf(*model.body.matrices.stiffness) * denseOf(*state.u);
}
} // namespace

TEST(InitialState, StaticDisplacementBalancesTheLoadWithAFaultWithoutFriction)
{
  for (int components : {1, 2}) {
    for (auto correction : {Correction::direct, Correction::multigrid}) {
      const Model model(slidingBlock(components), alone());
      auto const load = loadOf(model);
      auto const u = denseOf(*StaticSolver(model.body, tightSettings(correction)).solve(*load));
      const Eigen::VectorXd rest = denseOf(*model.body.matrices.stiffness) * u - denseOf(*load);
      EXPECT_GT(u.norm(), 0);
      EXPECT_LE(rest(freeDofs(model)).norm(), 1e-11 * denseOf(*load).norm());
      for (int dof = 0; dof < u.size(); ++dof) {
        EXPECT_TRUE(!model.body.held[dof] || u[dof] == 0);
      }
    }
  }
}

// Corrections by a few cycles do not reach the last digits; what is linear is solved nonetheless.
TEST(InitialState, StaticDisplacementDoesNotDependOnHowCorrectionsAreFound)
{
  const Model model(slidingBlock(2), alone());
  auto const load = loadOf(model);
  auto cycles = tightSettings(Correction::multigrid);
  cycles.multigrid.set("Method", "V-Cycles");
  cycles.multigrid.sublist("MueLu").set("coarse: max size", 20); // several levels
  auto const expected = denseOf(*StaticSolver(model.body, tightSettings()).solve(*load));
  auto const u = denseOf(*StaticSolver(model.body, cycles).solve(*load));
  EXPECT_LE((u - expected).norm(), 1e-9 * expected.norm());
}

TEST(InitialState, AccelerationBalancesMomentumWhereTheFaultMoves)
{
  for (int components : {1, 2}) {
    for (auto correction : {Correction::direct, Correction::multigrid}) {
      auto options = slidingBlock(components);
      options.cohesion = 30;
      const Model model(options, alone());
      auto const state = slidingState(model);
      model.setFree(*state.u, [](Point<2> const& x) -> std::array<double, 2> {
        return {1e-3 * x[0] * x[1], 2e-3 * x[0]};
      });
      Vector prescribed(*model.body.vector());
      model.body.prescribed_velocity(0.7, prescribed); // any values at the fixed dofs
      auto const a = accelerationOf(model, state, prescribed, correction);
      auto const rest = residualOf(model, state, a);
      auto const v = denseOf(*state.v);
      auto const alpha = denseOf(state.alpha);
      Eigen::VectorXd friction = Eigen::VectorXd::Zero(a.size());
      for (int i = 0; i < model.surface->numNodes(); ++i) {
        const int dof = (*model.surface)[i].dofs[0];
        auto const& o = model.options;
        const double mu = o.a * std::asinh(v[dof] / (2 * o.reference_rate) *
                                           std::exp((o.reference_friction + o.b * alpha[i]) / o.a));
        friction[dof] = (*model.surface)[i].weight * (o.sigma_n * mu + o.cohesion);
      }
      EXPECT_LE((rest - friction)(freeDofs(model)).norm(), 1e-10 * rest.norm());
      auto const fixed_values = denseOf(prescribed);
      for (int dof = 0; dof < a.size(); ++dof) {
        EXPECT_TRUE(!model.body.held[dof] || a[dof] == fixed_values[dof]);
      }
    }
  }
}

// The block leans on its fault at rest: some nodes slip away, others hold.
TEST(InitialState, CohesionHoldsRestingNodesUpToItsStrength)
{
  for (auto correction : {Correction::direct, Correction::multigrid}) {
    auto options = slidingBlock(2);
    options.conditions = {};
    options.traction = 0;
    options.cohesion = 100;
    const Model model(options, alone());
    auto const state = model.restingState();
    model.setFree(*state.u, [](Point<2> const& x) -> std::array<double, 2> {
      return {0.01 * x[1] * std::sin(12 * x[0]), 0};
    });
    auto const a = accelerationOf(model, state, *model.body.vector(), correction);
    auto const rest = residualOf(model, state, a);
    int num_held = 0, num_moving = 0;
    for (int i = 0; i < model.surface->numNodes(); ++i) {
      const int dof = (*model.surface)[i].dofs[0];
      const double strength = options.cohesion * (*model.surface)[i].weight;
      if (a[dof] == 0) {
        ++num_held;
        EXPECT_LE(std::abs(rest[dof]), strength);
      } else {
        ++num_moving;
        EXPECT_NEAR(rest[dof], std::copysign(strength, a[dof]), 1e-9 * strength);
      }
    }
    EXPECT_GT(num_held, 0);
    EXPECT_GT(num_moving, 0);
    auto away_from_fault = rest;
    for (auto const& node : *model.surface) {
      away_from_fault[node.dofs[0]] = 0;
    }
    EXPECT_LE(away_from_fault(freeDofs(model)).norm(), 1e-10 * rest.norm());
  }
}

TEST(InitialState, ABodyInBalanceStaysAtRest)
{
  auto options = slidingBlock(2);
  options.traction = 0;
  const Model model(options, alone());
  auto state = model.restingState();
  state.v->putScalar(0);
  state.u = StaticSolver(model.body, tightSettings()).solve(*loadOf(model));
  auto const a = accelerationOf(model, state, *model.body.vector());
  EXPECT_EQ(a.norm(), 0);
}

TEST(InitialState, ABodyThatNothingHoldsHasNoStaticDisplacement)
{
  auto options = slidingBlock(2);
  options.conditions = {}; // free to move along its base
  const Model model(options, alone());
  for (auto correction : {Correction::direct, Correction::multigrid}) {
    EXPECT_THROW(StaticSolver(model.body, tightSettings(correction)).solve(*loadOf(model)),
                 SolveError);
  }
}

namespace
{
// The base of the block slides, but for its right end, which is held.
struct SlidingFault
{
  SlidingFault()
  {
    auto const& surface = *model.surface;
    model.setFree(*v, [](auto const&) -> std::array<double, 2> { return {1e-4, 0}; });
    gatherSlip(surface, *v, w);
    start = {std::vector<double>(surface.numNodes(), 7), std::vector<double>(surface.numNodes(), 0),
             model.restingState().sigma_n, w};
  }
  NodeView alpha(AlphaAtStart kind) const
  {
    return initialAlpha(model.fault, kind, start,
                        [](int node) { return "Node " + std::to_string(node); });
  }
  void expectRefusal(AlphaAtStart kind, std::string const& reason) const
  {
    asperity::test::expectRefusal([&] { alpha(kind); }, {reason});
  }

  static ModelOptions options()
  {
    auto result = slidingBlock(2);
    result.cohesion = 15;
    auto const at_rest = [](Point<2> const&, double) { return 0.; };
    result.conditions = {{"Wall", "right", fem::PrescribedVelocity<2>{{1, 0}, at_rest}}};
    return result;
  }

  const Model model{options(), alone()};
  RCP<Vector> v = model.body.vector();
  const BlockView w{"asperity::test::w", static_cast<std::size_t>(model.surface->numNodes()), 1};
  GivenAtStart start;
};
} // namespace

TEST(InitialAlpha, IsGivenWhereTheFaultRestsAsPrescribed)
{
  const SlidingFault fault;
  for (auto kind : {AlphaAtStart::given, AlphaAtStart::steady}) {
    auto const alpha = fault.alpha(kind);
    for (int i = 0; i < fault.model.surface->numNodes(); ++i) {
      const bool is_given = kind == AlphaAtStart::given || !fault.model.surface->slides(i);
      EXPECT_NEAR(alpha(i), is_given ? 7 : std::log(50e-6 / 1e-4), 1e-12); // V* / V
    }
  }
}

TEST(InitialAlpha, LetsFrictionAndCohesionBearTheTraction)
{
  SlidingFault fault;
  auto const size = fault.model.surface->numNodes();
  const NodeView alpha("asperity::test::alpha", size), mu("asperity::test::mu", size);
  for (int i = 0; i < size; ++i) {
    alpha(i) = -1 + 0.5 * i;
  }
  fault.model.fault.friction().coefficient(fault.w, alpha, mu);
  for (int i = 0; i < size; ++i) {
    fault.start.traction[i] = (fault.w(i, 0) < 0 ? -1 : 1) * (2000 * mu(i) + 15);
  }
  auto const found = fault.alpha(AlphaAtStart::stress_balance);
  for (int i = 0; i < size; ++i) {
    EXPECT_NEAR(found(i), fault.model.surface->slides(i) ? alpha(i) : 7, 1e-10);
  }
}

TEST(InitialAlpha, RefusesAStateThatDoesNotExist)
{
  SlidingFault fault;
  fault.expectRefusal(AlphaAtStart::stress_balance, "Node 0 the shear traction");
  fault.start.sigma_n = NodeView("asperity::test::none", fault.start.traction.size());
  fault.expectRefusal(AlphaAtStart::stress_balance, "Node 0 there is no normal stress");
  Kokkos::deep_copy(fault.w, 0);
  fault.expectRefusal(AlphaAtStart::steady, "Node 0 the initial slip rate is zero");
  fault.expectRefusal(AlphaAtStart::steady, "Give an initial velocity along the fault");
}
} // namespace asperity::dynamics
