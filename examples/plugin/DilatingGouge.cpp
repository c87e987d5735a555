// A process on the fault of your own with an unknown that follows from slip: gouge that dilates,
//   dp/dt = -p / t_d - c V,
// and so lowers the pressure of its fluid, which takes normal stress from friction.
// dynamics/FaultProcess.hpp says what a process has to have, dynamics/coupling/StepUnknown.hpp what
// its unknown has to have.
#include "dynamics/FaultProcess.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "parameters/Entries.hpp"

#include <cmath>

namespace
{
using namespace asperity;
using namespace asperity::dynamics;

using Nodes = Kokkos::RangePolicy<ExecutionSpace>;
char const* const field_name = "gouge_pressure";

struct Settings
{
  bool is_enabled = false;
  double dilatancy = 1e8;   // c [Pa/m]
  double drainage_time = 1; // t_d [s]

  static Entries<Settings> entries()
  {
    return Entries<Settings>()
      .boolean("Enabled", &Settings::is_enabled, "Whether the gouge dilates.")
      .real("Dilatancy", &Settings::dilatancy, "Pa/m", Range::atLeast(0),
            "The pressure falls by this with each metre of slip while no fluid flows.")
      .real("Drainage Time", &Settings::drainage_time, "s", Range::positive(),
            "A change of pressure falls by e in this time.");
  }
};

// Exact for a slip rate that is constant in the step.
class Pressure : public StepUnknown
{
public:
  Pressure(Settings const& settings, int num_nodes)
      : settings_(settings)
      , scale_("scale", num_nodes)
  {
    Kokkos::deep_copy(scale_, 1e-6);
  }

  NodeView valuesIn(State const& state) const override { return state.at(field_name); }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    const ConstNodeView before = valuesIn(step.from), V = step.slip_rate;
    const double rest = std::exp(-step.tau / settings_.drainage_time);
    const double of_rate = settings_.dilatancy * settings_.drainage_time * (1 - rest);
    Kokkos::parallel_for(
      "dilate", Nodes(0, image.extent_int(0)),
      KOKKOS_LAMBDA(int node) { image(node) = rest * before(node) - of_rate * V(node); });
    return 0;
  }
  // Else changes that are small beside the tolerance would be lost, in every step anew.
  bool endsWithImage() const override { return true; }
  // A change of 1 Pa counts as little as one of 1e-6 in alpha.
  ConstNodeView scale() const override { return scale_; }

private:
  Settings settings_;
  NodeView scale_;
};

class DilatingGouge : public FaultProcess
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Settings::entries().list();
  }
  static std::string meaning() { return "Gouge that dilates with slip and lowers its pressure."; }

  DilatingGouge(Teuchos::ParameterList const& parameters, FaultProcessContext const& context)
      : num_nodes_(context.surface.numNodes())
      , unknown_(std::make_shared<Pressure>(Settings::entries().read(parameters, context.path),
                                            num_nodes_))
  {
  }

  std::vector<State::Added> fields(State const&) const override
  {
    constexpr bool is_guessed = true;
    return {{std::make_shared<FieldInfo>(
               FieldInfo{field_name, "pressure of the gouge", "Pa", is_guessed}),
             NodeView("gouge", num_nodes_)}};
  }
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override { return {unknown_}; }
  void act(State const& state, NodeView const&, NodeView const& sigma_n) const override
  {
    const ConstNodeView p = state.at(field_name);
    Kokkos::parallel_for(
      "effectiveStress", Nodes(0, sigma_n.extent_int(0)), KOKKOS_LAMBDA(int node) {
        sigma_n(node) = sigma_n(node) > p(node) ? sigma_n(node) - p(node) : 0;
      });
  }

private:
  int num_nodes_;
  std::shared_ptr<Pressure> unknown_;
};
} // namespace

ASPERITY_REGISTER(FaultProcessRegistry, "Dilating Gouge", FaultProcessKindOf<DilatingGouge>)
