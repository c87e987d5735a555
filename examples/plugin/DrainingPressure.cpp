// A process on the fault of your own: a fluid whose pressure drains, dp/dt = -p / t_d, and lowers
// the normal stress that friction takes. dynamics/FaultProcess.hpp says what a process has to have.
#include "dynamics/FaultProcess.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "parameters/Parameters.hpp"

#include <algorithm>
#include <cmath>

namespace
{
using namespace asperity;
using namespace asperity::dynamics;

using Nodes = Kokkos::RangePolicy<ExecutionSpace>;
char const* const field_name = "pressure";

class Pressure : public StepUnknown
{
public:
  Pressure(double drainage_time, int num_nodes)
      : drainage_time_(drainage_time)
      , scale_("scale", num_nodes)
  {
    Kokkos::deep_copy(scale_, 1e-6);
  }

  NodeView of(State const& state) const override { return state.at(field_name); }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    const ConstNodeView before = of(step.from);
    const double rest = std::exp(-step.tau / drainage_time_);
    Kokkos::parallel_for(
      "drain", Nodes(0, image.extent_int(0)),
      KOKKOS_LAMBDA(int node) { image(node) = rest * before(node); });
    return 0;
  }
  // Else changes that are small beside the tolerance would be lost, in every step anew.
  bool endsWithImage() const override { return true; }
  // A change of 1 Pa counts as little as one of 1e-6 in alpha.
  ConstNodeView scale() const override { return scale_; }

private:
  double drainage_time_;
  NodeView scale_;
};

class DrainingPressure : public FaultProcess
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Declare()
      .boolean("Enabled", false, "Whether there is a fluid.")
      .field("Pressure", 0., "Pa", Range::atLeast(0), "The fluid starts with this pressure.")
      .real("Drainage Time", 1., "s", Range::positive(), "The pressure falls by e in this time.")
      .list();
  }
  static std::string meaning() { return "A fluid in the fault, whose pressure drains."; }

  DrainingPressure(Teuchos::ParameterList const& parameters, FaultProcessContext const& context)
      : start_(context.values("Pressure"))
      , unknown_(std::make_shared<Pressure>(parameters.get<double>("Drainage Time"),
                                            context.surface.numNodes()))
  {
  }

  std::vector<State::Added> fields(State const&) const override
  {
    constexpr bool is_guessed = true;
    const NodeView p("pressure", start_.size());
    auto const host = Kokkos::create_mirror_view(p);
    std::copy(start_.begin(), start_.end(), host.data());
    Kokkos::deep_copy(p, host);
    return {{std::make_shared<FieldInfo>(FieldInfo{field_name, "pressure", "Pa", is_guessed}), p}};
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
  std::vector<double> start_;
  std::shared_ptr<Pressure> unknown_;
};
} // namespace

ASPERITY_REGISTER(FaultProcessRegistry, "Draining Pressure", FaultProcessKindOf<DrainingPressure>)
