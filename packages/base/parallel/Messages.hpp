#pragma once

#include "base/Types.hpp"

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// Functions that call MPI directly.
namespace asperity
{
// MPI's own communicator; MPI_COMM_SELF if the communicator has none.
MPI_Comm rawCommunicator(Communicator const& communicator);

// MPI's name for the type of a number.
inline MPI_Datatype mpiType(double) { return MPI_DOUBLE; }
inline MPI_Datatype mpiType(float) { return MPI_FLOAT; }
inline MPI_Datatype mpiType(long long) { return MPI_LONG_LONG; }
inline MPI_Datatype mpiType(int) { return MPI_INT; }
inline MPI_Datatype mpiType(char) { return MPI_CHAR; }

// MPI counts with int: messages of more bytes than this are sent in pieces.
constexpr std::size_t largest_piece = std::size_t(1) << 30;

// `total` bytes or numbers in pieces of `piece` of them, of which the last may be smaller.
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

// Sends every item to a rank: items (num_items, item_size), destinations (num_items). Returns the
// items sent to this rank, (any number, item_size): those of rank 0 first, and those of each rank
// in the order in which it has them. T is double, int or long long. InputError, on every rank, if
// one of them sends or receives 2^31 numbers or more, which MPI cannot count. Collective.
template <class T>
std::vector<T> sendItems(std::vector<T> const& items, std::size_t item_size,
                         std::vector<int> const& destinations, Communicator const& communicator);

using Rows = std::vector<GlobalOrdinal>; // (num_rows, width), one row after the other

// Asks other ranks: questions (num_questions, width), each to the rank in `destinations`, which may
// be this one. answer(question, reply) appends any number of rows of answer_width numbers to
// `reply`. Returns the rows that came back, (any number, 1 + answer_width): in front of each the
// number of its question, 0 <= number < num_questions. Collective.
template <class Answer>
Rows ask(Rows const& questions, std::size_t width, std::vector<int> const& destinations,
         std::size_t answer_width, Answer answer, Communicator const& communicator)
{
  Rows sent;
  for (std::size_t q = 0; q < destinations.size(); ++q) {
    sent.push_back(communicator.getRank());
    sent.push_back(static_cast<GlobalOrdinal>(q));
    sent.insert(sent.end(), questions.begin() + q * width, questions.begin() + (q + 1) * width);
  }
  const Rows received = sendItems(sent, width + 2, destinations, communicator);
  Rows replies, reply;
  std::vector<int> askers;
  for (std::size_t i = 0; i < received.size(); i += width + 2) {
    reply.clear();
    answer(&received[i + 2], reply);
    for (std::size_t row = 0; row < reply.size(); row += answer_width) {
      replies.push_back(received[i + 1]);
      replies.insert(replies.end(), reply.begin() + row, reply.begin() + row + answer_width);
      askers.push_back(static_cast<int>(received[i]));
    }
  }
  return sendItems(replies, answer_width + 1, askers, communicator);
}

// The offsets of blocks of these sizes that stand one after the other, and the end of the last one:
// (num_blocks + 1). InputError, which begins with `what`, if the end is too large for an int. If
// the ranks have the same counts, all of them throw.
std::vector<int> blockOffsets(std::vector<std::int64_t> const& counts, char const* what);
} // namespace asperity
