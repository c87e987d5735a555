#include "scenario/report/ModelSize.hpp"

#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "scenario/checks/Rounded.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace asperity::scenario
{
namespace
{
struct CellCount
{
  double number = 0, smallest = 0, largest = 0; // diameters in m
};

// Each cell counts once: where its first vertex is owned.
template <int Dim>
CellCount countCells(Mesh<Dim> const& mesh, Communicator const& communicator)
{
  double number = 0;
  for (auto const& cell : mesh.cells) {
    number += cell[0] < mesh.num_owned ? 1 : 0;
  }
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const double diameter : mesh::cellDiameters(mesh)) {
    smallest = std::min(smallest, diameter);
    largest = std::max(largest, diameter);
  }
  return {sumOverRanks(number, communicator), minOverRanks(smallest, communicator),
          maxOverRanks(largest, communicator)};
}
} // namespace

double peakBytes()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

template <int Dim>
std::vector<std::string> describeSize(Problem<Dim> const& problem)
{
  const auto cells = countCells(problem.mesh(), *problem.communicator);
  const double unknowns =
    static_cast<double>(problem.mesh().num_global_vertices) * problem.components();
  const double peak = sumOverRanks(peakBytes(), *problem.communicator);
  std::ostringstream mesh, memory;
  mesh.precision(12);
  mesh << "Mesh: " << cells.number << (Dim == 2 ? " triangles, " : " tetrahedra, ")
       << problem.mesh().num_global_vertices << " vertices, " << unknowns
       << " unknowns; cells have diameters of " << rounded(cells.smallest) << " to "
       << rounded(cells.largest) << " m.";
  memory << "Memory: " << rounded(peak / 1e6) << " MB on all ranks with mesh and matrices; ";
  if (problem.solver.correction == dynamics::Correction::direct) {
    memory << "the factors of the direct correction add to it.";
  } else {
    auto const [least, most] = tnnmg::MultigridCorrection::usual_bytes_per_unknown;
    memory << "multigrid usually takes " << rounded(least / 1e3) << " to " << rounded(most / 1e3)
           << " kB per unknown, here " << rounded(least * unknowns / 1e6) << " to "
           << rounded(most * unknowns / 1e6) << " MB.";
  }
  return {mesh.str(), memory.str()};
}

template std::vector<std::string> describeSize(Problem<2> const&);
template std::vector<std::string> describeSize(Problem<3> const&);
} // namespace asperity::scenario
