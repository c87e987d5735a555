// A program with one way to fail per argument; GuardTest.cmake looks at its exit status and stderr.
#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Signals.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <csignal>
#include <cstdio>
#include <string>

namespace
{
using namespace asperity;

// A Tpetra object and a Kokkos kernel: they must work and die before the scope does.
int compute(RCP<const Communicator> const& communicator)
{
  const auto map = rcp(new Map(10 * communicator->getSize(), 0, communicator));
  Vector ones(map);
  ones.putScalar(1.0);
  return ones.dot(ones) == 10.0 * communicator->getSize() && Kokkos::is_initialized() ? 0 : 9;
}

int run(std::string const& way, RCP<const Communicator> const& communicator)
{
  const int rank = communicator->getRank();
  const int last = communicator->getSize() - 1;
  if (way == "compute") {
    return compute(communicator);
  }
  if (way == "all-input") {
    throw InputError("Friction / a = -0.01 is outside (0, inf).");
  }
  if (way == "all-differ") {
    throw SolveError("Failure number " + std::to_string(rank) + ".");
  }
  if (way == "last-throws-others-return" && rank == last) {
    throw InputError("Only the last rank noticed.");
  }
  if (way == "last-throws-others-wait") {
    if (rank == last) {
      throw SolveError("Only the last rank noticed.");
    }
    communicator->barrier();
  }
  if (way == "last-waits-others-throw") {
    if (rank != last) {
      throw InputError("Everybody but the last noticed.");
    }
    communicator->barrier();
  }
  if (way == "last-cannot-write") {
    onEveryRank(*communicator, [&] {
      if (rank == last) {
        throw OutputError("The disk is full.");
      }
    });
  }
  if (way == "other") {
    throw std::runtime_error("Something else.");
  }
  if (way == "unknown") {
    throw 42;
  }
  if (way == "status") {
    return rank == last ? exit_signal : exit_done;
  }
  if (way == "two-interrupts") {
    StopSignals signals;
    std::raise(SIGINT);
    std::raise(SIGINT);
  }
  return 0;
}
} // namespace

int main(int argc, char** argv)
{
  MpiScope scope(argc, argv);
  if (argc != 2) { // --kokkos... must be gone
    std::fprintf(stderr, "%d arguments are left\n", argc - 1);
    return 8;
  }
  const std::string way = argv[1];
  return runGuarded(*scope.communicator(), [&] { return run(way, scope.communicator()); });
}
