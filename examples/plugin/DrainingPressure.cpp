// A process on the fault of your own: a fluid whose pressure drains, dp/dt = -p / t_d, and lowers
// the normal stress that friction takes. The pressure follows from time alone, so that each step
// knows it from the start. dynamics/FaultProcess.hpp says what a process has to have.
#include "dynamics/FaultProcess.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "parameters/Entries.hpp"

#include <algorithm>
#include <cmath>

namespace
{
using namespace asperity;
using namespace asperity::dynamics;

using Nodes = Kokkos::RangePolicy<ExecutionSpace>;
char const* const field_name = "pressure";

struct Settings
{
  double drainage_time = 1; // t_d [s]

  // They join those of the list.
  static Entries<Settings> entries(ParameterList& list)
  {
    Entries<Settings> entries({}, list);
    return entries.real("Drainage Time", &Settings::drainage_time, "s", Range::positive(),
                        "The pressure falls by e in this time.");
  }
};

class DrainingPressure : public FaultProcess
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    auto const list =
      Declare()
        .boolean("Enabled", false, "Whether there is a fluid.")
        .field("Pressure", 0., "Pa", Range::atLeast(0), "The fluid starts with this pressure.")
        .list();
    Settings::entries(*list);
    return list;
  }
  static std::string meaning() { return "A fluid in the fault, whose pressure drains."; }

  DrainingPressure(Teuchos::ParameterList const& parameters, FaultProcessContext const& context)
      : start_(context.values("Pressure"))
  {
    ParameterList declared;
    drainage_time_ = Settings::entries(declared).read(parameters, context.path).drainage_time;
  }

  std::vector<State::Added> fields(State const&) const override
  {
    const NodeView p("pressure", start_.size());
    auto const host = Kokkos::create_mirror_view(p);
    std::copy(start_.begin(), start_.end(), host.data());
    Kokkos::deep_copy(p, host);
    return {{std::make_shared<FieldInfo>(FieldInfo{field_name, "pressure", "Pa"}), p}};
  }
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override
  {
    return {std::make_shared<KnownField>(
      field_name, [drainage_time = drainage_time_](StepStart const& step, NodeView const& p) {
        const ConstNodeView before = step.from.at(field_name);
        const double rest = std::exp(-step.tau / drainage_time);
        Kokkos::parallel_for(
          "drain", Nodes(0, p.extent_int(0)),
          KOKKOS_LAMBDA(int node) { p(node) = rest * before(node); });
      })};
  }
  void act(State const& state, NodeView const&, NodeView const& sigma_n) const override
  {
    const ConstNodeView p = state.at(field_name);
    Kokkos::parallel_for(
      "effectiveStress", Nodes(0, sigma_n.extent_int(0)), KOKKOS_LAMBDA(int node) {
        sigma_n(node) = sigma_n(node) > p(node) ? sigma_n(node) - p(node) : 0;
      });
  }

private:
  std::vector<double> start_;
  double drainage_time_;
};
} // namespace

ASPERITY_REGISTER(FaultProcessRegistry, "Draining Pressure", FaultProcessKindOf<DrainingPressure>)
