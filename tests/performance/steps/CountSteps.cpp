// count-steps NUM_STEPS DECK.xml [--set "Path/To/Parameter=value"]...
//
// Makes the first accepted steps of a deck in space and prints, as JSON, what they took: the counts
// of the solver; and for some kinds of work (asperity::currentWork), and for all but the set-up of
// step sizes, what ranks sent and their passes over sparse matrices in products, each number that
// of the rank where it is largest.
#include "base/parallel/Reductions.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/WorkTimers.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/run/Evolution.hpp"

#include <Kokkos_Core.hpp>
#include <mpi.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

namespace
{
enum What
{
  messages, // from point to point
  bytes,    // in them
  collective,
  products
};
constexpr char const* names[] = {"messages", "bytes", "collective", "products"};
using Counts = std::array<std::int64_t, 4>;

std::map<std::string, Counts> counts;

void add(What what, std::int64_t number)
{
  const std::string work = asperity::currentWork();
  counts[work][what] += number;
  if (work != "set-up of step sizes") {
    counts["all"][what] += number;
  }
}

void countMessage(int count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  add(messages, 1);
  add(bytes, std::int64_t(count) * size);
}

void countCollective() { add(collective, 1); }

// V-cycles have kernels of their own.
constexpr std::string_view product = "asperity::base::multiply",
                           of_tpetra = "Tpetra::CrsMatrix::localApply";

void countKernel(char const* name, std::uint32_t, std::uint64_t*)
{
  if (name == product) {
    add(products, 1);
  }
}

void countRegion(char const* name)
{
  if (name == of_tpetra) {
    add(products, 1);
  }
}
} // namespace

// MPI's profiling interface: every library that the program loads calls these instead of MPI's.
#define COUNTED(function, counting, parameters, arguments)                                         \
  int MPI_##function parameters                                                                    \
  {                                                                                                \
    counting;                                                                                      \
    return PMPI_##function arguments;                                                              \
  }
#define MESSAGE(function)                                                                          \
  COUNTED(function, countMessage(count, type),                                                     \
          (const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm),        \
          (data, count, type, to, tag, comm))
#define STARTED_MESSAGE(function)                                                                  \
  COUNTED(function, countMessage(count, type),                                                     \
          (const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,         \
           MPI_Request* request),                                                                  \
          (data, count, type, to, tag, comm, request))
#define EXCHANGE(function)                                                                         \
  COUNTED(function, countCollective(),                                                             \
          (const void* mine, int count, MPI_Datatype type, void* all, int all_count,               \
           MPI_Datatype all_type, MPI_Comm comm),                                                  \
          (mine, count, type, all, all_count, all_type, comm))

extern "C" {
MESSAGE(Send)
MESSAGE(Rsend)
MESSAGE(Ssend)
STARTED_MESSAGE(Isend)
STARTED_MESSAGE(Irsend)
EXCHANGE(Allgather)
EXCHANGE(Alltoall)
COUNTED(Allreduce, countCollective(),
        (const void* mine, void* all, int count, MPI_Datatype type, MPI_Op operation,
         MPI_Comm comm),
        (mine, all, count, type, operation, comm))
COUNTED(Reduce, countCollective(),
        (const void* mine, void* all, int count, MPI_Datatype type, MPI_Op operation, int root,
         MPI_Comm comm),
        (mine, all, count, type, operation, root, comm))
COUNTED(Bcast, countCollective(),
        (void* data, int count, MPI_Datatype type, int root, MPI_Comm comm),
        (data, count, type, root, comm))
COUNTED(Barrier, countCollective(), (MPI_Comm comm), (comm))
}

int main(int argc, char** argv)
{
  setenv("TPETRA_USE_KOKKOS_PROFILING", "1", 1); // before Tpetra is used
  asperity::MpiScope parallel(argc, argv);
  auto const& communicator = parallel.communicator();
  return asperity::runGuarded(*communicator, [&] {
    // 1. Read the command line and the deck.
    const int num_steps = std::stoi(argv[1]);
    auto const deck =
      asperity::scenario::readCompleteDeck(asperity::parseCommandLine(argc - 1, argv + 1));
    // 2. Make the steps.
    auto const problem = asperity::scenario::makeProblem<3>(*deck, communicator);
    asperity::scenario::Evolution<3> evolution(problem, *deck, {});
    counts.clear();
    Kokkos::Tools::Experimental::set_push_region_callback(countRegion);
    Kokkos::Tools::Experimental::set_begin_parallel_for_callback(countKernel);
    for (int i = 0; i < num_steps; ++i) {
      evolution.advance();
    }
    Kokkos::Tools::Experimental::set_push_region_callback(nullptr);
    Kokkos::Tools::Experimental::set_begin_parallel_for_callback(nullptr);
    auto taken = counts;
    // 3. Print what they took.
    std::ostringstream text;
    char const* between = "{";
    for (auto const& member : asperity::dynamics::SolveCount::members()) {
      text << between << '"' << member.name << "\": " << evolution.summary().count.*member.value;
      between = ", ";
    }
    for (char const* work : {"right sides of steps", "Gauss-Seidel sweeps", "linear corrections",
                             "V-cycles", "line searches", "all"}) {
      const auto most = asperity::maxOverRanks(taken[work], *communicator);
      text << ", \"" << work << "\": {";
      for (int i = 0; i < 4; ++i) {
        text << (i == 0 ? "\"" : ", \"") << names[i] << "\": " << most[i];
      }
      text << '}';
    }
    if (communicator->getRank() == 0) {
      std::cout << text.str() << "}\n";
    }
    return int(asperity::exit_done);
  });
}
