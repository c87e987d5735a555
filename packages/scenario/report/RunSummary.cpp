#include "scenario/report/RunSummary.hpp"

#include "base/Text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace asperity::scenario
{
namespace
{
void writeBalance(std::ostream& text, dynamics::Energy const& energy, char const* unit)
{
  // This is how the defect is defined. All terms count from the start of the run, also after a
  // restart.
  const double change = energy.boundary_work + energy.load_work - energy.friction_work -
                        energy.viscous_work - energy.inelastic_work - energy.contact_work -
                        energy.numerical_dissipation + energy.defect;
  text << "Energy [" << unit << "]: work of boundaries " << formatShort(energy.boundary_work)
       << " and loads " << formatShort(energy.load_work) << "; taken by friction "
       << formatShort(energy.friction_work) << ", viscosity " << formatShort(energy.viscous_work)
       << (energy.inelastic_work != 0 ? ", rock that yields " + formatShort(energy.inelastic_work)
                                      : "")
       << (energy.contact_work != 0 ? ", contact " + formatShort(energy.contact_work) : "")
       << " and the time stepping " << formatShort(energy.numerical_dissipation)
       << "; change of kinetic and elastic energy " << formatShort(change)
       << ", which includes a defect of the balance of " << formatShort(energy.defect);
  if (energy.friction_work > std::abs(energy.defect)) {
    text << " (" << formatShort(energy.defect / energy.friction_work) << " of the friction work)";
  }
  text << ".";
}
} // namespace

std::optional<Warning> warnOfDefect(dynamics::Energy const& energy)
{
  const double largest = std::max({std::abs(energy.boundary_work), std::abs(energy.load_work),
                                   std::abs(energy.friction_work), std::abs(energy.viscous_work),
                                   std::abs(energy.inelastic_work), std::abs(energy.contact_work),
                                   std::abs(energy.numerical_dissipation), energy.kinetic});
  const double defect = std::abs(energy.defect);
  const bool is_rounding = defect <= 1e-9 * (energy.kinetic + std::abs(energy.elastic));
  // The runs of docs/validation close to 4e-6 or better.
  if (is_rounding || defect <= 1e-3 * largest) { // not if it is nan
    return std::nullopt;
  }
  return Warning{
    "balance of energy",
    "The balance of energy does not close: it is off by " + formatShort(defect / largest) +
      " of its largest term (energy_defect in steps.csv). Results may be wrong. Check "
      "the state at the start, and try smaller tolerances of TNNMG and Coupling; if that does not "
      "help, please report this with the deck."};
}

std::string summarise(RunSummary const& summary, std::string const& output_report)
{
  std::ostringstream text;
  text << '\n' << output_report;
  auto const& count = summary.count;
  text << (summary.finished ? "Finished" : "Stopped") << " at t = " << formatNumber(summary.time)
       << " s after " << counted(summary.num_steps, "step") << ".\n"
       << "Effort: " << counted(count.coupled_steps, "coupled step") << " (" << count.failures
       << " failed), " << counted(count.rate_problems, "rate problem") << ", "
       << counted(count.tnnmg_iterations, "TNNMG iteration") << ", "
       << counted(count.corrections, "correction") << ", " << counted(count.v_cycles, "V-cycle")
       << "; " << counted(summary.setups, "solver") << " set up in "
       << formatDuration(summary.setup_seconds) << ".\n";
  if (summary.forced_steps > 0) {
    text << counted(summary.forced_steps, "step") << " of the smallest size "
         << (summary.forced_steps == 1 ? "was" : "were") << " accepted above the tolerance.\n";
  }
  text << summary.floor_report << summary.watch_report;
  writeBalance(text, summary.energy, summary.dimension == 2 ? "J/m" : "J");
  text << "\nResults in " << summary.directory;
  return text.str();
}
} // namespace asperity::scenario
