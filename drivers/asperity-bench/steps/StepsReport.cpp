#include "steps/Steps.hpp"

#include <iomanip>
#include <sstream>

namespace
{
// How often a V-cycle reads the matrix of the finest level: once in the forward sweep and the
// residual together, once in the backward sweep, and half of it for the product that it leaves.
constexpr double matrix_reads_of_a_cycle = 2.5;

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
      << of(kind.products) << " | "
      << of(kind.products) + matrix_reads_of_a_cycle * of(kind.count.v_cycles) << " | "
      << kind.seconds / each / product << " | " << kind.setup_seconds / product << " | "
      << kind.count.rises << " |\n";
}

void addJson(std::ostream& out, char const* name, StepsSample const& kind)
{
  out << ", \"" << name << "\": {\"accepted\": " << kind.accepted;
  for (auto const& member : asperity::dynamics::SolveCount::members()) {
    out << ", \"" << member.name << "\": " << kind.count.*member.value;
  }
  out << ", \"products\": " << kind.products << ", \"seconds\": " << kind.seconds
      << ", \"setup_seconds\": " << kind.setup_seconds << "}";
}
// Messages of a V-cycle, a sweep, a line search and a coupled step.
void addMessages(std::ostream& out, StretchSample const& sample)
{
  if (sample.messages.empty()) {
    return;
  }
  auto const of = [&](std::int64_t asperity::dynamics::SolveCount::*number) {
    return static_cast<double>(sample.inertial.count.*number + sample.quasi_static.count.*number);
  };
  using Count = asperity::dynamics::SolveCount;
  out << "\nMessages from point to point and collective calls, each the largest of the ranks.\n\n"
         "| for each | work | messages | kB | collective |\n|---|---|---|---|---|\n";
  MessageCount step;
  for (auto const& [name, count] : sample.messages) {
    const bool is_cycle = name == "V-cycles", is_setup = name == "set-up of step sizes";
    const bool in_iteration = name == "Gauss-Seidel sweeps" || name == "line searches" ||
                              name == "linear corrections" || name == "Tnnmg";
    const double each = is_setup       ? sample.setups
                        : is_cycle     ? of(&Count::v_cycles)
                        : in_iteration ? of(&Count::tnnmg_iterations)
                                       : of(&Count::coupled_steps);
    const auto mean = [&](std::int64_t number) { return static_cast<double>(number) / each; };
    out << "| "
        << (is_setup       ? "step size"
            : is_cycle     ? "V-cycle"
            : in_iteration ? "iteration"
                           : "step")
        << " | " << (name.empty() ? "other" : name) << " | " << mean(count.messages) << " | "
        << mean(count.bytes) / 1e3 << " | " << mean(count.reductions) << " |\n";
    if (!is_setup) {
      step.messages += count.messages;
      step.bytes += count.bytes;
      step.reductions += count.reductions;
    }
  }
  const double steps = of(&Count::coupled_steps);
  out << "| step | all but set-up | " << static_cast<double>(step.messages) / steps << " | "
      << static_cast<double>(step.bytes) / steps / 1e3 << " | "
      << static_cast<double>(step.reductions) / steps << " |\n";
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
      << " kB per unknown\n\n"
         "For each coupled step: products of sparse matrices as counted, reads of the finest "
         "matrix by\nthem and by V-cycles, CPU time in products with K.\n\n"
         "| steps | tau [s] | accepted | coupled | rate problems | TNNMG | V-cycles | products | "
         "reads of Z | time | set-up, all | rises |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  addRow(out, "inertial", sample.inertial, sample.product_seconds);
  addRow(out, "quasi-static", sample.quasi_static, sample.product_seconds);
  addMessages(out, sample);
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
  for (auto const& [name, count] : sample.messages) {
    out << (name == sample.messages.begin()->first ? ", \"messages\": {\"" : ", \"") << name
        << "\": {\"messages\": " << count.messages << ", \"bytes\": " << count.bytes
        << ", \"reductions\": " << count.reductions << "}";
  }
  out << (sample.messages.empty() ? "}\n" : "}}\n");
  return out.str();
}
