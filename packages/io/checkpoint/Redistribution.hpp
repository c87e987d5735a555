#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "io/checkpoint/SharedArchive.hpp"

#include <vector>

// Converts the archives of the ranks that wrote a checkpoint to those of the present ranks.
namespace asperity::io::detail
{
// The path of a set of nodes in an archive.
inline std::string pathOfNodes(std::string const& name) { return "nodes/" + name; }

// Whether the archive has these nodes, in this order, of all sets that it has.
bool hasNodes(Archive const& archive, NodeSets const& here);

// The archive of this rank: the values of `common`, which belong to no nodes, and the values at the
// nodes of `here` from the `archives` of all present ranks, whichever ranks wrote them. entries:
// all values of all archives. Throws InputError on every rank if values do not fit their
// nodes, or other nodes are wanted. Collective.
Archive redistributed(Archive common, std::vector<Archive> const& archives,
                      std::vector<ArchiveEntry> const& entries, NodeSets const& here,
                      Communicator const& comm);
} // namespace asperity::io::detail
