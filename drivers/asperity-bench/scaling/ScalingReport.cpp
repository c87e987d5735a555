#include "scaling/Scaling.hpp"

#include <iomanip>
#include <sstream>

std::string scalingTable(std::vector<MeshSample> const& samples, int num_ranks)
{
  std::ostringstream out;
  out << std::setprecision(3);
  for (auto const& mesh : samples) {
    out << "\n"
        << mesh.num_unknowns << " unknowns, " << mesh.num_fault_nodes << " fault nodes, cell size "
        << mesh.cell_size << ", " << num_ranks << (num_ranks > 1 ? " ranks" : " rank")
        << "; built in " << mesh.build_seconds << " s; product with K "
        << 1e3 * mesh.product_seconds << " ms; peak memory " << mesh.peak_bytes / 1e6 << " MB, "
        << mesh.peak_bytes / static_cast<double>(mesh.num_unknowns) / 1e3 << " kB per unknown\n\n"
        << "| tau [s] | phase | TNNMG | corrections | V-cycles | set-up [s] | solve [s] | error |\n"
        << "|---|---|---|---|---|---|---|---|\n";
    for (auto const& solve : mesh.solves) {
      out << "| " << solve.tau << " | " << nameOf(solve.phase) << " | " << solve.iterations
          << (solve.converged ? "" : " (not converged)") << " | " << solve.corrections << " | "
          << solve.v_cycles << " | " << solve.setup_seconds << " | " << solve.seconds << " | "
          << solve.error << " |\n";
    }
  }
  return out.str();
}

std::string scalingJson(std::vector<MeshSample> const& samples, int num_ranks)
{
  std::ostringstream out;
  out << std::setprecision(6) << "{\"ranks\": " << num_ranks << ", \"meshes\": [";
  char const* between_meshes = "\n";
  for (auto const& mesh : samples) {
    out << between_meshes << "  {\"unknowns\": " << mesh.num_unknowns
        << ", \"fault_nodes\": " << mesh.num_fault_nodes << ", \"cell_size\": " << mesh.cell_size
        << ", \"build_seconds\": " << mesh.build_seconds
        << ", \"product_seconds\": " << mesh.product_seconds
        << ", \"peak_bytes\": " << mesh.peak_bytes << ", \"solves\": [";
    between_meshes = ",\n";
    char const* between = "\n";
    for (auto const& solve : mesh.solves) {
      out << between << "    {\"phase\": \"" << nameOf(solve.phase) << "\", \"tau\": " << solve.tau
          << ", \"tnnmg_iterations\": " << solve.iterations
          << ", \"corrections\": " << solve.corrections << ", \"v_cycles\": " << solve.v_cycles
          << ", \"setup_seconds\": " << solve.setup_seconds << ", \"seconds\": " << solve.seconds
          << ", \"converged\": " << (solve.converged ? "true" : "false")
          << ", \"error\": " << solve.error << "}";
      between = ",\n";
    }
    out << "]}";
  }
  out << "]}\n";
  return out.str();
}
