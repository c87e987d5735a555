#include "base/parallel/Agreement.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <thread>

namespace asperity
{
namespace
{
enum Kind
{
  done,
  input_error,
  solve_error,
  output_error,
  out_of_memory,
  other_error
};

// What became of the work on one rank.
struct Outcome
{
  Kind kind = done;
  std::string message;
};

Outcome outcomeOf(std::function<void()> const& work)
{
  try {
    work();
  } catch (InputError const& error) {
    return {input_error, error.what()};
  } catch (SolveError const& error) {
    return {solve_error, error.what()};
  } catch (OutputError const& error) {
    return {output_error, error.what()};
  } catch (std::bad_alloc const&) {
    return {out_of_memory, ""};
  } catch (std::exception const& error) {
    return {other_error, error.what()};
  } catch (...) {
    return {other_error, "An exception of unknown type was thrown."};
  }
  return {};
}

[[noreturn]] void raise(Kind kind, std::string const& message)
{
  switch (kind) {
  case input_error: throw InputError(message);
  case solve_error: throw SolveError(message);
  case output_error: throw OutputError(message);
  case out_of_memory: throw std::bad_alloc();
  default: throw std::runtime_error(message);
  }
}

// Throws the outcome of the rank `rank` on every rank.
void share(Outcome outcome, int rank, Communicator const& communicator)
{
  int report[2] = {outcome.kind, static_cast<int>(outcome.message.size())};
  Teuchos::broadcast(communicator, rank, 2, report);
  if (report[0] == done) {
    return;
  }
  outcome.message.resize(static_cast<std::size_t>(report[1]));
  Teuchos::broadcast(communicator, rank, report[1], outcome.message.data());
  raise(static_cast<Kind>(report[0]), outcome.message);
}

// Waits for ever if `patience` is negative, or else so many seconds.
bool isDone(MPI_Request& request, double patience)
{
  if (patience < 0) {
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    return true;
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(patience);
  int is_done = 0;
  while (!is_done && Clock::now() < end) {
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
    if (!is_done) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  return is_done != 0;
}
} // namespace

void onRoot(Communicator const& communicator, std::function<void()> const& work)
{
  share(communicator.getRank() == 0 ? outcomeOf(work) : Outcome(), 0, communicator);
}

void onEveryRank(Communicator const& communicator, std::function<void()> const& work,
                 double patience)
{
  const Outcome outcome = outcomeOf(work);
  const int num_ranks = communicator.getSize();
  const int mine = outcome.kind == done ? num_ranks : communicator.getRank();
  int lowest = mine;
  if (num_ranks > 1) {
    MPI_Request request;
    MPI_Iallreduce(&mine, &lowest, 1, MPI_INT, MPI_MIN, rawCommunicator(communicator), &request);
    if (!isDone(request, outcome.kind == done ? -1 : patience)) {
      raise(outcome.kind, outcome.message);
    }
  }
  if (lowest < num_ranks) {
    share(outcome, lowest, communicator);
  }
}
} // namespace asperity
