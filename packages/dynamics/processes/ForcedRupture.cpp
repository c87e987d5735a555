// A rupture that is forced to begin at a place: friction falls with time there as if the fault
// slipped, as in SCEC's TPV26 and other problems with slip weakening,
//   alpha = max(min(s / d_c, 1), min(max((t - t_f) / t_0, 0), 1)).
#include "base/Views.hpp"
#include "dynamics/FaultProcess.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "friction/laws/SlipWeakening.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::dynamics
{
namespace
{
char const* const share_name = "forced_weakening";

// share := min(max((t - time) / duration, 0), 1)
void setShare(double t, ConstNodeView const& time, ConstNodeView const& duration,
              NodeView const& share)
{
  Kokkos::parallel_for(
    "asperity::dynamics::shareOfWeakening", RangePolicy(0, share.extent(0)),
    KOKKOS_LAMBDA(int node) {
      const double part = (t - time(node)) / duration(node);
      share(node) = part > 1 ? 1 : part > 0 ? part : 0;
    });
}

class ForcedRupture : public FaultProcess
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Declare()
      .boolean("Enabled", false, "If true, friction falls at given times.")
      .field("Time", 1e9, "s", Range::any(),
             "Friction begins to fall at this time at the latest. Where nothing is to be forced, "
             "give a time after the end of the run.")
      .field("Duration", 0.5, "s", Range::positive(),
             "From that time on friction falls to its dynamic coefficient within this time.")
      .list();
  }
  static std::string meaning()
  {
    return "With the laws named Slip Weakening: friction falls at given times, whatever the slip.";
  }

  ForcedRupture(Teuchos::ParameterList const&, FaultProcessContext const& context)
      : time_(toDevice(context.values("Time"), "asperity::dynamics::timeOfRupture"))
      , duration_(toDevice(context.values("Duration"), "asperity::dynamics::durationOfRupture"))
  {
  }

  char const* stateVariable() const override { return friction::SlipWeakeningLaw::state_variable; }

  std::vector<State::Added> fields(State const&) const override
  {
    const NodeView share("asperity::dynamics::forcedWeakening", time_.extent(0));
    setShare(0, time_, duration_, share);
    return {{std::make_shared<FieldInfo>(FieldInfo{share_name, "forced share of weakening", "-"}),
             share}};
  }
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override
  {
    return {std::make_shared<KnownField>(
      share_name,
      [time = time_, duration = duration_](StepStart const& start, NodeView const& share) {
        setShare(start.t + start.tau, time, duration, share);
      })};
  }

  void act(State const& state, NodeView const& alpha, NodeView const&) const override
  {
    const ConstNodeView share = state.at(share_name);
    Kokkos::parallel_for(
      "asperity::dynamics::forceWeakening", RangePolicy(0, alpha.extent(0)),
      KOKKOS_LAMBDA(int node) {
        alpha(node) = alpha(node) > share(node) ? alpha(node) : share(node);
      });
  }

private:
  NodeView time_, duration_; // t_f and t_0 [s]
};
} // namespace

ASPERITY_REGISTER(FaultProcessRegistry, "Forced Rupture", FaultProcessKindOf<ForcedRupture>)
} // namespace asperity::dynamics
