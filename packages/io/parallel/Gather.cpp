#include "io/parallel/Gather.hpp"

#include "base/Errors.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <exception>
#include <numeric>
#include <string>

namespace asperity::io::detail
{
MPI_Comm rawCommunicator(Communicator const& comm)
{
  auto const* mpi = dynamic_cast<Teuchos::MpiComm<int> const*>(&comm);
  return mpi ? static_cast<MPI_Comm>(*mpi->getRawMpiComm()) : MPI_COMM_SELF;
}

namespace
{
MPI_Datatype typeOf(double) { return MPI_DOUBLE; }
MPI_Datatype typeOf(GlobalOrdinal) { return MPI_LONG_LONG; }
MPI_Datatype typeOf(char) { return MPI_CHAR; }

struct Blocks
{
  std::vector<int> counts, offsets;
  int total = 0;
};

Blocks blocksOfRanks(std::size_t mine, Communicator const& comm)
{
  Blocks blocks;
  const int count = static_cast<int>(mine);
  blocks.counts.resize(comm.getSize());
  blocks.offsets.resize(comm.getSize(), 0);
  MPI_Allgather(&count, 1, MPI_INT, blocks.counts.data(), 1, MPI_INT, rawCommunicator(comm));
  std::partial_sum(blocks.counts.begin(), blocks.counts.end() - 1, blocks.offsets.begin() + 1);
  blocks.total = blocks.offsets.back() + blocks.counts.back();
  return blocks;
}
} // namespace

template <class T>
std::vector<T> gatherToRoot(std::vector<T> const& mine, Communicator const& comm)
{
  const Blocks blocks = blocksOfRanks(mine.size(), comm);
  std::vector<T> all(comm.getRank() == 0 ? blocks.total : 0);
  MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), typeOf(T()), all.data(),
              blocks.counts.data(), blocks.offsets.data(), typeOf(T()), 0, rawCommunicator(comm));
  return all;
}

template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm)
{
  const Blocks blocks = blocksOfRanks(mine.size(), comm);
  std::vector<T> all(blocks.total);
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), typeOf(T()), all.data(),
                 blocks.counts.data(), blocks.offsets.data(), typeOf(T()), rawCommunicator(comm));
  return all;
}

template std::vector<double> gatherToRoot(std::vector<double> const&, Communicator const&);
template std::vector<GlobalOrdinal> gatherToRoot(std::vector<GlobalOrdinal> const&,
                                                 Communicator const&);
template std::vector<char> gatherToRoot(std::vector<char> const&, Communicator const&);
template std::vector<double> gatherToAll(std::vector<double> const&, Communicator const&);
template std::vector<GlobalOrdinal> gatherToAll(std::vector<GlobalOrdinal> const&,
                                                Communicator const&);
template std::vector<char> gatherToAll(std::vector<char> const&, Communicator const&);

namespace
{
// What became of the work on one rank.
struct Outcome
{
  enum Status
  {
    done,
    input_error,
    other_error
  };
  int status = done;
  std::string message;
};

Outcome outcomeOf(std::function<void()> const& work)
{
  try {
    work();
  } catch (InputError const& error) {
    return {Outcome::input_error, error.what()};
  } catch (std::exception const& error) {
    return {Outcome::other_error, error.what()};
  }
  return {};
}

// Throws the outcome of the rank `rank` on every rank.
void share(Outcome outcome, int rank, Communicator const& comm)
{
  int report[2] = {outcome.status, static_cast<int>(outcome.message.size())};
  Teuchos::broadcast(comm, rank, 2, report);
  if (report[0] == Outcome::done) {
    return;
  }
  outcome.message.resize(report[1]);
  Teuchos::broadcast(comm, rank, report[1], outcome.message.data());
  if (report[0] == Outcome::input_error) {
    throw InputError(outcome.message);
  }
  throw std::runtime_error(outcome.message);
}
} // namespace

void onRoot(Communicator const& comm, std::function<void()> const& work)
{
  share(comm.getRank() == 0 ? outcomeOf(work) : Outcome(), 0, comm);
}

void onAll(Communicator const& comm, std::function<void()> const& work)
{
  const Outcome outcome = outcomeOf(work);
  const int here = outcome.status == Outcome::done ? comm.getSize() : comm.getRank();
  int first = here;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, 1, &here, &first);
  if (first < comm.getSize()) {
    share(outcome, first, comm);
  }
}

namespace
{
double reduce(double value, Teuchos::EReductionType type, Communicator const& comm)
{
  double result = value;
  Teuchos::reduceAll(comm, type, 1, &value, &result);
  return result;
}
} // namespace

double maxOverRanks(double value, Communicator const& comm)
{
  return reduce(value, Teuchos::REDUCE_MAX, comm);
}

double minOverRanks(double value, Communicator const& comm)
{
  return reduce(value, Teuchos::REDUCE_MIN, comm);
}

double sumOverRanks(double value, Communicator const& comm)
{
  return reduce(value, Teuchos::REDUCE_SUM, comm);
}
} // namespace asperity::io::detail
