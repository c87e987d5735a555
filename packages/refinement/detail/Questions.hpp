#pragma once

#include "base/parallel/Messages.hpp"

namespace asperity::refinement::detail
{
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
} // namespace asperity::refinement::detail
