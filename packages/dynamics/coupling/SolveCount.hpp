#pragma once

#include "tnnmg/Tnnmg.hpp"

#include <array>
#include <cstdint>

namespace asperity::dynamics
{
// The cost of solving, summed over any number of steps.
struct SolveCount
{
  std::int64_t coupled_steps = 0;
  std::int64_t rate_problems = 0; // one for each fixed point iteration
  std::int64_t tnnmg_iterations = 0;
  std::int64_t corrections = 0;
  std::int64_t correction_iterations = 0;
  std::int64_t v_cycles = 0;
  std::int64_t energy_increases = 0; // of J, see Tnnmg
  std::int64_t failures = 0;         // coupled steps without a solution

  void add(tnnmg::TnnmgResult const& result);
  SolveCount since(SolveCount const& before) const;

  struct Member
  {
    char const* name;
    std::int64_t SolveCount::*value;
  };
  // All counts with their names, to read, write or compare them one by one.
  static std::array<Member, 8> const& members();
};
} // namespace asperity::dynamics
