// A traction of your own: water stands on the boundary.
// scenario/setup/conditions/BoundaryKind.hpp says what a condition has to have.
#include "base/Errors.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"

#include <algorithm>
#include <array>
#include <optional>

using namespace asperity;
using namespace asperity::scenario;

namespace
{
// sigma n = -w max(h - z, 0) n, where z is the height of the place.
struct WaterLoad
{
  static constexpr char const* meaning = "water stands on the boundary, up to a level.";
  static constexpr auto decides_on = DecidesOn::traction;
  static constexpr bool is_open = true; // the body moves freely

  std::optional<double> weight; // w [N/m^3], else 9810

  // They join those of other types, so that none has a default.
  static Entries<WaterLoad> entries(ParameterList& list)
  {
    Entries<WaterLoad> entries({}, list);
    entries.others()
      .field("Water Level", optional, "m", Range::any(),
             "Water Load: the height of the water, along y, in space along z; a number or an "
             "expression in t.")
      .withoutDatasets();
    return entries.real("Specific Weight", &WaterLoad::weight, optional, "N/m^3", Range::positive(),
                        "Water Load: the weight of the water per volume, 9810 if it is left out.");
  }
  static void declare(Declare& declare) { entries(*declare.list()); }

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const& context,
                  BoundaryConditions<Dim>& result)
  {
    ParameterList declared;
    const double weight =
      entries(declared).read(condition.list, condition.name).weight.value_or(9810);
    auto const level = fieldIfGiven(condition, "Water Level");
    ASPERITY_REQUIRE(level, joinPath(condition.name, "Water Level")
                              << " is missing: how high the water stands.");
    ASPERITY_REQUIRE(context.components == Dim,
                     condition.name << ": water does not load an antiplane body. Choose another "
                                       "Type.");
    result.tractions.push_back(
      {condition.boundary,
       [level, weight](std::array<double, 3> const& x, std::array<double, 3> const& n, double t) {
         const double pressure = weight * std::max((*level)(x, t, 0) - x[Dim - 1], 0.);
         return std::array<double, 3>{-pressure * n[0], -pressure * n[1], -pressure * n[2]};
       },
       level->dependsOnTime()});
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Water Load", BoundaryKindOf<WaterLoad>)
