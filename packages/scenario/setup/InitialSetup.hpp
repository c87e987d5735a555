#pragma once

#include "dynamics/initial/InitialAlpha.hpp"
#include "parameters/Parameters.hpp"

#include <array>

namespace asperity::scenario
{
// The deck's list `Initial State`.
RCP<const ParameterList> initialStateParameters();

// Names of entries that its declaration and its readers share: the choice of the state; and fields,
// which are the velocity of the body along the axes and the slip rate of the fault, which may be
// left out [m/s], and the state alpha [-].
namespace initial_entries
{
inline constexpr char const* state = "State";
inline constexpr std::array<char const*, 3> velocity = {"Velocity X", "Velocity Y", "Velocity Z"};
inline constexpr char const* slip_rate = "Slip Rate";
inline constexpr char const* alpha = "alpha";
} // namespace initial_entries

// Its other entries.
struct InitialSettings
{
  bool is_static = true;   // the displacement balances the loads at t = 0, else it is zero
  bool is_balanced = true; // the acceleration balances the forces at t = 0, else it is zero
  dynamics::AlphaAtStart alpha = dynamics::AlphaAtStart::given;

  static InitialSettings from(ParameterList const& list);
};
} // namespace asperity::scenario
