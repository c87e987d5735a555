#include "base/parallel/Agreement.hpp"

#include "base/Errors.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <exception>
#include <new>
#include <string>

namespace asperity
{
namespace
{
enum Kind
{
  done,
  input_error,
  solve_error,
  useless_run,
  output_error,
  out_of_memory,
  other_error
};

// How the work ended on one rank.
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
  } catch (UselessRun const& error) {
    return {useless_run, error.what()};
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
  case useless_run: throw UselessRun(message);
  case output_error: throw OutputError(message);
  case out_of_memory: throw std::bad_alloc();
  default: throw std::runtime_error(message);
  }
}

void raiseUnlessDone(Outcome const& outcome)
{
  if (outcome.kind != done) {
    raise(outcome.kind, outcome.message);
  }
}

// Throws the outcome of the rank `rank` on every rank.
void share(Outcome outcome, int rank, Communicator const& communicator)
{
  int report[2] = {outcome.kind, static_cast<int>(outcome.message.size())};
  Teuchos::broadcast(communicator, rank, 2, report);
  if (report[0] != done) {
    outcome.message.resize(static_cast<std::size_t>(report[1]));
    Teuchos::broadcast(communicator, rank, report[1], outcome.message.data());
    raise(static_cast<Kind>(report[0]), outcome.message);
  }
}
} // namespace

void onRoot(Communicator const& communicator, std::function<void()> const& work)
{
  const Outcome outcome = communicator.getRank() == 0 ? outcomeOf(work) : Outcome();
  if (communicator.getSize() == 1) {
    return raiseUnlessDone(outcome);
  }
  share(outcome, 0, communicator);
}

void onEveryRank(Communicator const& communicator, std::function<void()> const& work)
{
  const Outcome outcome = outcomeOf(work);
  const int num_ranks = communicator.getSize();
  if (num_ranks == 1) {
    return raiseUnlessDone(outcome); // once a step: without a collective call
  }
  const int mine = outcome.kind == done ? num_ranks : communicator.getRank();
  int lowest = mine;
  Teuchos::reduceAll(communicator, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(lowest));
  if (lowest < num_ranks) {
    share(outcome, lowest, communicator);
  }
}
} // namespace asperity
