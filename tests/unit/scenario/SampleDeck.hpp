#pragma once

#include "base/Types.hpp"
#include "fem/FaultSurface.hpp"
#include "friction/Types.hpp"
#include "mesh/Mesh.hpp"
#include "parameters/Parameters.hpp"
#include "unit/base/Refusal.hpp"

#include <functional>
#include <string>

namespace asperity::scenario::test
{
// For all tests of this package, which say `using namespace test`.
using asperity::test::array;
using asperity::test::expectParts;
using asperity::test::expectRefusal;
using asperity::test::refusal;

RCP<const Communicator> world();

// Two by two squares of a metre on a fault, under gravity; only what has no default.
ParameterList shortDeck();

// The short deck after the change, completed.
ParameterList completeDeck(std::function<void(ParameterList&)> const& change = [](auto&) {});

// The short deck with another wall on the right: a column, which presses on the fault with its
// weight.
ParameterList column(std::function<void(ParameterList&)> const& change = [](auto&) {});

// An antiplane strip on an antisymmetric fault at normal stress 1e4 Pa and zero displacement, its
// top left free. Steady sliding at V needs a shear traction of steadyStress(V) [Pa].
ParameterList strip(std::function<void(ParameterList&)> const& change = [](auto&) {});
double steadyStress(double V);

std::vector<double> valuesOf(ConstNodeView const& view);
std::vector<double> valuesOf(Vector const& x);
// Of the fault nodes.
std::vector<double> weightsOf(fem::FaultSurface const& surface);
// Within 1e-12 of each expected value.
void expectNear(std::vector<double> const& found, std::vector<double> const& expected);
// (num_nodes, T): 1 where the velocity is prescribed.
std::vector<std::vector<int>> heldComponents(fem::FaultSurface const& surface);

// A rectangle of two regions, "left" (x < 1) and "right", on this rank.
Mesh<2> twoRegions();
} // namespace asperity::scenario::test
