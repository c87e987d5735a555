#include "io/TextFormat.hpp"
#include "platforms/parts/GlobalSeries.hpp"
#include "platforms/parts/RuptureTimes.hpp"
#include "platforms/parts/SlipProfiles.hpp"
#include "platforms/parts/Stations.hpp"

namespace asperity::platforms
{
namespace
{
bool hasFluid(io::FieldRegistry const& fields) { return fields.hasField("fault", "pore_pressure"); }

constexpr char const* of_darcy = "darcy_velocity";
const Column pressure_column{"Pore pressure (MPa)", "pore_pressure", "pore_pressure",
                             first_component, megapascal};
const Column state_column{"State (log10 s)", "state", "theta", first_component, decimalLogarithm};

Columns seasFaultInSpace(catalogue::FaultPlane const& plane, io::FieldRegistry const& fields)
{
  Columns columns{
    {"Slip along strike (m)", "slip_2", "slip", plane.strike, unchanged},
    {"Slip down dip (m)", "slip_3", "slip", plane.dip, unchanged},
    {"Slip rate along strike (log10 m/s)", "slip_rate_2", "slip_velocity", plane.strike,
     logarithmOfSize},
    {"Slip rate down dip (log10 m/s)", "slip_rate_3", "slip_velocity", plane.dip, logarithmOfSize},
    {"Shear stress along strike (MPa)", "shear_stress_2", "traction", plane.strike, megapascal},
    {"Shear stress down dip (MPa)", "shear_stress_3", "traction", plane.dip, megapascal}};
  if (hasFluid(fields)) {
    columns.insert(
      columns.end(),
      {pressure_column,
       {"Darcy velocity along strike (m/s)", "darcy_vel_2", of_darcy, plane.strike, unchanged},
       {"Darcy velocity down dip (m/s)", "darcy_vel_3", of_darcy, plane.dip, unchanged}});
  }
  columns.push_back(state_column);
  return columns;
}

Columns seasFault(ModelView const& view, io::FieldRegistry const& fields)
{
  if (view.plane) {
    return seasFaultInSpace(*view.plane, fields);
  }
  const Direction slip{view.thrust_sign, 0, 0};
  Columns columns{
    {"Slip (m)", "slip", "slip", slip, unchanged},
    {"Slip rate (log10 m/s)", "slip_rate", "slip_rate", first_component, decimalLogarithm},
    {"Shear stress (MPa)", "shear_stress", "traction", slip, megapascal}};
  if (!view.antiplane) {
    columns.push_back(
      {"Normal stress (MPa)", "normal_stress", "normal_stress", first_component, megapascal});
  }
  if (view.antiplane && hasFluid(fields)) {
    columns.insert(
      columns.end(),
      {pressure_column, {"Darcy velocity down (m/s)", "darcy_vel", of_darcy, down, unchanged}});
  }
  columns.push_back(state_column);
  return columns;
}

Columns seasBodyInSpace(catalogue::FaultPlane const& plane)
{
  return {{"Displacement from the fault (m)", "disp_1", "displacement", plane.inward, unchanged},
          {"Displacement along strike (m)", "disp_2", "displacement", plane.strike, unchanged},
          {"Displacement down (m)", "disp_3", "displacement", plane.down, unchanged},
          {"Velocity from the fault (m/s)", "vel_1", "velocity", plane.inward, unchanged},
          {"Velocity along strike (m/s)", "vel_2", "velocity", plane.strike, unchanged},
          {"Velocity down (m/s)", "vel_3", "velocity", plane.down, unchanged}};
}

Columns seasBody(ModelView const& view)
{
  if (view.plane) {
    return seasBodyInSpace(*view.plane);
  }
  if (view.antiplane) {
    return {{"Displacement (m)", "disp", "displacement", first_component, unchanged},
            {"Velocity (m/s)", "vel", "velocity", first_component, unchanged}};
  }
  auto const& second = view.is_level ? second_component : down;
  return {{"Displacement 1 (m)", "disp_1", "displacement", first_component, unchanged},
          {"Displacement 2 (m)", "disp_2", "displacement", second, unchanged},
          {"Velocity 1 (m/s)", "vel_1", "velocity", first_component, unchanged},
          {"Velocity 2 (m/s)", "vel_2", "velocity", second, unchanged}};
}

// The stations of BP3, the problem in plane strain, are at the surface, hence srfst_.
std::string seasBodyPrefix(ModelView const& view)
{
  return view.plane || view.antiplane ? "blkst_" : "srfst_";
}

std::vector<std::string> seasStepLines(StepFacts const& facts)
{
  const double shortest = facts.count > 0 ? facts.shortest : 0;
  return {stepSizeLine("minimum_time_step", shortest),
          stepSizeLine("maximum_time_step", facts.longest), countLine(facts.count)};
}

// The platform for sequences of earthquakes and aseismic slip.
class Seas : public io::TextFormat
{
public:
  Teuchos::RCP<const Teuchos::ParameterList> validParameters() const override
  {
    return RunFacts::declare("SEAS Benchmark").list();
  }

  std::vector<std::string> files() const override
  {
    return {"seas/fltst_*",    "seas/blkst_*",     "seas/srfst_*",
            "seas/global.dat", "seas/rupture.dat", "seas/slip.dat"};
  }

  std::unique_ptr<io::Output> make(Teuchos::ParameterList const& parameters,
                                   io::OutputContext const& context,
                                   io::Offers const& offers) const override
  {
    const Platform platform{"SEAS", "seas", RunFacts::from(parameters, context), seasStepLines};
    auto files = std::make_unique<PlatformFiles>();
    if (auto const* receivers = offers.find<catalogue::Receivers>()) {
      addStations(
        *files, platform, context, *receivers,
        [&context](ModelView const& view) {
          requireFriction("SEAS", context.fields);
          return Stations::Kind{"fltst_", "on fault", seasFault(view, context.fields)};
        },
        [](ModelView const& view) {
          return Stations::Kind{seasBodyPrefix(view), "off fault", seasBody(view)};
        });
    }
    if (auto const* global = offers.find<catalogue::Global>()) {
      files->add("global", std::make_unique<GlobalSeries>(platform, context, *global));
    }
    if (auto const* rupture = offers.find<catalogue::Rupture>()) {
      files->add("rupture", std::make_unique<RuptureTimes>(platform, context, "rupture.dat",
                                                           "x2 x3 t", *rupture));
    }
    auto const* history = offers.find<io::FaultHistory>();
    if (history && context.domain("fault").isCurve()) {
      files->add("slip", std::make_unique<SlipProfiles>(platform, context, *history));
    }
    return files;
  }
};
} // namespace

ASPERITY_REGISTER(io::TextFormatRegistry, "SEAS", Seas)
} // namespace asperity::platforms
