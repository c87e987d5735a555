#include "dynamics/coupling/SolveCount.hpp"

namespace asperity::dynamics
{
void SolveCount::add(tnnmg::TnnmgResult const& result)
{
  tnnmg_iterations += result.iterations;
  corrections += result.corrections;
  correction_iterations += result.correction_iterations;
  v_cycles += result.v_cycles;
  energy_increases += result.energy_increases;
}

SolveCount SolveCount::since(SolveCount const& before) const
{
  SolveCount result;
  for (auto const& member : members()) {
    result.*member.value = this->*member.value - before.*member.value;
  }
  return result;
}

std::array<SolveCount::Member, 8> const& SolveCount::members()
{
  static constexpr std::array<Member, 8> all = {
    {{"coupled_steps", &SolveCount::coupled_steps},
     {"rate_problems", &SolveCount::rate_problems},
     {"tnnmg_iterations", &SolveCount::tnnmg_iterations},
     {"corrections", &SolveCount::corrections},
     {"correction_iterations", &SolveCount::correction_iterations},
     {"v_cycles", &SolveCount::v_cycles},
     {"energy_increases", &SolveCount::energy_increases},
     {"failures", &SolveCount::failures}}};
  return all;
}
} // namespace asperity::dynamics
