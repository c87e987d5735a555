#include "SampleDeck.hpp"
#include "scenario/problem/Problem.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::scenario
{
using namespace test;

namespace
{
// The load on the fault nodes at the time t, per their weight [Pa].
std::vector<double> tractionAt(Problem<2> const& problem, double t)
{
  const auto load = problem.model.body.vector();
  problem.model.body.load(t, *load);
  const auto values = valuesOf(*load);
  std::vector<double> traction;
  traction.reserve(problem.surface().numNodes());
  for (int i = 0; i < problem.surface().numNodes(); ++i) {
    traction.push_back(values[(problem.surface())[i].dofs[0]] / (problem.surface())[i].weight);
  }
  return traction;
}
} // namespace

TEST(FaultLoads, FollowAShearTractionInSpaceAndTime)
{
  auto const steady = makeProblem<2>(
    strip([](auto& deck) { deck.sublist("Friction").set("Shear Traction", "100 * (1 + x)"); }),
    world());
  expectNear(tractionAt(steady, 0), {100, 200, 300});
  expectNear(tractionAt(steady, 7), {100, 200, 300});
  auto const moving = makeProblem<2>(
    strip([](auto& deck) {
      deck.sublist("Friction").set("Shear Traction", "100 * (1 + x) + (t < 2 ? t : 2)");
    }),
    world());
  expectNear(tractionAt(moving, 0), {100, 200, 300});
  expectNear(tractionAt(moving, 1), {101, 201, 301});
  expectNear(tractionAt(moving, 9), {102, 202, 302});
  expectNear(tractionAt(moving, 0), {100, 200, 300});
}

// Nodes at 0, 1 and 2 m: the shares of [0, 1.25] under their basis functions. Their sum has the
// integral of the field, whatever the cells are.
TEST(FaultLoads, AreMeansWhereTheDeckSaysSo)
{
  auto const problem =
    makeProblem<2>(strip([](auto& deck) {
                     deck.sublist("Friction").set("Shear Traction", "100 * mean(x < 1.25)");
                   }),
                   world());
  expectNear(tractionAt(problem, 0), {100, 71.875, 6.25});
}

namespace
{
// Two faults end to end along y = 1, which meet at x = 1, under shear tractions by their names.
ParameterList endToEnd(std::function<void(ParameterList&)> const& setTractions)
{
  return strip([&](ParameterList& deck) {
    auto& conditions = deck.sublist("Boundary Conditions");
    conditions.sublist("Fault").set("Boundary", "west").set("Type", "Two-Sided Fault");
    conditions.sublist("Other").set("Boundary", "east").set("Type", "Two-Sided Fault");
    for (std::string const side : {"top", "bottom"}) {
      conditions.sublist(side).set("Boundary", side).set("Type", "Fixed");
    }
    deck.sublist("Mesh").sublist("Faults").set("east", "abs(y - 1) < 1e-6 && x > 0.99");
    deck.sublist("Mesh").sublist("Faults").set("west", "abs(y - 1) < 1e-6 && x < 1.01");
    deck.sublist("Bulk").set("Dynamics", "Quasi-dynamic");
    setTractions(deck.sublist("Friction").sublist("Shear Traction"));
  });
}
} // namespace

// The node that both faults have is one of the first fault of the deck.
TEST(FaultLoads, MayBeGivenForEachFault)
{
  auto const problem = makeProblem<2>(
    endToEnd([](ParameterList& tractions) { tractions.set("west", 100.).set("east", "300 + x"); }),
    world());
  auto const tractions = tractionAt(problem, 0);
  ASSERT_EQ(tractions.size(), 3u);
  for (int i = 0; i < problem.surface().numNodes(); ++i) {
    const double x = problem.surface()[i].place[0];
    EXPECT_NEAR(tractions[i], x > 1.5 ? 302 : 100, 1e-10) << x;
  }
}

TEST(FaultLoads, GivenForEachFaultNameAllOfThem)
{
  const auto refused = [](std::vector<std::string> const& names) {
    return refusal([&] {
      makeProblem<2>(endToEnd([&](ParameterList& tractions) {
                       for (auto const& name : names) {
                         tractions.set(name, 100.);
                       }
                     }),
                     world());
    });
  };
  expectParts(refused({"west"}), {"Friction / Shear Traction has no value for the fault 'east'"});
  expectParts(refused({"west", "aest"}),
              {"Friction / Shear Traction / aest: 'aest' is neither a region of the mesh nor a "
               "fault. Did you mean 'west'?"});
}

TEST(FaultLoads, KeepGravityBesideATractionInTime)
{
  auto const problem = makeProblem<2>(
    column([](auto& deck) { deck.sublist("Friction").set("Shear Traction", "t"); }), world());
  const auto load = problem.model.body.vector();
  problem.model.body.load(3, *load);
  auto const along_axes =
    fem::alongAxes(problem.discretisation.frames(), *problem.model.body.dofs, *load);
  double fx = 0, fy = 0;
  for (std::size_t i = 0; i < along_axes.size(); i += 2) {
    fx += along_axes[i];
    fy += along_axes[i + 1];
  }
  EXPECT_NEAR(fx, 3 * 2, 1e-12);
  EXPECT_NEAR(fy, -1000 * 10 * 4, 1e-9);
}

TEST(FaultLoads, FollowANormalStressInTimeAndClipTension)
{
  auto const problem =
    makeProblem<2>(strip([](auto& deck) {
                     deck.sublist("Friction").set("Normal Stress", "100 * (1 + x - t)");
                     deck.sublist("Friction").set("Normal Stress Factor", 3.);
                   }),
                   world());
  auto const& fault = problem.model.fault;
  EXPECT_EQ(valuesOf(problem.model.initial.sigma_n), (std::vector<double>{300, 600, 900}));
  NodeView later("later", 3);
  fault.normalStress().at(2, later);
  EXPECT_EQ(valuesOf(later), (std::vector<double>{0, 0, 300}));
  // The kernels see it.
  BlockView v("v", 3, 1);
  Kokkos::deep_copy(v, 1e-6);
  BlockView gradient("gradient", 3, 1);
  HessianView hessian("hessian", 3, 1, 1);
  FlagView kinked("kinked", 3);
  fault.friction().linearise(v, {problem.model.initial.alpha, later}, gradient, hessian, kinked);
  const auto force = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gradient);
  EXPECT_EQ(force(0, 0), 0);
  EXPECT_GT(force(2, 0), 0);
  EXPECT_EQ(valuesOf(problem.model.initial.sigma_n), (std::vector<double>{300, 600, 900}));

  auto const constant = makeProblem<2>(strip(), world());
  EXPECT_FALSE(constant.model.fault.normalStress().dependsOnTime());
}

TEST(FaultLoads, RefuseATensileNormalStressAtTheStart)
{
  const auto deck =
    strip([](auto& given) { given.sublist("Friction").set("Normal Stress", "100 * (x - 1)"); });
  expectRefusal(
    [&] { makeProblem<2>(deck, world()); },
    {"Asperity / Friction / Normal Stress = -100", "(0, 0)", "[0, inf)", "compression"});
}

TEST(Problem, WantsTheNormalStressOfAnAntisymmetricFault)
{
  const auto deck = column([](auto& given) {
    given.sublist("Boundary Conditions").sublist("Fault").set("Type", "Antisymmetric Fault");
  });
  expectRefusal([&] { makeProblem<2>(deck, world()); },
                {"Asperity / Friction / Normal Stress", "antisymmetric"});
}

TEST(Problem, HasNoMassButARadiationDampingIfQuasiDynamic)
{
  auto const inertial = makeProblem<2>(strip(), world());
  auto const quasi = makeProblem<2>(
    strip([](auto& deck) { deck.sublist("Bulk").set("Dynamics", "Quasi-dynamic"); }), world());
  EXPECT_GT(inertial.model.body.matrices.mass->getFrobeniusNorm(), 0);
  EXPECT_EQ(inertial.model.body.matrices.viscosity->getFrobeniusNorm(), 0);
  EXPECT_EQ(quasi.model.body.matrices.mass->getFrobeniusNorm(), 0);
  EXPECT_EQ(quasi.model.initial.a->normInf(), 0);
  // eta V with eta = G / (2 cs) and V = 2 v is the impedance of one side, over 2 m of fault.
  const auto v = quasi.model.body.vector();
  const auto force = quasi.model.body.vector();
  v->putScalar(3);
  quasi.model.body.matrices.viscosity->apply(*v, *force);
  const double impedance = std::sqrt(1000 * 1e6);
  EXPECT_NEAR(v->dot(*force), 2 * impedance * 9, 1e-9 * impedance);
}

TEST(Problem, RefusesToAbsorbWavesThatDoNotExist)
{
  const auto deck = strip([](auto& given) {
    given.sublist("Bulk").set("Dynamics", "Quasi-dynamic");
    given.sublist("Boundary Conditions").sublist("Far").set("Boundary", "top");
    given.sublist("Boundary Conditions").sublist("Far").set("Type", "Absorbing");
  });
  expectRefusal([&] { makeProblem<2>(deck, world()); }, {"'top'", "Absorbing", "Inertial"});
}

TEST(Problem, PutsDashpotsOnAbsorbingBoundaries)
{
  auto const problem = makeProblem<2>(strip([](auto& given) {
                                        auto& far =
                                          given.sublist("Boundary Conditions").sublist("Far");
                                        far.set("Boundary", "top").set("Type", "Absorbing");
                                      }),
                                      world());
  const auto v = problem.model.body.vector();
  const auto force = problem.model.body.vector();
  v->putScalar(3);
  problem.model.body.matrices.viscosity->apply(*v, *force);
  const double impedance = std::sqrt(1000 * 1e6);
  EXPECT_NEAR(v->dot(*force), 2 * impedance * 9, 1e-9 * impedance);
}
} // namespace asperity::scenario
