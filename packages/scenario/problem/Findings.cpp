#include "scenario/problem/Findings.hpp"

#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/checks/MaterialContrast.hpp"
#include "dynamics/checks/PlausibleValues.hpp"
#include "fem/motions/BodyPieces.hpp"
#include "scenario/problem/InitialState.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/StressMisfit.hpp"
#include "scenario/setup/rock/VolumetricSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace asperity::scenario
{
namespace
{
void append(std::vector<Warning> const& more, std::vector<Warning>& warnings)
{
  warnings.insert(warnings.end(), more.begin(), more.end());
}

dynamics::Extremes extremesOf(std::vector<double> const& values, Communicator const& communicator)
{
  dynamics::Extremes mine{std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
  for (const double value : values) {
    mine = {std::min(mine.smallest, value), std::max(mine.largest, value)};
  }
  return {minOverRanks(mine.smallest, communicator), maxOverRanks(mine.largest, communicator)};
}

dynamics::BesideFault valuesBeside(std::vector<fem::Material> const& materials,
                                   std::vector<double> const& eta, dynamics::State const& initial,
                                   int components, Communicator const& communicator)
{
  const auto extremes = [&](auto const& value) {
    std::vector<double> values;
    for (auto const& material : materials) {
      values.push_back(value(material));
    }
    return extremesOf(values, communicator);
  };
  using fem::Material;
  auto const sigma_n = toHost(initial.sigma_n);
  return {extremes([](Material const& m) { return m.density; }),
          extremes([](Material const& m) { return m.shear_modulus; }),
          extremes([](Material const& m) { return m.shearImpedance() / m.density; }),
          extremes([](Material const& m) { return m.compressionalImpedance() / m.density; }),
          extremesOf(eta, communicator),
          extremesOf({sigma_n.data(), sigma_n.data() + sigma_n.extent(0)}, communicator),
          components == 1};
}

// A warning where unlike rocks, inertia, and friction that follows the normal stress at once meet.
template <int Dim>
std::optional<Warning> warnOfContrast(SetupContext<Dim> const& context)
{
  auto const& mesh = context.discretisation.mesh;
  auto const& surface = *context.site.surface;
  auto const& bulk = context.settings.lists.bulk;
  if (!surface.otherSide().is_inside || context.settings.bulk.isQuasiDynamic() ||
      !context.settings.friction.followsAtOnce()) {
    return std::nullopt;
  }
  auto const plus = dynamics::placesBeside(mesh, surface, fem::Side::plus);
  auto const minus = dynamics::placesBeside(mesh, surface, fem::Side::minus);
  std::vector<fem::Material> above, below;
  onEveryRank(*surface.communicator(), [&] {
    above = elasticRockAt(context.settings.bulk, bulk, mesh, plus.cells, plus.places);
    below = elasticRockAt(context.settings.bulk, bulk, mesh, minus.cells, minus.places);
  });
  return dynamics::warnOfContrast(
    dynamics::materialContrast(plus.places, above, below, *surface.communicator()),
    context.settings.friction.change);
}
} // namespace

template <int Dim>
Findings findingsOf(SetupContext<Dim> const& context, dynamics::Model const& model,
                    ShearTraction const& traction, StaticStart const& start,
                    std::vector<Warning> const& of_stress)
{
  auto const& friction = context.settings.lists.friction;
  auto const& mesh = context.discretisation.mesh;
  auto const& rock = context.discretisation.rock;
  auto const& site = context.site;
  const bool has_fault = site.surface->numGlobalNodes() > 0;
  auto values_beside =
    valuesBeside(has_fault ? site.materials : rock.materials, site.radiation_damping, model.initial,
                 context.components(), context.communicator());
  values_beside.has_fault = has_fault;

  Findings findings;
  findings.largest_slip_rate = dynamics::largestSlipRate(values_beside);
  findings.remarks.push_back(dynamics::describeSpeeds(values_beside));
  for (auto const& process : model.fault.processes()) {
    auto const of_process = process->remarks();
    findings.remarks.insert(findings.remarks.end(), of_process.begin(), of_process.end());
  }

  auto& warnings = findings.warnings;
  append(fem::warnOfPieces(mesh, context.discretisation.dofs->communicator()), warnings);
  append(warnOfLocking(context.settings.bulk, rock, context.communicator()), warnings);
  append(dynamics::warnOfImplausibleValues(values_beside), warnings);
  if (context.settings.friction.laws.hasFrictionLaw()) {
    append(warnOfImplausibleFriction(friction, site.nodes, context.communicator()), warnings);
  }
  append(of_stress, warnings);
  std::optional<Warning> of_rock;
  // A static displacement has stress of its own.
  if (rock.yielding && !(start.displacement->normInf() > 0)) {
    of_rock = warnOfStressAtStart(context.settings.lists.bulk, friction, context.components(), mesh,
                                  *rock.yielding, site.nodes, *site.surface, traction.at(0));
  }
  for (auto const& warning :
       {of_rock, warnOfUp(context.settings.bulk, Dim, context.discretisation.upright),
        warnOfContrast(context), warnOfVelocity(context)}) {
    if (warning) {
      warnings.push_back(*warning);
    }
  }
  return findings;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template Findings findingsOf(SetupContext<Dim> const&, dynamics::Model const&,                   \
                               ShearTraction const&, StaticStart const&,                           \
                               std::vector<Warning> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
