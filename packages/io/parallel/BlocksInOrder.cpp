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

template <class T>
void send(std::vector<T> const& block, MPI_Comm comm)
{
  const std::uint64_t size = block.size();
  MPI_Send(&size, 1, MPI_UINT64_T, 0, tag, comm);
  const Pieces pieces(size, largest_piece / sizeof(T));
  for (std::uint64_t i = 0; i < pieces.count(); ++i) {
    MPI_Ssend(&block[pieces.first(i)], pieces.size(i), mpiType(T()), 0, tag, comm);
  }
}

template <class T>
std::vector<T> receive(int rank, MPI_Comm comm)
{
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, rank, tag, comm, MPI_STATUS_IGNORE);
  std::vector<T> block(size);
  const Pieces pieces(size, largest_piece / sizeof(T));
  for (std::uint64_t i = 0; i < pieces.count(); ++i) {
    MPI_Recv(&block[pieces.first(i)], pieces.size(i), mpiType(T()), rank, tag, comm,
             MPI_STATUS_IGNORE);
  }
  return block;
}
} // namespace

template <class T>
void visitInOrder(std::vector<T> const& block, Communicator const& comm,
                  std::function<void(std::vector<T> const&)> const& use)
{
  const MPI_Comm raw = rawCommunicator(comm);
  if (comm.getRank() > 0) {
    send(block, raw);
  }
  onRoot(comm, [&] {
    std::exception_ptr failure; // the other ranks still have to send theirs
    for (int rank = 0; rank < comm.getSize(); ++rank) {
      const auto received = rank > 0 ? receive<T>(rank, raw) : std::vector<T>();
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

template void visitInOrder(std::vector<double> const&, Communicator const&,
                           std::function<void(std::vector<double> const&)> const&);
template void visitInOrder(std::vector<long long> const&, Communicator const&,
                           std::function<void(std::vector<long long> const&)> const&);

std::vector<double> joinedInOrder(OutputDomain const& curve, std::vector<double> const& block)
{
  if (!curve.isCurve()) {
    throw std::logic_error("asperity::io: nodes of a surface on one rank");
  }
  std::vector<double> all;
  visitInOrder<double>(block, *curve.comm, [&all](std::vector<double> const& next) {
    all.insert(all.end(), next.begin(), next.end());
  });
  return all;
}
} // namespace asperity::io
