#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::refinement::detail
{
// Every global id has a place on one rank, where others can ask about it: the ids are dealt out in
// blocks, so that no rank has more than its share.
class Directory
{
public:
  Directory(GlobalOrdinal num_ids, Communicator const& communicator)
      : block_((num_ids + communicator.getSize() - 1) / communicator.getSize())
      , first_(block_ * communicator.getRank())
      , communicator_(communicator)
  {
  }

  // The rank that owns each vertex of a part, (num_local). Collective.
  template <int Dim>
  std::vector<int> owners(Mesh<Dim> const& part) const;

  // counts(num_owned), of the owned vertices, whose ids `ids` ascend: for each of these the sum of
  // the counts of all vertices with a smaller id on any rank. Collective.
  std::vector<GlobalOrdinal> sumsBefore(std::vector<GlobalOrdinal> const& ids,
                                        std::vector<GlobalOrdinal> const& counts) const;

private:
  std::vector<GlobalOrdinal> receive(std::vector<GlobalOrdinal> const& ids,
                                     std::vector<GlobalOrdinal> const& values) const;
  std::vector<GlobalOrdinal> lookUp(std::vector<GlobalOrdinal> const& ids,
                                    std::vector<GlobalOrdinal> const& here) const;
  int rankOf(GlobalOrdinal id) const { return static_cast<int>(id / block_); }

  GlobalOrdinal block_;
  GlobalOrdinal first_;
  Communicator const& communicator_;
};
} // namespace asperity::refinement::detail
