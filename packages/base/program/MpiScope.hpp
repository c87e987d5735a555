#pragma once

#include "base/Types.hpp"

#include <functional>
#include <string>

namespace asperity
{
// MPI, Kokkos and Tpetra from construction to destruction, in the order that is safe:
//
//   int main(int argc, char** argv)
//   {
//     asperity::MpiScope scope(argc, argv);
//     return asperity::runGuarded(*scope.communicator(), [&] { ...; return 0; });
//   }
//
// Kokkos gets only the arguments that start with --kokkos; those that it knows are removed from
// argv. --help and what Kokkos does not know are left for the program, whose Options refuse it. If
// MPI or Kokkos was running before, the scope leaves it running. A write beyond the limit of a
// file's size fails as on a full disk: it ignores SIGXFSZ. Tpetra objects must die before the
// scope: keep them inside the guarded function.
class MpiScope
{
public:
  MpiScope(int& argc, char**& argv);
  ~MpiScope();
  MpiScope(MpiScope const&) = delete;
  MpiScope& operator=(MpiScope const&) = delete;

  RCP<const Communicator> const& communicator() const { return communicator_; }

private:
  bool owns_mpi_ = false;
  RCP<const Communicator> communicator_;
};

// Exit statuses of the programs.
enum ExitStatus
{
  exit_done = 0,
  exit_other = 1,
  exit_input = 2,
  exit_solve = 3,
  exit_signal = 4,
  exit_output = 5
};

// The status of a program that ends with this error: 2 (InputError), 3 (SolveError),
// 5 (OutputError) or 1 (others).
ExitStatus exitStatus(std::exception const& error);

// HDF5 holds something that it could not close, for example because the disk is full. Its own
// clean-up, in MPI_Finalize and at the exit of the program, would try again and crash.
void noteUnclosedHdf5();

// Ends the process with this status at once if HDF5's clean-up would crash, after all output has
// been written; returns otherwise.
void exitIfHdf5HasUnclosed(int status);

// Runs `body` on every rank and returns the exit status of the program, the same on all ranks: the
// largest that `body` returned or, after an exception, exitStatus of the exception on the lowest
// rank that threw. Its message goes to stderr, once: "<program>: <message>". If some rank has
// thrown and others have not finished `timeout` seconds later, they may be waiting for it:
// MPI_Abort with the same status. If HDF5 holds files that it could not close, all ranks end there,
// without MPI_Finalize. Collective.
int runGuarded(Communicator const& communicator, std::function<int()> const& body,
               std::string const& program = "asperity", double timeout = 2.0);
} // namespace asperity
