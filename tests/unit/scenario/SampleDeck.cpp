#include "SampleDeck.hpp"

#include "mesh/Regions.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/parallel/Partition.hpp"
#include "scenario/DeckParameters.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>

namespace asperity::scenario::test
{
RCP<const Communicator> world() { return rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)); }

ParameterList shortDeck()
{
  ParameterList deck("Asperity");
  auto& mesh = deck.sublist("Mesh");
  mesh.set("Type", "Rectangle");
  mesh.sublist("Rectangle").set("Width", 2.).set("Height", 2.).set("Cells X", 2).set("Cells Y", 2);
  auto& bulk = deck.sublist("Bulk");
  bulk.set("Density", 1000.).set("Shear Modulus", 1e6).set("Bulk Modulus", 2e6);
  bulk.set("Gravitational Acceleration", 10.);
  auto& friction = deck.sublist("Friction");
  friction.set("a", 0.01).set("b", 0.015).set("L", 1e-5);
  auto& conditions = deck.sublist("Boundary Conditions");
  conditions.sublist("Fault").set("Boundary", "bottom").set("Type", "Bilateral Contact");
  conditions.sublist("Left").set("Boundary", "left").set("Type", "Sliding Wall");
  auto& time = deck.sublist("Time Stepping");
  time.set("Final Time", 10.).set("Largest Step", 1.).set("Smallest Step", 1e-3);
  deck.sublist("Output").sublist("Event Catalogue").set("Threshold", 1e-3);
  return deck;
}

ParameterList completeDeck(std::function<void(ParameterList&)> const& change)
{
  auto deck = shortDeck();
  change(deck);
  completeAndValidate(deck, *deckParameters(), "Asperity");
  return deck;
}

ParameterList column(std::function<void(ParameterList&)> const& change)
{
  return completeDeck([&](ParameterList& deck) {
    auto& right = deck.sublist("Boundary Conditions").sublist("Right");
    right.set("Boundary", "right").set("Type", "Sliding Wall");
    change(deck);
  });
}

ParameterList strip(std::function<void(ParameterList&)> const& change)
{
  return completeDeck([&](ParameterList& deck) {
    deck.sublist("Bulk").set("Model", "Antiplane").set("Gravitational Acceleration", 0.);
    deck.sublist("Friction").set("Normal Stress", 1e4);
    auto& conditions = deck.sublist("Boundary Conditions");
    conditions.remove("Left");
    conditions.sublist("Fault").set("Type", "Antisymmetric Fault");
    deck.sublist("Initial State").set("Displacement", "Zero");
    change(deck);
  });
}

double steadyStress(double V)
{
  const double a = 0.01, b = 0.015, reference_rate = 1e-6, reference_friction = 0.6;
  const double state = reference_friction + b * std::log(reference_rate / V);
  return 1e4 * a * std::asinh(V / (2 * reference_rate) * std::exp(state / a));
}

std::vector<double> valuesOf(ConstNodeView const& view) { return toVector(view); }

std::vector<double> valuesOf(Vector const& x)
{
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  return {view.data(), view.data() + view.extent(0)};
}

Mesh<2> twoRegions()
{
  mesh::RectangleShape shape;
  shape.width = 2;
  shape.cells_x = 4;
  auto whole = mesh::rectangleMesh(shape);
  const mesh::NamedCondition<2> left = {"left", [](Point<2> const& x) { return x[0] < 1; }};
  const mesh::NamedCondition<2> right = {"right", [](Point<2> const& x) { return x[0] > 1; }};
  mesh::overrideRegions<2>(whole, {left, right});
  return mesh::distribute(whole, *world());
}

std::vector<double> weightsOf(fem::FaultSurface const& surface)
{
  std::vector<double> weights;
  for (auto const& node : surface) {
    weights.push_back(node.weight);
  }
  return weights;
}

void expectNear(std::vector<double> const& found, std::vector<double> const& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-12 * std::abs(expected[i])) << i;
  }
}

std::vector<std::vector<int>> heldComponents(fem::FaultSurface const& surface)
{
  std::vector<std::vector<int>> held;
  for (int node = 0; node < surface.numNodes(); ++node) {
    held.emplace_back();
    for (int k = 0; k < surface.numTangents(); ++k) {
      held.back().push_back(surface.held(node, k) ? 1 : 0);
    }
  }
  return held;
}
} // namespace asperity::scenario::test
