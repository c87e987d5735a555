#include "Steps.hpp"

#include <iomanip>
#include <sstream>

namespace
{
void addRow(std::ostream& out, char const* name, StepsSample const& kind, double product)
{
  if (kind.accepted == 0) {
    return;
  }
  const auto each = static_cast<double>(kind.count.coupled_steps);
  const auto of = [&](std::int64_t number) { return static_cast<double>(number) / each; };
  out << "| " << name << " | " << kind.smallest << " to " << kind.largest << " | " << kind.accepted
      << " | " << kind.count.coupled_steps << " | " << of(kind.count.rate_problems) << " | "
      << of(kind.count.tnnmg_iterations) << " | " << of(kind.count.v_cycles) << " | "
      << kind.seconds / each / product << " | " << kind.setup_seconds / product << " | "
      << kind.count.rises << " |\n";
}

void addJson(std::ostream& out, char const* name, StepsSample const& kind)
{
  out << ", \"" << name << "\": {\"accepted\": " << kind.accepted;
  for (auto const& member : asperity::dynamics::SolveCount::members()) {
    out << ", \"" << member.name << "\": " << kind.count.*member.value;
  }
  out << ", \"seconds\": " << kind.seconds << ", \"setup_seconds\": " << kind.setup_seconds << "}";
}
} // namespace

std::string stepsTable(StretchSample const& sample, int num_ranks)
{
  std::ostringstream out;
  out << std::setprecision(3) << "\n"
      << sample.num_unknowns << " unknowns, " << num_ranks << (num_ranks > 1 ? " ranks" : " rank")
      << "; product with K " << 1e3 * sample.product_seconds << " ms; " << sample.setups
      << " set-ups of step sizes; peak memory " << sample.peak_bytes / 1e6 << " MB, "
      << sample.peak_bytes / static_cast<double>(sample.num_unknowns) / 1e3
      << " kB an unknown\n\n"
         "For each coupled step; time in products with K.\n\n"
         "| steps | tau [s] | accepted | coupled | rate problems | TNNMG | V-cycles | time | "
         "set-up, all | rises |\n"
         "|---|---|---|---|---|---|---|---|---|---|\n";
  addRow(out, "inertial", sample.inertial, sample.product_seconds);
  addRow(out, "quasi-static", sample.quasi_static, sample.product_seconds);
  return out.str();
}

std::string stepsJson(StretchSample const& sample, int num_ranks)
{
  std::ostringstream out;
  out << std::setprecision(6) << "{\"ranks\": " << num_ranks
      << ", \"unknowns\": " << sample.num_unknowns
      << ", \"product_seconds\": " << sample.product_seconds
      << ", \"peak_bytes\": " << sample.peak_bytes << ", \"setups\": " << sample.setups;
  addJson(out, "inertial", sample.inertial);
  addJson(out, "quasi_static", sample.quasi_static);
  out << "}\n";
  return out.str();
}
