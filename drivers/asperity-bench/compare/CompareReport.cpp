#include "compare/Compare.hpp"

#include <iomanip>
#include <sstream>

namespace
{
void addRow(std::ostream& out, char const* name, ComparedSteps const& steps, double product)
{
  if (steps.count == 0) {
    return;
  }
  const double count = steps.count;
  const auto mean = [&](auto sum) { return static_cast<double>(sum) / count; };
  out << "| " << name << " | " << steps.count << " | " << mean(steps.coupled_iterations) << " | "
      << mean(steps.coupled_cycles) << " | " << mean(steps.coupled_seconds) / product << " | "
      << mean(steps.rate_iterations) << " | " << mean(steps.rate_cycles) << " | "
      << mean(steps.rate_seconds) / product << " | " << mean(steps.linear_cycles) << " | "
      << mean(steps.linear_seconds) / product << " | " << steps.rate_seconds / steps.linear_seconds
      << " | " << steps.coupled_seconds / steps.rate_seconds << " | " << steps.worst_error
      << " |\n";
}

void addJson(std::ostream& out, char const* name, ComparedSteps const& steps)
{
  out << ", \"" << name << "\": {\"count\": " << steps.count
      << ", \"coupled_seconds\": " << steps.coupled_seconds
      << ", \"coupled_iterations\": " << steps.coupled_iterations
      << ", \"coupled_cycles\": " << steps.coupled_cycles
      << ", \"rate_seconds\": " << steps.rate_seconds
      << ", \"rate_iterations\": " << steps.rate_iterations
      << ", \"rate_cycles\": " << steps.rate_cycles
      << ", \"linear_seconds\": " << steps.linear_seconds
      << ", \"linear_cycles\": " << steps.linear_cycles
      << ", \"worst_error\": " << steps.worst_error << "}";
}
} // namespace

std::string comparisonTable(Comparison const& comparison, int num_ranks)
{
  std::ostringstream out;
  out << std::setprecision(3) << "\n"
      << comparison.num_unknowns << " unknowns, " << num_ranks
      << (num_ranks > 1 ? " ranks" : " rank") << "; product with K "
      << 1e3 * comparison.product_seconds
      << " ms\n\n"
         "Each a mean; time in products with K, without set-up.\n\n"
         "| steps | count | coupled: TNNMG | V-cycles | time | rate problem: TNNMG | V-cycles | "
         "time | linear: V-cycles | time | rate over linear | coupled over rate | error |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  addRow(out, "inertial", comparison.inertial, comparison.product_seconds);
  addRow(out, "quasi-static", comparison.quasi_static, comparison.product_seconds);
  return out.str();
}

std::string comparisonJson(Comparison const& comparison, int num_ranks)
{
  std::ostringstream out;
  out << std::setprecision(6) << "{\"ranks\": " << num_ranks
      << ", \"unknowns\": " << comparison.num_unknowns
      << ", \"product_seconds\": " << comparison.product_seconds;
  addJson(out, "inertial", comparison.inertial);
  addJson(out, "quasi_static", comparison.quasi_static);
  out << "}\n";
  return out.str();
}
