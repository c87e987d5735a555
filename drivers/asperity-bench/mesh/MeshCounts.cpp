#include "mesh/MeshCounts.hpp"

#include "base/parallel/Reductions.hpp"
#include "measuring/Meters.hpp"
#include "scenario/setup/BoundarySetup.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"

#include <iomanip>
#include <sstream>

using namespace asperity;

namespace
{
// A number over the ranks: its sum, and its largest value over its mean.
struct Shares
{
  double sum = 0, largest_over_mean = 0;

  Shares(double mine, Communicator const& communicator)
      : sum(sumOverRanks(mine, communicator))
      , largest_over_mean(maxOverRanks(mine, communicator) * communicator.getSize() / sum)
  {
  }
};

std::ostream& operator<<(std::ostream& out, Shares const& shares)
{
  return out << std::setprecision(15) << shares.sum << ", largest over mean "
             << std::setprecision(4) << shares.largest_over_mean;
}

// Each cell counts once: where its first vertex is owned.
template <int Dim>
double ownCells(Mesh<Dim> const& mesh)
{
  double count = 0;
  for (auto const& cell : mesh.cells) {
    count += cell[0] < mesh.num_owned ? 1 : 0;
  }
  return count;
}

template <int Dim>
std::string countsOf(ParameterList const& deck, RCP<const Communicator> const& communicator)
{
  auto const& comm = *communicator;
  const int components = scenario::displacementComponents(deck.sublist("Bulk"), Dim);
  auto const conditions =
    scenario::makeBoundaryConditions<Dim>(deck.sublist("Boundary Conditions"), components);
  const double before = sumOverRanks(peakBytes(), comm);
  auto const mesh =
    scenario::makeMesh<Dim>(deck.sublist("Mesh"), conditions.faults.front(), communicator);
  const double after = sumOverRanks(peakBytes(), comm);
  const Shares cells(ownCells(mesh), comm);
  std::ostringstream text;
  text << "cells     " << cells << "\n"
       << "  and ghosts " << Shares(static_cast<double>(mesh.cells.size()), comm) << "\n"
       << "vertices  " << Shares(mesh.num_owned, comm) << "\n"
       << "  and ghosts " << Shares(static_cast<double>(mesh.vertices.size()), comm) << "\n"
       << "memory    " << before / 1e6 << " MB before and " << after / 1e6 << " MB at the peak, "
       << (after - before) / cells.sum << " bytes per cell\n";
  return text.str();
}
} // namespace

std::string meshCounts(ParameterList const& deck, RCP<const Communicator> const& communicator)
{
  return scenario::meshDimension(deck.sublist("Mesh"), *communicator) == 2
           ? countsOf<2>(deck, communicator)
           : countsOf<3>(deck, communicator);
}
