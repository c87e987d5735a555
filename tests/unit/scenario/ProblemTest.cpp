#include "scenario/problem/Problem.hpp"

#include "SampleDeck.hpp"
#include "dynamics/control/StepControl.hpp"
#include "dynamics/observables/EnergyBalance.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/parallel/Partition.hpp"
#include "scenario/run/WholeBodyArchive.hpp"
#include "scenario/setup/TimeSchemes.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <numeric>

namespace asperity::scenario
{
using namespace test;

namespace
{
double force(Problem<2> const& problem)
{
  const auto pressure = valuesOf(problem.model.initial.sigma_n);
  const auto weight = weightsOf(problem.surface());
  return std::inner_product(pressure.begin(), pressure.end(), weight.begin(), 0.);
}

constexpr double column_weight = 1000 * 10 * 4; // N/m: density, gravity, area
} // namespace

TEST(Problem, PressesOnTheFaultWithTheWeightOfTheBody)
{
  auto const problem = makeProblem<2>(column(), world());
  EXPECT_EQ(problem.components(), 2);
  EXPECT_EQ(problem.surface().numNodes(), 3);
  EXPECT_NEAR(problem.surface().totalWeight(), 2, 1e-14);
  EXPECT_NEAR(force(problem), column_weight, 1e-9 * column_weight);
  EXPECT_EQ(heldComponents(problem.surface()), (std::vector<std::vector<int>>{{1}, {0}, {1}}))
    << "the walls hold its ends";
  ASSERT_EQ(problem.findings.remarks.size(), 1U);
  expectParts(problem.findings.remarks[0], {"Beside the fault shear waves travel at c_s"});
}

// Where a wall goes on in its plane, the fault bears its own share of a node's load alone.
TEST(Problem, SharesTheWeightWithAWallInItsPlane)
{
  const auto finer = [](auto& deck) {
    deck.sublist("Mesh").sublist("Rectangle").set("Cells X", 4);
  };
  auto const whole = makeProblem<2>(column(finer), world());
  auto const part = makeProblem<2>(column([&](auto& deck) {
                                     finer(deck);
                                     auto& boundaries = deck.sublist("Mesh").sublist("Boundaries");
                                     boundaries.set("contact", "y < 1e-9 && x < 1");
                                     boundaries.set("floor", "y < 1e-9 && x > 1");
                                     auto& conditions = deck.sublist("Boundary Conditions");
                                     conditions.sublist("Fault").set("Boundary", "contact");
                                     conditions.sublist("Floor").set("Boundary", "floor");
                                     conditions.sublist("Floor").set("Type", "Sliding Wall");
                                   }),
                                   world());
  const auto expected = valuesOf(whole.model.initial.sigma_n);
  const auto pressure = valuesOf(part.model.initial.sigma_n);
  ASSERT_EQ(pressure.size(), 3U);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_NEAR(pressure[i], expected[i], 1e-8 * expected[i]) << i;
  }
}

TEST(Problem, MultipliesTheNormalStress)
{
  auto const twice = makeProblem<2>(
    column([](auto& deck) { deck.sublist("Friction").set("Normal Stress Factor", 2.); }), world());
  EXPECT_NEAR(force(twice), 2 * column_weight, 1e-8 * column_weight);
  auto const given =
    makeProblem<2>(column([](auto& deck) {
                     deck.sublist("Friction").set("Normal Stress", "100 * (1 + x)");
                     deck.sublist("Friction").set("Normal Stress Factor", 3.);
                   }),
                   world());
  EXPECT_EQ(valuesOf(given.model.initial.sigma_n), (std::vector<double>{300, 600, 900}));
}

TEST(Problem, SetsATensileReactionToZeroAndSaysSo)
{
  auto const problem =
    makeProblem<2>(column([](auto& deck) {
                     deck.sublist("Bulk").set("Gravity Direction", array<double>({0, 1}));
                   }),
                   world());
  EXPECT_EQ(force(problem), 0);
  std::string told;
  for (auto const& warning : problem.findings.warnings) {
    told += warning.text;
  }
  expectParts(told, {"pulls at 100 % of the fault", "zero"});
}

TEST(Problem, RefusesToGuessANormalStress)
{
  expectRefusal(
    [] {
      makeProblem<2>(
        column([](auto& deck) { deck.sublist("Bulk").set("Gravitational Acceleration", 0.); }),
        world());
    },
    {"Asperity / Friction / Normal Stress", "gravity"});
  expectRefusal(
    [] {
      makeProblem<2>(column([](auto& deck) {
                       deck.sublist("Bulk").set("Gravitational Acceleration", 0.);
                       deck.sublist("Bulk").set("Model", "Antiplane");
                     }),
                     world());
    },
    {"Asperity / Friction / Normal Stress", "antiplane"});
}

TEST(Problem, RefusesBoundariesThatTheMeshDoesNotHave)
{
  for (char const* condition : {"Fault", "Left"}) {
    expectParts(
      refusal([condition] {
        makeProblem<2>(
          column([condition](auto& deck) {
            deck.sublist("Boundary Conditions").sublist(condition).set("Boundary", "bottm");
          }),
          world());
      }),
      {"'bottm'", "boundary"});
  }
}

TEST(Problem, RefusesUnknownNamesOfConditionsWithoutEffect)
{
  for (char const* type : {"Sliding Wall", "Free Surface"}) {
    const auto call = [type] {
      makeProblem<2>(strip([type](ParameterList& deck) {
                       auto& conditions = deck.sublist("Boundary Conditions");
                       conditions.sublist("Air").set("Boundary", "top").set("Type", "Free Surface");
                       conditions.sublist("Wall").set("Boundary", "rihgt").set("Type", type);
                     }),
                     world());
    };
    expectRefusal(call, {"Asperity / Boundary Conditions / Wall / Boundary = 'rihgt'",
                         "Did you mean 'right'?"});
  }
}

TEST(Problem, StartsFromTheVelocityOfTheDeck)
{
  auto const problem = makeProblem<2>(column([](auto& deck) {
                                        auto& initial = deck.sublist("Initial State");
                                        initial.set("Velocity X", "0.1 * x").set("Velocity Y", 0.2);
                                        initial.set("alpha", "x - 1").set("Acceleration", "Zero");
                                      }),
                                      world());
  auto const v = fem::alongAxes(problem.discretisation.frames(), *problem.model.body.dofs,
                                *problem.model.initial.v);
  // Rows of three vertices; the fault has no velocity across it, the walls none along x.
  EXPECT_EQ(v[2 * 1], 0.1);
  EXPECT_EQ(v[2 * 1 + 1], 0);
  EXPECT_EQ(v[2 * 4], 0.1);
  EXPECT_EQ(v[2 * 4 + 1], 0.2);
  EXPECT_EQ(v[2 * 5], 0);
  EXPECT_EQ(valuesOf(problem.model.initial.alpha), (std::vector<double>{-1, 0, 1}));
  EXPECT_EQ(problem.model.initial.a->normInf(), 0);
}

TEST(Problem, IsAtRestInBalance)
{
  auto const problem = makeProblem<2>(column(), world());
  EXPECT_LE(problem.model.initial.a->normInf(), 1e-9) << "the static solution does not move";
  EXPECT_EQ(problem.model.initial.v->normInf(), 0);
}

TEST(StepControl, WantsPrescribedLevelsThatExist)
{
  const auto control = [](std::vector<int> const& levels) {
    const auto deck = column([&](auto& given) {
      auto& time = given.sublist("Time Stepping");
      time.set("Control", "Prescribed").set("Smallest Step", 0.125);
      time.sublist("Prescribed").set("Levels", array(levels));
    });
    auto const problem = makeProblem<2>(deck, world());
    auto const& time = problem.settings.time;
    dynamics::CoupledStep step(
      problem.model.body, problem.model.fault,
      {makeRateUpdate(time), makeClock(time), {}, problem.solver, 1000000});
    return makeStepControl(time, {}, step) != nullptr;
  };
  EXPECT_TRUE(control({0, 3, 2}));
  expectRefusal([&] { control({}); }, {"Prescribed / Levels is empty"});
  expectRefusal([&] { control({0, 4}); }, {"Prescribed / Levels: 4", "level 3"});
  expectRefusal([&] { control({-1}); }, {"Prescribed / Levels", "-1"});
}

TEST(WholeBodyArchive, TurnsTimesOfAnotherSmallestStepIntoItsOwn)
{
  auto const problem = makeProblem<2>(column(), world());
  auto state = problem.model.initial.clone();
  state.time = 3;
  Archive archive;
  WholeBodyArchive(problem.model, nullptr, dynamics::DyadicTime(1, 10))
    .save(archive, "state", state);
  EXPECT_EQ(WholeBodyArchive(problem.model, nullptr, dynamics::DyadicTime(1, 12), 10)
              .load(archive, "state")
              .time,
            12);
  expectRefusal(
    [&] {
      WholeBodyArchive(problem.model, nullptr, dynamics::DyadicTime(1, 9), 10)
        .load(archive, "state");
    },
    {"between two steps of the smallest size", "--restart-from"});
}

TEST(WholeBodyArchive, ReturnsWhatWasSaved)
{
  auto problem = makeProblem<2>(column(), world());
  auto state = problem.model.initial.clone();
  state.time = 1234567890123456789;
  state.v->putScalar(1e-300);
  Kokkos::deep_copy(state.alpha, -0.1);
  // A field that a model adds is saved like the others.
  const dynamics::FieldInfo pressure = {"p", "pressure", "Pa"};
  for (auto* each : {&problem.model.initial, &state}) {
    const NodeView p("asperity::test::p", problem.model.initial.alpha.extent(0));
    each->added.push_back({std::make_shared<const dynamics::FieldInfo>(pressure), p});
  }
  Kokkos::deep_copy(state.added[0].values, 4e6);
  Archive archive;
  const WholeBodyArchive states(problem.model, nullptr, dynamics::DyadicTime(1, 10));
  states.save(archive, "state", state);
  auto const read = states.load(archive, "state");
  EXPECT_EQ(read.time, state.time);
  dynamics::State::visitFields(
    [](dynamics::FieldInfo const& info, auto const& loaded, auto const& saved) {
      EXPECT_EQ(valuesOf(dynamics::valuesOf(loaded)), valuesOf(dynamics::valuesOf(saved)))
        << info.name;
    },
    read, state);

  dynamics::SolveCount count;
  count.tnnmg_iterations = 7;
  count.energy_increases = 2;
  dynamics::Energy energy;
  energy.friction_work = -0.1;
  energy.defect = 1e-20;
  saveMembers(archive, "count", count);
  saveMembers(archive, "energy", energy);
  EXPECT_EQ(loadMembers<dynamics::SolveCount>(archive, "count").tnnmg_iterations, 7);
  EXPECT_EQ(loadMembers<dynamics::SolveCount>(archive, "count").energy_increases, 2);
  EXPECT_EQ(loadMembers<dynamics::Energy>(archive, "energy").friction_work, -0.1);
  EXPECT_EQ(loadMembers<dynamics::Energy>(archive, "energy").defect, 1e-20);
}

TEST(WholeBodyArchive, RefusesTheStateOfAnotherMesh)
{
  auto const problem = makeProblem<2>(column(), world());
  auto const finer = makeProblem<2>(
    column([](auto& deck) { deck.sublist("Mesh").sublist("Rectangle").set("Cells X", 3); }),
    world());
  Archive archive;
  const dynamics::DyadicTime clock(1, 10);
  WholeBodyArchive(finer.model, nullptr, clock).save(archive, "state", finer.model.initial);
  expectRefusal([&] { WholeBodyArchive(problem.model, nullptr, clock).load(archive, "state"); },
                {"state/u", "18", "24", "another mesh"});
}
} // namespace asperity::scenario
