#include "stiffness/FaultStiffness.hpp"

#include <iomanip>
#include <sstream>

std::string stiffnessTable(FaultStiffness const& stiffness)
{
  std::ostringstream out;
  out << "\n"
      << stiffness.size() << " nodes slide, over " << stiffness.positions.back()
      << " m. Slip cos(kx) under a Gaussian of width 5/k around the middle, "
      << stiffness.positions[stiffness.size() / 2]
      << " m down:\nthe traction's error against an infinite body.\n\n"
         "| cells in a wave | cells [m] | error |\n|---|---|---|\n";
  for (auto const& wave : waveErrors(stiffness)) {
    out << "| " << wave.cells << " | " << wave.smallest_cell << " to " << wave.largest_cell << " | "
        << wave.error << " |\n";
  }
  return out.str();
}

std::string stiffnessText(FaultStiffness const& stiffness)
{
  std::ostringstream out;
  out << std::setprecision(15) << "# position [m], weight [m], traction [Pa/m] by slip at each node"
      << (stiffness.compression.empty() ? "" : ", compression [Pa/m] likewise") << "\n";
  const int n = stiffness.size();
  for (int i = 0; i < n; ++i) {
    out << stiffness.positions[i] << ' ' << stiffness.weights[i];
    for (auto const* matrix : {&stiffness.traction, &stiffness.compression}) {
      for (int j = 0; j < n && !matrix->empty(); ++j) {
        out << ' ' << (*matrix)[static_cast<std::size_t>(i) * n + j];
      }
    }
    out << '\n';
  }
  return out.str();
}
