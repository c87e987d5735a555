#include "base/Errors.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"

#include <array>
#include <memory>
#include <string>

namespace asperity::scenario
{
namespace
{
constexpr std::array<char const*, 3> component_names = {"Traction X", "Traction Y", "Traction Z"};
constexpr char const* pressure_name = "Pressure";

// The axis of a component of the displacement: z in antiplane motion.
int axisOf(int component, int components) { return components == 1 ? 2 : component; }

void refuseMissingAxes(BoundaryCondition const& condition, int components)
{
  const auto refuse = [&](char const* entry, char const* why) {
    ASPERITY_REQUIRE(!isGiven(condition.list, entry), joinPath(condition.name, entry)
                                                        << " has no effect: " << why
                                                        << ". Remove it.");
  };
  if (components == 1) {
    for (auto const* entry : {component_names[0], component_names[1], pressure_name}) {
      refuse(entry, "an antiplane body moves along z alone");
    }
  } else if (components == 2) {
    refuse(component_names[2], "a body in plane strain does not move along z");
  }
}

template <int Dim>
void prescribedTraction(BoundaryCondition const& condition, ConditionContext const& setting,
                        BoundaryConditions<Dim>& result)
{
  refuseMissingAxes(condition, setting.components);
  std::array<std::shared_ptr<const Field>, 3> along;
  bool is_given = false, depends_on_time = false;
  const auto note = [&](std::shared_ptr<const Field> const& field) {
    is_given = is_given || field;
    depends_on_time = depends_on_time || (field && field->dependsOnTime());
    return field;
  };
  for (int c = 0; c < setting.components; ++c) {
    along[c] = note(fieldIfGiven(condition, component_names[axisOf(c, setting.components)]));
  }
  auto const pressure = note(fieldIfGiven(condition, pressure_name));
  ASPERITY_REQUIRE(is_given, condition.name
                               << " (Prescribed Traction) says nothing about the traction. Give "
                               << (setting.components == 1   ? "'Traction Z'."
                                   : setting.components == 2 ? "'Traction X', 'Traction Y' or "
                                                               "'Pressure'."
                                                             : "'Traction X', 'Traction Y', "
                                                               "'Traction Z' or 'Pressure'."));
  result.tractions.push_back(
    {condition.boundary,
     [along, pressure](std::array<double, 3> const& x, std::array<double, 3> const& n, double t) {
       std::array<double, 3> traction{};
       const double inward = pressure ? (*pressure)(x, t, 0) : 0;
       for (int c = 0; c < 3; ++c) {
         traction[c] = (along[c] ? (*along[c])(x, t, 0) : 0) - inward * n[c];
       }
       return traction;
     },
     depends_on_time});
}

struct PrescribedTraction
{
  static constexpr char const* meaning =
    "this traction acts on the boundary, which moves freely; its motion is written as that of the "
    "surface if there is no Free Surface.";
  static constexpr auto decides_on = DecidesOn::traction;
  static constexpr bool is_open = true;

  static void declare(Declare& declare)
  {
    for (char const* name : component_names) {
      declare
        .field(
          name, optional, "Pa", Range::any(),
          "Prescribed Traction: this component of the traction acts on the body, 0 if it is left "
          "out. A function of x, y, z and t.")
        .withoutDatasets();
    }
    declare
      .field(pressure_name, optional, "Pa", Range::any(),
             "Prescribed Traction: this is a pressure on the boundary, inwards, in addition to the "
             "components.")
      .withoutDatasets();
  }

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const& context,
                  BoundaryConditions<Dim>& result)
  {
    prescribedTraction(condition, context, result);
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Prescribed Traction", BoundaryKindOf<PrescribedTraction>)
} // namespace asperity::scenario
