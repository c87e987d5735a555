#include "io/parallel/BlocksInOrder.hpp"

#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"

#include <cstdint>
#include <exception>
#include <stdexcept>

namespace asperity::io
{
namespace
{
constexpr int tag = 0; // of a message; those between two ranks arrive in order

void send(std::vector<double> const& block, MPI_Comm comm)
{
  const std::uint64_t size = block.size();
  MPI_Send(&size, 1, MPI_UINT64_T, 0, tag, comm);
  const Pieces pieces(size, largest_piece / sizeof(double));
  for (std::uint64_t i = 0; i < pieces.count(); ++i) {
    MPI_Ssend(&block[pieces.first(i)], pieces.size(i), MPI_DOUBLE, 0, tag, comm);
  }
}

std::vector<double> receive(int rank, MPI_Comm comm)
{
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, rank, tag, comm, MPI_STATUS_IGNORE);
  std::vector<double> block(size);
  const Pieces pieces(size, largest_piece / sizeof(double));
  for (std::uint64_t i = 0; i < pieces.count(); ++i) {
    MPI_Recv(&block[pieces.first(i)], pieces.size(i), MPI_DOUBLE, rank, tag, comm,
             MPI_STATUS_IGNORE);
  }
  return block;
}
} // namespace

void visitInOrder(std::vector<double> const& block, Communicator const& comm,
                  std::function<void(std::vector<double> const&)> const& use)
{
  const MPI_Comm raw = rawCommunicator(comm);
  if (comm.getRank() > 0) {
    send(block, raw);
  }
  onRoot(comm, [&] {
    std::exception_ptr failure; // the other ranks still have to send theirs
    for (int rank = 0; rank < comm.getSize(); ++rank) {
      const auto received = rank > 0 ? receive(rank, raw) : std::vector<double>();
      try {
        if (!failure) {
          use(rank > 0 ? received : block);
        }
      } catch (...) {
        failure = std::current_exception();
      }
    }
    if (failure) {
      std::rethrow_exception(failure);
    }
  });
}

std::vector<double> joinedInOrder(OutputDomain const& curve, std::vector<double> const& block)
{
  if (!curve.isCurve()) {
    throw std::logic_error("asperity::io: nodes of a surface on one rank");
  }
  std::vector<double> all;
  visitInOrder(block, *curve.comm, [&all](std::vector<double> const& next) {
    all.insert(all.end(), next.begin(), next.end());
  });
  return all;
}
} // namespace asperity::io
