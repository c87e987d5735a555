// Thermal pressurisation: slip heats the fluid in its zone, whose pressure reduces the normal
// stress (Sibson 1973; Rice 2006, doi:10.1029/2005JB004006). ShearZone.hpp has the equations.
#include "base/program/WorkTimers.hpp"
#include "dynamics/FaultProcess.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/coupling/StressScale.hpp"
#include "dynamics/processes/EffectiveStress.hpp"
#include "dynamics/processes/ShearZone.hpp"
#include "parameters/Entries.hpp"
#include "portability/Renamed.hpp"

#include <string>

namespace asperity::dynamics
{
namespace
{
constexpr char const* pressure_field = "fluid_pressure";
constexpr char const* temperature_field = "temperature";

NodeView const& pressureOf(State const& state) { return state.at(pressure_field); }

std::string nameOfMode(char const* quantity, int mode)
{
  return std::string(quantity) + "_mode_" + std::to_string(mode);
}

// The fields of the process in a state.
struct ZoneFields
{
  NodeView pressure, temperature; // at y = 0
  ShearZone::Modes modes;

  ZoneFields(State const& state, int num_modes)
  {
    pressure = pressureOf(state);
    temperature = state.at(temperature_field);
    for (int i = 0; i < num_modes; ++i) {
      modes.temperature.push_back(state.at(nameOfMode("temperature", i)));
      modes.pressure.push_back(state.at(nameOfMode("pressure", i)));
    }
  }
};

// The scale of the effective normal stress (StressScale.hpp), which is taken as 1 % of the normal
// stress at least.
void setPressureScale(ConstNodeView const& sigma_n, ConstNodeView const& p, NodeView const& scale)
{
  constexpr double least_share = 1e-2, least = 1; // of sigma_n [-]; Pa
  Kokkos::parallel_for(
    "asperity::dynamics::scaleOfPressure", RangePolicy(0, scale.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      const double share = least_share * sigma_n(node);
      const double effective = sigma_n(node) - p(node);
      scale(node) = scaleOfStress(effective > share ? effective : share, least);
    });
}

// The image p' of the pressure p at y = 0, and the heat q' from which it follows:
//   p' = rest + per_heat q',   q' = mean over the ends of the step of (friction times V)
// Friction at the end was computed with p. It changes in proportion to sigma_n - p, so that with p'
// its power is less by fall (p' - p), and q' = (twice_heat - fall (p' - p)) / 2. These two
// equations give p', which is the fixed point itself once V stays.
struct PressureAndHeat
{
  ConstFlagView slides;
  ConstNodeView weights, slip_factors;
  ConstBlockView mean_velocity, before, after; // w, and friction at the ends of the step [N]
  ConstNodeView rest, per_heat, sigma_n, p;
  NodeView image, heat; // [Pa], [W/m^2]

  KOKKOS_INLINE_FUNCTION void operator()(int node) const
  {
    double twice_heat = 0, at_end = 0; // [W/m^2]
    for (int k = 0; slides(node) && k < after.extent_int(1); ++k) {
      const double V = slip_factors(node) * mean_velocity(node, k);
      at_end += after(node, k) / weights(node) * V;
      twice_heat += (before(node, k) + after(node, k)) / weights(node) * V;
    }
    const double effective = sigma_n(node) - p(node);
    const double fall = effective > 0 && at_end > 0 ? at_end / effective : 0; // of at_end per Pa
    const double per_twice = per_heat(node) / 2;
    image(node) = (rest(node) + per_twice * (twice_heat + fall * p(node))) / (1 + per_twice * fall);
    heat(node) = (twice_heat - fall * (image(node) - p(node))) / 2;
  }
};

// The pressure at y = 0, an unknown of each step since heat depends on it. The heat of a step is
// the mean of the frictions at its ends times slip, as in EnergyBalance; none where slip is
// prescribed.
class ZonePressure : public StepUnknown
{
public:
  ZonePressure(std::shared_ptr<const ShearZone> zone, fem::FaultSurface const& surface)
      : zone_(std::move(zone))
      , weights_(surface.weights())
      , slip_factors_(surface.slipFactors())
      , slides_(surface.slidingNodes())
      , rest_("asperity::dynamics::restOfPressure", surface.numNodes())
      , per_heat_("asperity::dynamics::pressurePerHeat", surface.numNodes())
      , heat_("asperity::dynamics::heat", surface.numNodes())
      , scale_("asperity::dynamics::perPascal", surface.numNodes())
      , velocity_("asperity::dynamics::w", surface.numNodes(), surface.numTangents())
      , before_("asperity::dynamics::frictionBefore", surface.numNodes(), surface.numTangents())
      , after_("asperity::dynamics::frictionAfter", surface.numNodes(), surface.numTangents())
      , hessian_("asperity::dynamics::hessian", surface.numNodes(), surface.numTangents(),
                 surface.numTangents())
      , kinked_("asperity::dynamics::kinked", surface.numNodes())
  {
  }

  NodeView valuesIn(State const& state) const override { return pressureOf(state); }
  void begin(StepStart const& start) override
  {
    ASPERITY_TIME_WORK("thermal pressurisation");
    start.friction.linearise(start.velocity, before_, hessian_, kinked_);
    const ZoneFields from(start.from, zone_->numModes());
    zone_->pressureAfter(from.modes, start.tau, rest_, per_heat_);
    setPressureScale(start.from.sigma_n, from.pressure, scale_);
  }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    ASPERITY_TIME_WORK("thermal pressurisation");
    step.solver.faultVelocity(velocity_);
    step.friction.linearise(velocity_, after_, hessian_, kinked_);
    Kokkos::parallel_for("asperity::dynamics::balancePressure", RangePolicy(0, image.extent_int(0)),
                         PressureAndHeat{slides_, weights_, slip_factors_, step.mean_velocity,
                                         before_, after_, rest_, per_heat_, step.to.sigma_n,
                                         valuesIn(step.to), image, heat_});
    return 0;
  }
  // The modes at the end of the step follow from the heat of the last image, and give its pressure.
  bool endsWithImage() const override { return true; }
  ConstNodeView scale() const override { return scale_; }
  void complete(State const& from, double tau, State const& to) override
  {
    ASPERITY_TIME_WORK("thermal pressurisation");
    const ZoneFields before(from, zone_->numModes()), after(to, zone_->numModes());
    zone_->advance(before.modes, tau, heat_, after.modes, after.temperature);
  }

private:
  std::shared_ptr<const ShearZone> zone_;
  ConstNodeView weights_, slip_factors_;
  ConstFlagView slides_;
  NodeView rest_, per_heat_, heat_, scale_; // of the present step, heat_ [W/m^2] of the last image
  BlockView velocity_, before_, after_;     // w, and friction at the ends of the step [N]
  HessianView hessian_;
  FlagView kinked_;
};

struct ModeSettings
{
  int num_modes = 60;
};

// The entry that is a number and not a field, declared in `list`, which has the others.
Entries<ModeSettings> modeEntries(ParameterList& list)
{
  Entries<ModeSettings> entries({}, list);
  entries.integer(
    "Wavenumbers", &ModeSettings::num_modes, Range::closed(10, 1000),
    "The profiles across the fault have this number of modes. With 60, temperature and "
    "pressure at the fault are exact to 1e-5 while friction is constant.");
  return entries;
}

class ThermalPressurisation : public FaultProcess
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    auto const list =
      Declare()
        .boolean("Enabled", false, "If true, slip heats the fluid in the fault.")
        .field("Thermal Diffusivity", 1e-6, "m^2/s", Range::positive(),
               "Heat spreads across the fault with this diffusivity.")
        .field("Hydraulic Diffusivity", 4e-4, "m^2/s", Range::positive(),
               "The pressure of the fluid spreads across the fault with this diffusivity.")
        .field("Volumetric Heat Capacity", 2.7e6, "J/(m^3 K)", Range::positive(),
               "Rock with its fluid needs this heat for each kelvin.")
        .field("Pressure per Temperature", 1e5, "Pa/K", Range::positive(),
               "The pressure of the fluid rises by this for each kelvin while no fluid flows.")
        .field("Shear Zone Half Width", 0.02, "m", Range::positive(),
               "The heat of slip has the shape of a normal distribution across the fault with this "
               "standard deviation.")
        .field("Initial Temperature", 273.15, "K", Range::atLeast(0),
               "The fault starts with this temperature.")
        .field("Initial Pressure", 0., "Pa", Range::any(),
               "The fluid starts with this pressure. With 0, Normal Stress is the effective one at "
               "the start.")
        .list();
    modeEntries(*list);
    return list;
  }
  static std::string meaning()
  {
    return "Thermal pressurisation: friction heats the fluid in a zone across each place of the "
           "fault, and the pressure of the fluid reduces the normal stress.";
  }

  ThermalPressurisation(Teuchos::ParameterList const& parameters,
                        FaultProcessContext const& context)
  {
    const auto values = [&](char const* name) {
      return toDevice(context.values(name), "asperity::dynamics::shearZone");
    };
    ParameterList declared;
    zone_ = std::make_shared<ShearZone>(
      ShearZone::Properties{values("Thermal Diffusivity"), values("Hydraulic Diffusivity"),
                            values("Volumetric Heat Capacity"), values("Pressure per Temperature"),
                            values("Shear Zone Half Width"), values("Initial Temperature"),
                            values("Initial Pressure")},
      modeEntries(declared).read(parameters, context.path).num_modes);
    unknown_ = std::make_shared<ZonePressure>(zone_, context.surface);
  }

  std::vector<State::Added> fields(State const&) const override;
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override { return {unknown_}; }
  void act(State const& state, NodeView const&, NodeView const& sigma_n) const override
  {
    subtractPressure(sigma_n, unknown_->valuesIn(state));
  }
  void addPressure(State const& state, NodeView const& p) const override
  {
    addToPressure(unknown_->valuesIn(state), p);
  }

private:
  std::shared_ptr<const ShearZone> zone_;
  std::shared_ptr<ZonePressure> unknown_;
};

std::vector<State::Added> ThermalPressurisation::fields(State const&) const
{
  const std::size_t num_nodes = zone_->properties().pressure.extent(0);
  std::vector<State::Added> all;
  const auto add = [&](FieldInfo const& info) {
    const NodeView values("asperity::dynamics::" + info.name, num_nodes);
    all.push_back({std::make_shared<FieldInfo>(info), values});
    return values;
  };
  constexpr bool is_guessed = true;
  Kokkos::deep_copy(add({pressure_field, "pressure of the fluid in the fault", "Pa", is_guessed}),
                    zone_->properties().pressure);
  Kokkos::deep_copy(add({temperature_field, "temperature of the fault", "K"}),
                    zone_->properties().temperature);
  for (auto const& [name, unit] :
       {std::pair("temperature", "K m"), std::pair("pressure", "Pa m")}) {
    for (int i = 0; i < zone_->numModes(); ++i) {
      add({nameOfMode(name, i),
           std::string(name) + " of mode " + std::to_string(i) + " across the fault", unit});
    }
  }
  return all;
}
} // namespace

ASPERITY_REGISTER(FaultProcessRegistry, "Thermal Pressurisation",
                  FaultProcessKindOf<ThermalPressurisation>)
} // namespace asperity::dynamics
