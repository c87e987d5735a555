#include "io/OutputSet.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/VerticalFault.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

// A fault has too many nodes for one rank: outputs gather a few numbers of each rank, no node's.
using namespace asperity;
using namespace asperity::io;

namespace
{
std::int64_t largest_gather = 0; // in bytes, of those that this rank has received

void note(int const* counts, MPI_Datatype type, MPI_Comm comm)
{
  // Ours have MPI's own types of numbers. HDF5 gathers bytes, and from 1.14 on structures that
  // describe compressed chunks.
  int integers = 0, addresses = 0, types = 0, combiner = 0;
  PMPI_Type_get_envelope(type, &integers, &addresses, &types, &combiner);
  if (type == MPI_BYTE || combiner != MPI_COMBINER_NAMED) {
    return;
  }
  int num_ranks = 0, size = 0;
  PMPI_Comm_size(comm, &num_ranks);
  PMPI_Type_size(type, &size);
  const auto count = std::accumulate(counts, counts + num_ranks, std::int64_t(0));
  largest_gather = std::max(largest_gather, count * size);
}
} // namespace

// All libraries of the program call these instead of MPI's.
extern "C" {
int MPI_Gatherv(const void* mine, int count, MPI_Datatype type, void* all, const int* counts,
                const int* offsets, MPI_Datatype all_type, int root, MPI_Comm comm)
{
  int rank = 0;
  PMPI_Comm_rank(comm, &rank);
  if (rank == root) {
    note(counts, all_type, comm);
  }
  return PMPI_Gatherv(mine, count, type, all, counts, offsets, all_type, root, comm);
}
int MPI_Allgatherv(const void* mine, int count, MPI_Datatype type, void* all, const int* counts,
                   const int* offsets, MPI_Datatype all_type, MPI_Comm comm)
{
  note(counts, all_type, comm);
  return PMPI_Allgatherv(mine, count, type, all, counts, offsets, all_type, comm);
}
}

namespace
{
struct Fault : test::VerticalFault
{
  Fault()
  {
    for (auto const* name : {"alpha", "shear_modulus"}) {
      add("fault", name, 1, [](double const*, int) { return 20; });
    }
  }
};

void expectSmallGathers(std::string const& output)
{
  ParameterList list;
  for (auto const& name : OutputRegistry::instance().names()) {
    list.sublist(name).set("Enabled", name == output);
  }
  test::TemporaryDirectory directory;
  largest_gather = 0;
  Fault fault;
  OutputSet outputs(list, fault.context(directory.path()));
  outputs.write(fault.at(0, 1));
  outputs.write(fault.at(1, 1, true));
  outputs.closeSegment();
  const std::int64_t few = 2 * sizeof(double) * test::world()->getSize();
  static_assert((test::block_nx + 1) * (test::block_nz + 1) > 3 * 2 * 2, "more nodes than that");
  EXPECT_LE(largest_gather, few) << output;
}
} // namespace

TEST(Gathers, NoOutputHasAllNodesOfASurfaceOnOneRank)
{
  for (auto const* output : {"Fault History", "Rupture", "Event Catalogue", "Volume Snapshots"}) {
    expectSmallGathers(output);
  }
}
