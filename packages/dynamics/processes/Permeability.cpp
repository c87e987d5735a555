#include "dynamics/processes/Permeability.hpp"

#include "base/Errors.hpp"
#include "base/Views.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "portability/Renamed.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::dynamics
{
namespace
{
char const* const permeability_entry = "Permeability";
char const* const reference_entry = "Permeability Reference Stress";
char const* const stress_entry = "Permeability Stress Scale";
char const* const largest_entry = "Largest Permeability";
char const* const least_entry = "Least Permeability";
char const* const distance_entry = "Permeability Slip Distance";
char const* const healing_entry = "Permeability Healing Time";
char const* const permeability_field = "opened_permeability";

// The state k' tends to the mean of k_max and k_min, weighted by their rates.
struct PermeabilityFlow
{
  ConstNodeView largest, least; // k_max, k_min [m^2]
  ConstNodeView distance;       // L_k [m]
  ConstNodeView healing_rate;   // 1 / T_k [1/s]

  KOKKOS_INLINE_FUNCTION double operator()(int node, double k, double V, double tau) const
  {
    const double opening = V / distance(node), closing = healing_rate(node);
    const double rate = opening + closing;
    if (!(rate > 0)) {
      return k;
    }
    const double share = opening / rate; // both sums below are convex: no bound is passed
    const double limit = share * largest(node) + (1 - share) * least(node);
    const double left = math::exp(-rate * tau);
    return left * k + (1 - left) * limit;
  }
};

void flow(PermeabilityFlow const& law, ConstNodeView const& k0, ConstNodeView const& V, double tau,
          NodeView const& k1)
{
  Kokkos::parallel_for(
    "asperity::dynamics::permeabilityFlow", RangePolicy(0, k1.extent_int(0)),
    KOKKOS_LAMBDA(int node) { k1(node) = law(node, k0(node), V(node), tau); });
}
// Entries that have a meaning together alone.
void requireTogether(Teuchos::ParameterList const& parameters, std::string const& path)
{
  const auto needs = [&](char const* name, char const* other) {
    ASPERITY_REQUIRE(!isGiven(parameters, name) || isGiven(parameters, other),
                     joinPath(path, other) << " is missing: " << name << " needs it.");
  };
  needs(distance_entry, largest_entry);
  needs(largest_entry, distance_entry);
  needs(healing_entry, least_entry);
  needs(healing_entry, distance_entry);
  needs(least_entry, healing_entry);
}
} // namespace

// k' as an unknown of each step: friction of the step does not depend on it, but it has to follow
// the slip of that step.
class Permeability::Evolution : public StepUnknown
{
public:
  Evolution(FaultProcessContext const& context, std::vector<double> const& least,
            std::vector<double> const& largest, std::vector<double> const& distance,
            std::vector<double> const& healing_rate)
      : surface_(context.surface)
      , law_{toDevice(largest, "asperity::dynamics::largestPermeability"),
             toDevice(least, "asperity::dynamics::leastPermeability"),
             toDevice(distance, "asperity::dynamics::distanceOfPermeability"),
             toDevice(healing_rate, "asperity::dynamics::healingRate")}
      , velocity_("asperity::dynamics::w", surface_.numNodes(), surface_.numTangents())
      , V_("asperity::dynamics::V", surface_.numNodes())
      , later_("asperity::dynamics::permeability", surface_.numNodes())
  {
    std::vector<double> scale;
    for (double k : largest) {
      scale.push_back(1 / k);
    }
    scale_ = toDevice(scale, "asperity::dynamics::perPermeability");
  }

  // Without a healing time k' does not fall. InputError where the start is out of bounds.
  static std::shared_ptr<Evolution> from(Teuchos::ParameterList const& parameters,
                                         FaultProcessContext const& context,
                                         std::vector<double> const& start)
  {
    auto const largest = context.values(largest_entry);
    auto least = start;
    std::vector<double> healing_rate(start.size(), 0);
    if (isGiven(parameters, healing_entry)) {
      least = context.values(least_entry);
      auto const time = context.values(healing_entry);
      std::transform(time.begin(), time.end(), healing_rate.begin(),
                     [](double t) { return 1 / t; });
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
      ASPERITY_REQUIRE(least[i] <= start[i] && start[i] <= largest[i],
                       joinPath(context.path, permeability_entry)
                         << " = " << start[i] << " at x = " << context.places[i][0]
                         << ", y = " << context.places[i][1] << " is outside [" << least[i] << ", "
                         << largest[i] << "], Least to Largest Permeability.");
    }
    return std::make_shared<Evolution>(context, least, largest, context.values(distance_entry),
                                       healing_rate);
  }

  NodeView valuesIn(State const& state) const override { return state.at(permeability_field); }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    flow(law_, valuesIn(step.from), step.slip_rate, step.tau, image);
    return 0;
  }
  ConstNodeView scale() const override { return scale_; }
  bool endsWithImage() const override { return true; }

  // k' after a time tau at the slip rate of the state.
  NodeView const& after(State const& state, double tau) const
  {
    gatherSlip(surface_, *state.v, velocity_);
    slipRate(surface_, velocity_, V_);
    flow(law_, valuesIn(state), V_, tau, later_);
    return later_;
  }

private:
  fem::FaultSurface const& surface_;
  PermeabilityFlow law_;
  BlockView velocity_;
  NodeView V_, later_, scale_;
};

void Permeability::declare(Declare& process)
{
  process
    .field(
      stress_entry, optional, "Pa", Range::positive(),
      "If given, permeability is smaller by a factor e for each such increase of the effective "
      "normal stress above Permeability Reference Stress.")
    .hint("Laboratories find 5 to 40 MPa.")
    .field(reference_entry, 0., "Pa", Range::any(),
           "At this effective normal stress the factor is 1.")
    .field(distance_entry, optional, "m", Range::positive(),
           "If given, slip moves permeability towards Largest Permeability over this distance.")
    .field(largest_entry, optional, "m^2", Range::positive(),
           "Permeability grows with slip towards this one, which Permeability Slip Distance needs.")
    .field(healing_entry, optional, "s", Range::positive(),
           "If given together with Permeability Slip Distance, permeability falls towards Least "
           "Permeability within this time.")
    .field(least_entry, optional, "m^2", Range::positive(),
           "Permeability falls in time towards this one, which Permeability Healing Time needs.");
}

Permeability::Permeability(Teuchos::ParameterList const& parameters,
                           FaultProcessContext const& context, std::vector<double> start)
    : start_(std::move(start))
{
  requireTogether(parameters, context.path);
  if (isGiven(parameters, stress_entry)) {
    stress_scale_ = context.values(stress_entry);
    reference_stress_ = context.values(reference_entry);
  }
  if (isGiven(parameters, distance_entry)) {
    evolution_ = Evolution::from(parameters, context, start_);
  }
}

std::vector<State::Added> Permeability::fields() const
{
  if (!evolution_) {
    return {};
  }
  constexpr bool is_guessed = true;
  const NodeView k("asperity::dynamics::openedPermeability", start_.size());
  Kokkos::deep_copy(k, toDevice(start_, "asperity::dynamics::startOfPermeability"));
  return {
    {std::make_shared<FieldInfo>(FieldInfo{
       permeability_field, "permeability but for the effective normal stress", "m^2", is_guessed}),
     k}};
}

std::vector<std::shared_ptr<StepUnknown>> Permeability::unknowns() const
{
  return evolution_ ? std::vector<std::shared_ptr<StepUnknown>>{evolution_}
                    : std::vector<std::shared_ptr<StepUnknown>>{};
}

std::vector<double> Permeability::after(State const& state, double tau,
                                        ConstNodeView const& p) const
{
  auto k = start_;
  if (evolution_) {
    auto const evolved = toHost(evolution_->after(state, tau));
    std::copy_n(evolved.data(), k.size(), k.begin());
  }
  if (dependsOnStress()) {
    auto const sigma_n = toHost(state.sigma_n);
    auto const pressure = toHost(p);
    for (std::size_t i = 0; i < k.size(); ++i) {
      const double effective = std::max(0., sigma_n(i) - pressure(i));
      k[i] *= std::exp(-(effective - reference_stress_[i]) / stress_scale_[i]);
    }
  }
  return k;
}
} // namespace asperity::dynamics
