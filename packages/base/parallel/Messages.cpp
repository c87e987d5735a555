#include "base/parallel/Messages.hpp"

#include "base/Errors.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>

namespace asperity
{
namespace
{
constexpr int tag = 0x6173; // "as"
} // namespace

Pieces::Pieces(std::uint64_t total, std::size_t piece) : total_(total), piece_(piece)
{
  ASPERITY_ASSERT(piece > 0 && piece <= largest_piece);
}

int Pieces::size(std::uint64_t i) const
{
  return static_cast<int>(std::min(piece_, total_ - first(i)));
}

MPI_Comm rawCommunicator(Communicator const& communicator)
{
  auto const* mpi = dynamic_cast<Teuchos::MpiComm<int> const*>(&communicator);
  return mpi ? static_cast<MPI_Comm>(*mpi->getRawMpiComm()) : MPI_COMM_SELF;
}

void sendBytes(std::vector<char> const& bytes, int rank, Communicator const& communicator,
               std::size_t piece)
{
  const MPI_Comm comm = rawCommunicator(communicator);
  const std::uint64_t size = bytes.size();
  MPI_Send(&size, 1, MPI_UINT64_T, rank, tag, comm);
  const Pieces pieces(size, piece);
  for (std::uint64_t i = 0; i < pieces.count(); ++i) {
    MPI_Send(bytes.data() + pieces.first(i), pieces.size(i), MPI_CHAR, rank, tag, comm);
  }
}

std::vector<char> receiveBytes(int rank, Communicator const& communicator, std::size_t piece)
{
  const MPI_Comm comm = rawCommunicator(communicator);
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, rank, tag, comm, MPI_STATUS_IGNORE);
  std::vector<char> bytes(size);
  const Pieces pieces(size, piece);
  for (std::uint64_t i = 0; i < pieces.count(); ++i) {
    MPI_Recv(bytes.data() + pieces.first(i), pieces.size(i), MPI_CHAR, rank, tag, comm,
             MPI_STATUS_IGNORE);
  }
  return bytes;
}
} // namespace asperity
