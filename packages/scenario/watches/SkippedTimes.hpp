#pragma once

#include "base/Types.hpp"
#include "dynamics/watches/Watch.hpp"
#include "parameters/Parameters.hpp"
#include "parameters/fields/Expression.hpp"
#include "scenario/problem/Problem.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// Some places of this rank at which loads act: at most a hundred at the fault, as many in the body.
template <int Dim>
std::vector<std::array<double, 3>> placesOfLoads(Problem<Dim> const& problem);

// Finds steps that pass a pulse of a load, such as a push of ten seconds in a step of a day. Error
// estimates compare states at the ends of steps, and miss such a pulse. Two kinds are found: a step
// passes two times with which expressions of the deck compare t (timesComparedIn), or a time around
// which an expression is centred (timesShiftedIn) and at which it is outside the range of its
// values at both ends of the step.
class SkippedTimes : public dynamics::Watch
{
public:
  // deck: complete, its names replaced. places: this rank's, at which expressions are looked at.
  SkippedTimes(ParameterList const& deck, std::vector<std::array<double, 3>> places,
               RCP<const Communicator> communicator);

  SkippedTimes(ParameterList const&, dynamics::WatchContext const& context);
  static std::string meaning() { return "pulses of a load that a step passes"; }

  // A warning of the first such step, from `begin` to `end` [s]. Collective.
  std::optional<Warning> note(double begin, double end);
  void note(dynamics::WatchedState const& now, dynamics::Notes& notes) override;

private:
  struct Pulse
  {
    double centre; // [s]
    std::shared_ptr<const Expression> load;
    std::string path;
  };
  // of_list: the functions that a text may call which no declaration describes.
  void collect(ParameterList const& list, std::string const& path,
               Expression::Tables const& of_list);
  bool isPassed(Pulse const& pulse, double begin, double end) const;

  std::vector<double> times_; // [s], ascending
  std::vector<Pulse> pulses_;
  std::vector<std::array<double, 3>> places_;
  RCP<const Communicator> communicator_;
  bool has_warned_ = false;
};
} // namespace asperity::scenario
