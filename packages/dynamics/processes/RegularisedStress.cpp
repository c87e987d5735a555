#include "dynamics/processes/RegularisedStress.hpp"

#include "base/Views.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/coupling/StressScale.hpp"
#include "portability/Renamed.hpp"

namespace asperity::dynamics
{
namespace
{
char const* const regularised_stress = "regularised_normal_stress";

// s at the end of a step: with x = k tau, k = V / L_pc + 1 / T_pc, sigma from sigma0 to sigma1,
//   s1 = sigma1 + (s0 - sigma0) e^-x - (sigma1 - sigma0) (1 - e^-x) / x,
// written as s0 plus shares of what sigma0 and sigma1 are from it, neither of them negative: s
// rests to the last digit where sigma does, and follows it however short the step is.
struct Follow
{
  ConstNodeView per_slip, per_time, slip_rate, before, after, s0; // 1 / L_pc, 1 / T_pc, V, sigma
  double tau;
  NodeView s1;

  KOKKOS_INLINE_FUNCTION void operator()(int node) const
  {
    constexpr double small = 1e-4; // the error of the series is that of rounding
    const double x = (slip_rate(node) * per_slip(node) + per_time(node)) * tau;
    const double followed = -math::expm1(-x); // 1 - e^-x
    const double to_after = x > small ? 1 - followed / x : x / 2 * (1 - x / 3 * (1 - x / 4));
    const double to_before = followed - to_after;
    const double s =
      s0(node) + to_after * (after(node) - s0(node)) + to_before * (before(node) - s0(node));
    s1(node) = s > 0 ? s : 0; // rounding
  }
};

class Regularisation : public StepUnknown
{
public:
  Regularisation(fem::FaultSurface const& surface, RegularisationScales const& scales,
                 FaultProcesses before)
      : surface_(surface)
      , before_(before, surface.numNodes())
      , after_(std::move(before), surface.numNodes())
      , per_slip_(inverse(scales.slip_distance))
      , per_time_(inverse(scales.time))
      , scale_("asperity::dynamics::perPascal", surface.numNodes())
  {
  }

  // (num_nodes), valid until the next call or step.
  ConstNodeView effective(State const& state) const { return after_.at(state).sigma_n; }

  NodeView valuesIn(State const& state) const override { return state.at(regularised_stress); }
  void begin(StepStart const& start) override
  {
    effective_before_ = before_.at(start.from).sigma_n;
    setScaleOfStress(valuesIn(start.from), surface_, scale_);
    limit(valuesIn(start.to));
  }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    ASPERITY_TIME_WORK("normal stress");
    Kokkos::parallel_for("asperity::dynamics::regularise", RangePolicy(0, image.extent_int(0)),
                         Follow{per_slip_, per_time_, step.slip_rate, effective_before_,
                                effective(step.to), valuesIn(step.from), step.tau, image});
    return 0;
  }
  // Extrapolation and guesses may lead below zero.
  void limit(NodeView const& s) const override
  {
    Kokkos::parallel_for(
      "asperity::dynamics::raiseToZero", RangePolicy(0, s.extent_int(0)),
      KOKKOS_LAMBDA(int node) { s(node) = s(node) < 0 ? 0 : s(node); });
  }
  ConstNodeView scale() const override { return scale_; }
  bool endsWithImage() const override { return true; }

private:
  static ConstNodeView inverse(std::vector<double> values)
  {
    for (double& value : values) {
      value = 1 / value;
    }
    return toDevice(values, "asperity::dynamics::rateOfRegularisation");
  }

  fem::FaultSurface const& surface_;
  FrictionInput before_, after_; // with the effective stress at the ends of the step
  ConstNodeView effective_before_;
  ConstNodeView per_slip_, per_time_;
  NodeView scale_;
};

class RegularisedStress : public FaultProcess
{
public:
  explicit RegularisedStress(std::shared_ptr<Regularisation> unknown) : unknown_(std::move(unknown))
  {
  }

  std::vector<State::Added> fields(State const& start) const override
  {
    constexpr bool is_guessed = true, counts_from_start = true;
    auto const sigma = unknown_->effective(start);
    const NodeView s("asperity::dynamics::regularisedStress", sigma.extent(0));
    Kokkos::deep_copy(s, sigma);
    return {{std::make_shared<FieldInfo>(FieldInfo{regularised_stress,
                                                   "normal stress that friction takes", "Pa",
                                                   is_guessed, counts_from_start}),
             s}};
  }
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override { return {unknown_}; }
  void act(State const& state, NodeView const&, NodeView const& sigma_n) const override
  {
    Kokkos::deep_copy(sigma_n, state.at(regularised_stress));
  }

private:
  std::shared_ptr<Regularisation> unknown_;
};
} // namespace

std::shared_ptr<const FaultProcess> makeRegularisedStress(fem::FaultSurface const& surface,
                                                          RegularisationScales const& scales,
                                                          FaultProcesses before)
{
  return std::make_shared<RegularisedStress>(
    std::make_shared<Regularisation>(surface, scales, std::move(before)));
}
} // namespace asperity::dynamics
