#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity::tnnmg
{
// Which of this rank's values other ranks have copies of (ghosts), and which copies this rank has
// of theirs. It is made once; afterwards only values are sent, in one message to each neighbour,
// and nothing on one rank. The caller packs the values in the order of `sent` and `received`.
class Halo
{
public:
  Halo() = default;
  // ghosts: ids that other ranks own. InputError if no rank owns one. Collective.
  Halo(Map const& owned, std::vector<GlobalOrdinal> const& ghosts);

  // The part of the halo that the flags name: for each owned number, or for each ghost, 0 or 1.
  // Collective.
  Halo withOwned(std::vector<char> const& is_taken) const;
  Halo withGhosts(std::vector<char> const& is_taken) const;

  std::vector<int> const& sent() const { return sent_; }         // local indices in `owned`
  std::vector<int> const& received() const { return received_; } // places in `ghosts`

  // Sends the values of `sent` to the copies in `received`, and back. T is char, float or double.
  template <class T>
  void share(T const* sent, T* received) const;
  template <class T>
  void gather(T const* received, T* sent) const;

private:
  struct Neighbour
  {
    int rank, begin, end; // places in sent_ or received_
  };
  Halo reduced(std::vector<char> const& keeps_sent, std::vector<char> const& keeps_received) const;

  RCP<const Communicator> communicator_;
  std::vector<int> sent_, received_;
  std::vector<Neighbour> to_, from_;
};
} // namespace asperity::tnnmg
