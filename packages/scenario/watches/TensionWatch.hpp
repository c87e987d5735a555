#pragma once

#include "dynamics/watches/Watch.hpp"
#include "parameters/Parameters.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace asperity::scenario
{
// Notes where a body pulls at its fault and the model does not let that open (Contact = Bilateral):
// it holds the fault shut, and a real one would open there. The tension is
// -(sigma_0 + R - R(start)), where R is the compression that the body exerts, whether the normal
// stress of friction follows it or is fixed. It counts where it is above 1 % of the largest normal
// stress of the fault, and above 10 % of the largest shear stress, of friction or of the loads at
// the start: cells leave errors of that size.
class TensionWatch : public dynamics::Watch
{
public:
  // since_start of the context is empty where nothing presses across the fault (antiplane motion,
  // antisymmetric faults). Collective.
  TensionWatch(ParameterList const&, dynamics::WatchContext const& context);
  static std::string meaning() { return "a body that pulls at its fault"; }

  // Warns the first time, and whenever twice as much of the fault is in tension.
  void note(dynamics::WatchedState const& watched, dynamics::Notes& notes) override;

  // The largest share and the largest tension, if there was any.
  std::optional<Warning> warningOfRun() const override;

  void save(Archive& archive) const override;
  void restore(Archive const& archive, Restart const&) override;

private:
  struct Tension
  {
    double share = 0;              // of the sliding part of the fault, by measure
    double largest = 0;            // [Pa]
    double time = 0;               // [s]
    std::array<double, 3> place{}; // of the largest [m]
  };
  Tension tensionAt(Vector const& force, double time);
  std::string text(Tension const& tension) const;

  dynamics::Fault const& fault_;
  dynamics::ReactionSinceStart since_start_;
  double sliding_ = 0; // measure of the nodes that slide
  double loads_ = 0;   // the largest load along the fault at the start [Pa]
  NodeView sigma_0_, R_;
  Tension most_;            // the largest share, the largest tension with its time and place
  double warned_share_ = 0; // share at the last warning
};
} // namespace asperity::scenario
