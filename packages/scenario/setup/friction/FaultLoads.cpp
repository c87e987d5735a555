#include "scenario/setup/friction/FaultLoads.hpp"

#include "base/Errors.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/conditions/PlateRate.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
std::vector<double> const& slipDirection(FrictionSettings const& settings)
{
  auto const& given = settings.slip_direction;
  ASPERITY_REQUIRE(given.size() == 3 && std::hypot(given[0], given[1], given[2]) > 0,
                   joinPath(friction_path, friction_entries::slip_direction)
                     << " needs three numbers, not all zero: where the shear traction points.");
  return given;
}
} // namespace

ShearTraction::ShearTraction(FrictionSettings const& settings, ParameterList const& friction,
                             FieldNodes const& nodes, fem::FaultSurface const& surface,
                             fem::NodalFrames const& frames)
    : size_(friction, friction_entries::shear_traction, friction_path, nodes)
{
  if (nodes.dimension == 2) {
    direction_.assign(surface.numNodes(), 1.);
    return;
  }
  if (surface.numSliding() == 0 &&
      friction.getEntry(friction_entries::shear_traction).isDefault()) {
    // No one asks for the direction, and the default need not lie along the fault.
    direction_.assign(static_cast<std::size_t>(surface.numNodes()) * surface.numTangents(), 0.);
    return;
  }
  auto const towards = slipDirection(settings);
  for (int node = 0; node < surface.numNodes(); ++node) {
    auto const projected = directionAlongFault(
      towards, frames, surface, node, joinPath(friction_path, friction_entries::slip_direction));
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
} // namespace asperity::scenario
