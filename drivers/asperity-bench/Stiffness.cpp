#include "Stiffness.hpp"

#include "FaultStiffness.hpp"
#include "WavesOnPlane.hpp"

#include "base/Errors.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace asperity::bench
{
namespace
{
// Slip cos(kx) exp(-(kx/5)^2/2) at a distance x from the middle of the window, and its traction in
// an infinite body. The traction is exact except for the tiny part of the slip's Fourier transform
// at negative wavenumbers, where -k/2 is not -|k|/2: to 1e-5.
struct Wave
{
  double k, half_plane;

  double width() const { return 5 / k; }
  double window(double x) const { return std::exp(-x * x / (2 * width() * width())); }
  double slip(double x) const { return window(x) * std::cos(k * x); }
  double traction(double x) const
  {
    const double slope = -x / (width() * width()) * window(x);
    return -half_plane / 2 * (k * slip(x) + slope * std::sin(k * x));
  }
};

// "cells [m] | error": the cells where the window is more than 1e-4, and the relative error of the
// traction, averaged over the slip.
std::string errorOf(FaultStiffness const& stiffness, Wave const& wave, double middle)
{
  const int n = stiffness.size();
  double found = 0, exact = 0, smallest = stiffness.positions.back(), largest = 0;
  for (int i = 0; i < n; ++i) {
    const double x = stiffness.positions[i] - middle;
    const double share = stiffness.weights[i] * wave.slip(x);
    exact += share * wave.traction(x);
    for (int j = 0; j < n; ++j) {
      found += share * stiffness.traction[static_cast<std::size_t>(i) * n + j] *
               wave.slip(stiffness.positions[j] - middle);
    }
    if (i > 0 && wave.window(x) > 1e-4) {
      const double cell = stiffness.positions[i] - stiffness.positions[i - 1];
      smallest = std::min(smallest, cell);
      largest = std::max(largest, cell);
    }
  }
  std::ostringstream text;
  text << smallest << " to " << largest << " | " << found / exact - 1;
  return text.str();
}

std::string tableOf(FaultStiffness const& stiffness)
{
  const int middle = stiffness.size() / 2;
  const double x = stiffness.positions[middle], length = stiffness.positions.back();
  std::ostringstream out;
  out << "\n"
      << stiffness.size() << " nodes slide, over " << length
      << " m. Slip cos(kx) under a Gaussian of width 5/k around the middle, " << x
      << " m down:\nthe traction's error against an infinite body.\n\n"
         "| cells in a wave | cells [m] | error |\n|---|---|---|\n";
  for (int cells = 12;; cells *= 2) {
    const Wave wave = {2 * M_PI / (cells * stiffness.weights[middle]), stiffness.half_plane};
    if (4 * wave.width() > std::min(x, length - x)) { // 3e-4 of the slip beyond
      return out.str();
    }
    out << "| " << cells << " | " << errorOf(stiffness, wave, x) << " |\n";
  }
}

std::string rowsOf(FaultStiffness const& stiffness)
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

// In space, as text for numpy.loadtxt after a line of names.
Report reportOf(PlaneStiffness const& stiffness)
{
  ASPERITY_REQUIRE(!stiffness.waves.empty(),
                   "asperity-bench stiffness: waves of 8 cells of "
                     << stiffness.cell << " m, 13 cells to each side, do not fit into the fault, "
                     << "which ends " << stiffness.extent
                     << " m from its middle. Use smaller cells.");
  std::ostringstream table, file;
  table << "\nCells of " << stiffness.cell
        << " m at the middle of the fault. Slip cos(kx) under a Gaussian of width 3/k there:\n"
           "the energy's error against a half space.\n\n"
           "| cells in a wave | slip along the wave | across it |\n|---|---|---|\n";
  file << "# cells in a wave, error of slip along the wave, across it\n";
  for (auto const& wave : stiffness.waves) {
    table << "| " << wave.cells << " | " << wave.along << " | " << wave.across << " |\n";
    file << wave.cells << ' ' << wave.along << ' ' << wave.across << '\n';
  }
  return {table.str(), file.str()};
}
} // namespace

Report measureStiffness(ParameterList const& deck, RCP<const Communicator> const& communicator)
{
  ASPERITY_REQUIRE(communicator->getSize() == 1, "asperity-bench stiffness runs on one rank.");
  if (scenario::meshDimension(deck.sublist("Mesh"), *communicator) == 3) {
    return reportOf(stiffnessOfPlane(deck, communicator));
  }
  auto const stiffness = stiffnessOfFault(deck, communicator);
  return {tableOf(stiffness), rowsOf(stiffness)};
}
} // namespace asperity::bench
