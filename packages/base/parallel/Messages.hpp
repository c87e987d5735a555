#pragma once

#include "base/Types.hpp"

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// What MPI is asked directly.
namespace asperity
{
// MPI_COMM_SELF of a communicator without MPI.
MPI_Comm rawCommunicator(Communicator const& communicator);

// MPI counts with int: what is larger than this, in bytes, is sent in pieces.
constexpr std::size_t largest_piece = std::size_t(1) << 30;

// Something of `total` bytes in pieces of `piece` bytes, of which the last may be smaller.
class Pieces
{
public:
  Pieces(std::uint64_t total, std::size_t piece);

  std::uint64_t count() const { return (total_ + piece_ - 1) / piece_; }
  std::uint64_t first(std::uint64_t i) const { return i * piece_; }
  int size(std::uint64_t i) const;

private:
  std::uint64_t total_;
  std::uint64_t piece_;
};

// Any number of bytes from one rank to another, which calls the other function with the same size
// of pieces.
void sendBytes(std::vector<char> const& bytes, int rank, Communicator const& communicator,
               std::size_t piece = largest_piece);
std::vector<char> receiveBytes(int rank, Communicator const& communicator,
                               std::size_t piece = largest_piece);
} // namespace asperity
