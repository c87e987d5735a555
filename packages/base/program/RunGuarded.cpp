#include "base/Errors.hpp"
#include "base/parallel/MeetingPoint.hpp"
#include "base/program/MpiScope.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <thread>

namespace asperity
{
namespace
{
using Seconds = std::chrono::duration<double>;

bool holds_unclosed = false;

struct Outcome
{
  int status = exit_done;
  bool has_thrown = false;
  std::string message;
};

Outcome failed(int status, std::string const& message) { return {status, true, message}; }

Outcome call(std::function<int()> const& body)
{
  try {
    return {body(), false, ""};
  } catch (std::bad_alloc const&) {
    return failed(exit_other, "Out of memory. Use more ranks on more machines, or a coarser mesh.");
  } catch (std::exception const& error) {
    return failed(exitStatus(error), error.what());
  } catch (...) {
    return failed(exit_other, "An exception of unknown type was thrown.");
  }
}

void flushAll()
{
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

class GuardCommunicator
{
public:
  explicit GuardCommunicator(Communicator const& communicator)
      : meeting_point_(communicator)
      , communicator_(meeting_point_.communicator())
      , rank_(communicator.getRank())
      , size_(communicator.getSize())
  {
  }

  bool meet(double timeout) const { return meeting_point_.meet(timeout); }

  // The program's status on every rank. Only the lowest rank that has thrown prints: where many
  // fail at once, each with a vertex of its own, one message is enough.
  int agree(Outcome const& outcome, std::string const& program) const;

  bool any(bool value) const { return smallest(value ? 0 : 1) == 0; }

  [[noreturn]] void abort(Outcome const& outcome, std::string const& program) const;

private:
  int smallest(int value) const
  {
    int result = 0;
    MPI_Allreduce(&value, &result, 1, MPI_INT, MPI_MIN, communicator_);
    return result;
  }

  // The number of ranks that have thrown another message than the rank `printer`, on that rank.
  int countOthers(Outcome const& outcome, int printer) const;

  MeetingPoint meeting_point_;
  MPI_Comm communicator_;
  int rank_;
  int size_;
};

int GuardCommunicator::countOthers(Outcome const& outcome, int printer) const
{
  int length = static_cast<int>(outcome.message.size());
  MPI_Bcast(&length, 1, MPI_INT, printer, communicator_);
  std::string reported = outcome.message;
  reported.resize(static_cast<std::size_t>(length));
  MPI_Bcast(reported.data(), length, MPI_CHAR, printer, communicator_);
  const int differs = outcome.has_thrown && outcome.message != reported ? 1 : 0;
  int count = 0;
  MPI_Reduce(&differs, &count, 1, MPI_INT, MPI_SUM, printer, communicator_);
  return count;
}

void printMessage(std::string const& program, std::string const& message)
{
  std::cout.flush();
  std::cerr << program + ": " + message + "\n" << std::flush;
}

int GuardCommunicator::agree(Outcome const& outcome, std::string const& program) const
{
  const int printer = smallest(outcome.has_thrown ? rank_ : size_);
  if (printer == size_) {
    return -smallest(-outcome.status);
  }
  const int others = countOthers(outcome, printer);
  if (rank_ == printer) {
    const std::string ranks =
      std::to_string(others) + (others == 1 ? " other rank" : " other ranks");
    const std::string note = " (" + ranks + " failed differently.)";
    printMessage(program, outcome.message + (others == 0 ? "" : note));
  }
  int status = outcome.status;
  MPI_Bcast(&status, 1, MPI_INT, printer, communicator_);
  return status;
}

// Several ranks may call this. The lowest one prints its message and aborts first, which ends the
// others while they wait.
void GuardCommunicator::abort(Outcome const& outcome, std::string const& program) const
{
  std::this_thread::sleep_for(Seconds(0.5 * std::min(rank_, 20)));
  printMessage(program, outcome.message);
  MPI_Abort(communicator_, outcome.status);
  std::abort();
}
} // namespace

ExitStatus exitStatus(std::exception const& error)
{
  return dynamic_cast<InputError const*>(&error) != nullptr    ? exit_input
         : dynamic_cast<SolveError const*>(&error) != nullptr  ? exit_solve
         : dynamic_cast<OutputError const*>(&error) != nullptr ? exit_output
                                                               : exit_other;
}

void noteUnclosedHdf5() { holds_unclosed = true; }

void exitIfHdf5HasUnclosed(int status)
{
  if (holds_unclosed) {
    flushAll();
    std::_Exit(status);
  }
}

int runGuarded(Communicator const& communicator, std::function<int()> const& body,
               std::string const& program, double timeout)
{
  const GuardCommunicator guard(communicator);
  const Outcome outcome = call(body);
  if (!guard.meet(outcome.has_thrown ? timeout : -1.0)) {
    guard.abort(outcome, program);
  }
  const int status = guard.agree(outcome, program);
  if (guard.any(holds_unclosed)) {
    flushAll();
    std::_Exit(status);
  }
  return status;
}
} // namespace asperity
