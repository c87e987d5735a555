#include "refinement/MemoryCheck.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"

#include <unistd.h>

#include <cmath>
#include <limits>

namespace asperity::refinement
{
namespace
{
// The number of cells around owned vertices, each counted by the share of its corners that is
// owned: summed over the ranks this is the number of cells. Few children of ghost cells stay here.
template <int Dim>
double shareOfCells(Mesh<Dim> const& part)
{
  double corners = 0.0;
  for (auto const& cell : part.cells) {
    for (int vertex : cell) {
      corners += vertex < part.num_owned ? 1.0 : 0.0;
    }
  }
  return corners / (Dim + 1);
}

double physicalMemory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

// The sum over the ranks that share this rank's memory.
double sumOnNode(double mine, Communicator const& communicator)
{
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(rawCommunicator(communicator), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  double sum = 0.0;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, node);
  MPI_Comm_free(&node);
  return sum;
}
} // namespace

template <int Dim>
void requireMemory(Mesh<Dim> const& part, int refinements, Communicator const& communicator,
                   std::string const& where)
{
  const double growth = std::pow(2.0, static_cast<double>(Dim) * refinements);
  const double mine = growth * shareOfCells(part);
  const double largest = maxOverRanks(mine, communicator);
  const double all = sumOverRanks(mine, communicator);
  const std::string what = where + " = " + std::to_string(refinements);
  // The factor 8 is for several dofs per vertex, with a margin.
  const double num_global = static_cast<double>(std::numeric_limits<GlobalOrdinal>::max()) / 8;
  ASPERITY_REQUIRE(all < num_global, what << " makes some " << all << " cells, more than "
                                          << 8 * sizeof(GlobalOrdinal)
                                          << " bits can number. Refine less often.");
  const double num_local = 0.9 * std::numeric_limits<int>::max(); // a margin for ghosts
  ASPERITY_REQUIRE(largest < num_local, what << " makes some " << all << " cells, " << largest
                                             << " of them on one rank, which can number "
                                             << num_local
                                             << ". Refine less often, or use more ranks.");
  const double wanted = sumOnNode(mine, communicator) * bytes_per_cell;
  const double excess = wanted / physicalMemory();
  const double worst = maxOverRanks(excess, communicator);
  const double memory = minOverRanks(excess == worst ? physicalMemory() : 1e300, communicator);
  ASPERITY_REQUIRE(worst < 1.0, what << " makes some " << all << " cells: the ranks of one machine "
                                     << "would need " << worst * memory / 1e9
                                     << " GB for the mesh alone, and it has " << memory / 1e9
                                     << " GB. Refine less often, or use more machines.");
}

template void requireMemory(Mesh<2> const&, int, Communicator const&, std::string const&);
template void requireMemory(Mesh<3> const&, int, Communicator const&, std::string const&);
} // namespace asperity::refinement
