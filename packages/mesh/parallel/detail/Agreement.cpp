#include "mesh/parallel/detail/Agreement.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace asperity::mesh::detail
{
void requireOnEveryRank(std::string const& problem, Communicator const& communicator)
{
  const int num_ranks = communicator.getSize();
  const int mine = problem.empty() ? num_ranks : communicator.getRank();
  int lowest = num_ranks;
  Teuchos::reduceAll(communicator, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(lowest));
  if (lowest == num_ranks) {
    return;
  }
  std::string message = problem;
  auto length = static_cast<int>(message.size());
  Teuchos::broadcast(communicator, lowest, &length);
  message.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(communicator, lowest, length, &message[0]);
  throw InputError(message);
}

std::vector<int> onAnyRank(std::vector<int> const& flags, Communicator const& communicator)
{
  std::vector<int> result(flags.size(), 0);
  Teuchos::reduceAll(communicator, Teuchos::REDUCE_MAX, static_cast<int>(flags.size()),
                     flags.data(), result.data());
  return result;
}
} // namespace asperity::mesh::detail
