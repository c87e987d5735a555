#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity
{
// Every id, 0 <= id < num_ids, has a place on one rank, where other ranks can ask about it: the ids
// are distributed in blocks, so that no rank has more than an equal share.
class Directory
{
public:
  // Refers to the communicator.
  Directory(GlobalOrdinal num_ids, Communicator const& communicator);

  // For each of the ids in `asked` the value of the rank that has it among its `ids`, -1 if none
  // has. values: one, >= 0, for each of `ids`, of which no two ranks have the same. Collective.
  std::vector<GlobalOrdinal> valuesAt(std::vector<GlobalOrdinal> const& asked,
                                      std::vector<GlobalOrdinal> const& ids,
                                      std::vector<GlobalOrdinal> const& values) const;

  // For each of the ids in `asked` the sum of the values of all smaller ids. Collective.
  std::vector<GlobalOrdinal> sumsBefore(std::vector<GlobalOrdinal> const& asked,
                                        std::vector<GlobalOrdinal> const& ids,
                                        std::vector<GlobalOrdinal> const& values) const;

private:
  std::vector<GlobalOrdinal> receive(std::vector<GlobalOrdinal> const& ids,
                                     std::vector<GlobalOrdinal> const& values) const;
  std::vector<GlobalOrdinal> lookUp(std::vector<GlobalOrdinal> const& asked,
                                    std::vector<GlobalOrdinal> const& here) const;
  std::vector<int> ranksOf(std::vector<GlobalOrdinal> const& ids) const;

  GlobalOrdinal block_; // number of ids of each rank
  GlobalOrdinal first_; // first id of this rank
  Communicator const& communicator_;
};
} // namespace asperity
