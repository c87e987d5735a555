#include "scenario/setup/friction/FaultLoads.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/conditions/PlateRate.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::scenario
{
namespace
{
std::vector<double> compression(std::vector<double> values, double factor)
{
  for (double& value : values) {
    value = factor * std::max(value, 0.);
  }
  return values;
}

std::vector<double> givenStress(NodalField const& field, FieldNodes const& nodes)
{
  auto const values = field.at(0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASPERITY_REQUIRE(values[i] >= 0, joinPath(friction_path, "Normal Stress")
                                       << " = " << values[i] << " at x = " << nodes.text(i)
                                       << ", t = 0, is outside [0, inf). Check the sign: "
                                          "compression is positive.");
  }
  return values;
}

// Of the pressure(num_nodes) of the static solution, where it is negative by more than rounding.
std::vector<Warning> tensionAtStart(std::vector<double> const& pressure,
                                    fem::FaultSurface const& surface)
{
  constexpr double rounding = 1e-9; // of the largest pressure
  auto const& communicator = *surface.communicator();
  double largest = 0, least = 0;
  for (const double value : pressure) {
    largest = std::max(largest, std::abs(value));
    least = std::min(least, value);
  }
  largest = maxOverRanks(largest, communicator);
  const double lowest = minOverRanks(least, communicator);
  std::array<double, 2> measure{};
  int first = -1;
  for (int node = 0; node < surface.numNodes(); ++node) {
    const double weight = surface.slides(node) ? surface[node].weight : 0;
    measure[0] += pressure[node] < -rounding * largest ? weight : 0;
    measure[1] += weight;
    first = pressure[node] == lowest && first < 0 ? node : first;
  }
  measure = sumOverRanks(measure, communicator);
  if (!(measure[0] > 0)) {
    return {};
  }
  const int rank = communicator.getRank(), none = communicator.getSize();
  const int of_place = minOverRanks(first < 0 ? none : rank, communicator);
  auto const place =
    sumOverRanks(of_place == rank ? surface[first].place : std::array<double, 3>{}, communicator);
  return {{"tension at the start",
           "The static solution pulls at " +
             formatShort(std::round(1000 * measure[0] / measure[1]) / 10) +
             " % of the fault, most with " + formatShort(-lowest) + " Pa of tension at " +
             formatPoint({place[0], place[1], place[2]}) +
             " m: the normal stress of friction is set to zero there, and the model holds the "
             "fault shut. "
             "Check Gravity Direction, Up and the boundary conditions, or give a Normal Stress."}};
}

std::vector<double> slipDirection(ParameterList const& friction)
{
  auto const given = FrictionSettings::from(friction).slip_direction;
  ASPERITY_REQUIRE(given.size() == 3 && std::hypot(given[0], given[1], given[2]) > 0,
                   joinPath(friction_path, "Slip Direction")
                     << " needs three numbers, not all zero: where the shear traction points.");
  return given;
}
} // namespace

ShearTraction::ShearTraction(ParameterList const& friction, FieldNodes const& nodes,
                             fem::FaultSurface const& surface, fem::NodalFrames const& frames)
    : size_(Field(friction, "Shear Traction", friction_path, nodes.region_names), nodes)
{
  if (nodes.dimension == 2) {
    direction_.assign(surface.numNodes(), 1.);
    return;
  }
  if (surface.numSliding() == 0 && friction.getEntry("Shear Traction").isDefault()) {
    // No one asks for the direction, and the default need not lie along the fault.
    direction_.assign(static_cast<std::size_t>(surface.numNodes()) * surface.numTangents(), 0.);
    return;
  }
  auto const towards = slipDirection(friction);
  for (auto const& node : surface) {
    auto const projected =
      directionAlongFault(towards, frames, node, joinPath(friction_path, "Slip Direction"));
    direction_.insert(direction_.end(), projected.begin(), projected.end());
  }
}

std::vector<double> ShearTraction::at(double t) const
{
  auto const sizes = size_.at(t);
  auto result = direction_;
  const std::size_t num_tangents = sizes.empty() ? 1 : result.size() / sizes.size();
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] *= sizes[i / num_tangents];
  }
  return result;
}

std::vector<double> ShearTraction::largest(std::vector<double> const& times) const
{
  std::vector<double> result;
  for (const double t : times) {
    auto const sizes = size_.at(t);
    result.resize(sizes.size(), 0);
    std::transform(sizes.begin(), sizes.end(), result.begin(), result.begin(),
                   [](double size, double so_far) { return std::max(std::abs(size), so_far); });
  }
  return result;
}

std::function<void(double, Vector&)> loadWithTraction(
  ShearTraction const& traction, std::shared_ptr<const fem::FaultSurface> const& surface,
  std::shared_ptr<const fem::BoundaryLoad> const& boundaries, RCP<const Vector> const& constant)
{
  auto const steady = rcp(new Vector(*constant, Teuchos::Copy));
  boundaries->addSteady(*steady);
  const bool shear_varies = traction.dependsOnTime();
  if (!shear_varies) {
    fem::addTraction(*surface, traction.at(0), *steady);
  }
  return [traction, surface, boundaries, steady, shear_varies](double t, Vector& l) {
    Tpetra::deep_copy(l, *steady);
    if (shear_varies) {
      fem::addTraction(*surface, traction.at(t), l);
    }
    boundaries->addVarying(t, l);
  };
}

NormalStressOfDeck makeNormalStress(ParameterList const& friction, FieldNodes const& nodes,
                                    std::vector<double> const& pressure,
                                    fem::FaultSurface const& surface)
{
  const double factor = FrictionSettings::from(friction).normal_stress_factor;
  auto const constant = [factor](std::vector<double> const& values) {
    return dynamics::NormalStress(
      toDevice(compression(values, factor), "asperity::scenario::normalStress"));
  };
  if (!isGiven(friction, "Normal Stress")) {
    return {constant(pressure), tensionAtStart(pressure, surface)};
  }
  const NodalField given(Field(friction, "Normal Stress", friction_path, nodes.region_names),
                         nodes);
  auto const at_start = givenStress(given, nodes);
  if (!given.dependsOnTime()) {
    return {constant(at_start), {}};
  }
  return {dynamics::NormalStress([given, factor](double t, NodeView const& sigma_n) {
            Kokkos::deep_copy(sigma_n, toDevice(compression(given.at(t), factor),
                                                "asperity::scenario::normalStress"));
          }),
          {}};
}
} // namespace asperity::scenario
