#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "io/TextFormat.hpp"
#include "platforms/parts/RuptureTimes.hpp"
#include "platforms/parts/Stations.hpp"

#include <array>
#include <cmath>

namespace asperity::platforms
{
namespace
{
// Thermal pressurisation, the only process of this platform that changes the normal stress.
bool isHot(io::FieldRegistry const& fields) { return fields.hasField("fault", "fluid_pressure"); }

// theta where the state law has it, psi where friction depends on that, else no state.
void addState(Columns& columns, io::FieldRegistry const& fields)
{
  if (fields.hasField("fault", "theta")) {
    columns.push_back({"log10 of state variable (log-seconds)", "log-theta", "theta",
                       first_component, decimalLogarithm});
  } else if (fields.hasField("fault", "psi")) {
    columns.push_back(
      {"state variable psi (dimensionless)", "psi", "psi", first_component, unchanged});
  }
}

void addHeat(Columns& columns, io::FieldRegistry const& fields)
{
  if (isHot(fields)) {
    columns.push_back(
      {"temperature (K)", "temperature", "temperature", first_component, unchanged});
    columns.push_back(
      {"pore pressure (MPa)", "pressure", "fluid_pressure", first_component, megapascal});
  }
}

Columns scecFault(ModelView const& view, io::FieldRegistry const& fields)
{
  const bool in_space = view.plane.has_value();
  const bool along_strike = view.antiplane || view.is_level;
  const auto along = [&](char const* field) { return in_space || along_strike ? field : nullptr; };
  const auto down = [&](char const* field) { return in_space || !along_strike ? field : nullptr; };
  const Direction h = in_space ? view.plane->strike : first_component;
  const Direction v = in_space ? view.plane->dip : first_component;
  char const* rate = in_space ? "slip_velocity" : "slip_rate";
  Columns columns = {
    {"horizontal slip (m)", "h-slip", along("slip"), h, unchanged},
    {"horizontal slip rate (m/s)", "h-slip-rate", along(rate), h, unchanged},
    {"horizontal shear stress (MPa)", "h-shear-stress", along("traction"), h, megapascal},
    {"vertical slip (m)", "v-slip", down("slip"), v, unchanged},
    {"vertical slip rate (m/s)", "v-slip-rate", down(rate), v, unchanged},
    {"vertical shear stress (MPa)", "v-shear-stress", down("traction"), v, megapascal},
    {isHot(fields) ? "effective normal stress (MPa)" : "normal stress (MPa)", "n-stress",
     isHot(fields) ? "effective_normal_stress" : "normal_stress", first_component, megapascal}};
  addState(columns, fields);
  addHeat(columns, fields);
  return columns;
}

// The directions along strike, vertical and across the fault; null: the model has none.
using BodyDirections = std::array<std::optional<Direction>, 3>;

BodyDirections bodyDirections(ModelView const& view)
{
  if (view.plane) {
    return {view.plane->strike, view.plane->down, view.plane->inward};
  }
  if (view.antiplane) {
    return {first_component, std::nullopt, std::nullopt};
  }
  return view.is_level ? BodyDirections{first_component, std::nullopt, second_component}
                       : BodyDirections{std::nullopt, second_component, first_component};
}

Columns scecBody(ModelView const& view)
{
  const auto [h, v, n] = bodyDirections(view);
  const auto column = [](char const* description, char const* name, char const* field,
                         std::optional<Direction> const& direction) {
    return Column{description, name, direction ? field : nullptr,
                  direction.value_or(first_component), unchanged};
  };
  return {column("horizontal displacement (m)", "h-disp", "displacement", h),
          column("horizontal velocity (m/s)", "h-vel", "velocity", h),
          column("vertical displacement (m)", "v-disp", "displacement", v),
          column("vertical velocity (m/s)", "v-vel", "velocity", v),
          column("normal displacement (m)", "n-disp", "displacement", n),
          column("normal velocity (m/s)", "n-vel", "velocity", n)};
}

// A run over cycles would fill any disk.
void requireFewRows(double final_time, double time_step)
{
  constexpr double most = 1e7; // more than a day of the platform's time step
  ASPERITY_REQUIRE(final_time <= most * time_step,
                   "Asperity / Output / SCEC / Time Step = "
                     << formatShort(time_step) << " s gives each receiver "
                     << formatShort(std::floor(final_time / time_step))
                     << " rows until Final Time = " << formatShort(final_time)
                     << " s. These files are for single ruptures, with at most 1e7 rows. Choose "
                        "another Text Format, such as SEAS, or a larger Time Step.");
}

// The platform of the codes for spontaneous rupture.
class Scec : public io::TextFormat
{
public:
  Teuchos::RCP<const Teuchos::ParameterList> validParameters() const override
  {
    return RunFacts::declare("TPV")
      .real("Time Step", 0.01, "s", Range::positive(),
            "The rows are this time apart; the platform demands equally spaced times.")
      .list();
  }

  std::vector<std::string> files() const override
  {
    return {"scec/fault*", "scec/body*", "scec/cplot"};
  }

  std::unique_ptr<io::Output> make(Teuchos::ParameterList const& parameters,
                                   io::OutputContext const& context,
                                   io::Offers const& offers) const override
  {
    const double time_step = parameters.get<double>("Time Step");
    requireFewRows(context.final_time, time_step);
    const auto step_lines = [time_step](StepFacts const& facts) {
      return std::vector<std::string>{stepSizeLine("time_step", time_step), countLine(facts.count)};
    };
    const Platform platform{"SCEC", "scec", RunFacts::from(parameters, context), step_lines};
    auto files = std::make_unique<PlatformFiles>();
    if (auto const* receivers = offers.find<catalogue::Receivers>()) {
      addStations(
        *files, platform, context, *receivers,
        [=, &context](ModelView const& view) {
          requireFriction("SCEC", context.fields);
          return Stations::Kind{"fault", "on fault", scecFault(view, context.fields), time_step};
        },
        [=](ModelView const& view) {
          return Stations::Kind{"body", "off fault", scecBody(view), time_step};
        });
    }
    if (auto const* rupture = offers.find<catalogue::Rupture>()) {
      files->add("rupture",
                 std::make_unique<RuptureTimes>(platform, context, "cplot", "j k t", *rupture));
    }
    return files;
  }
};
} // namespace

ASPERITY_REGISTER(io::TextFormatRegistry, "SCEC", Scec)
} // namespace asperity::platforms
