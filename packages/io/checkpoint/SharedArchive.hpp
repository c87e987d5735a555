#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "hdf5/File.hpp"
#include "io/checkpoint/NodeOrder.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The archive of a run in one HDF5 file, which is the same on any number of ranks.
//
// /entries (num_entries) the paths of all values, /kinds (num_entries) which alternative of
// Archive::Value each is, /nodes (num_entries) the set of nodes that it belongs to, "-" for none,
// /checksums (num_entries); /sets (num_sets) the names of these sets, /set_sizes and
// /set_checksums (num_sets) of their nodes' numbers; /values/<path> the numbers or bytes: those of
// rank 0, or, at nodes, (num_nodes, any number) in the order of the nodes' numbers.
namespace asperity::io::detail
{
using NodeOrders = std::map<std::string, NodeOrder>;

// The order of each set of `here` that is among `names`. The communicator must outlive the result.
// Collective.
NodeOrders ordersOf(NodeSets const& here, std::vector<std::string> const& names,
                    Communicator const& comm);

// Writes the values to `file`, which rank 0 alone has open: values at nodes pass through it, one
// rank's block after the other. `here` has the nodes of the sets that the archive names.
// std::exception, on every rank, if ranks have other values at nodes. Collective.
void writeArchive(std::optional<h5::File>& file, Archive const& archive, NodeSets const& here,
                  Communicator const& comm);

// What writeArchive has written, without the values.
struct Contents
{
  struct Entry
  {
    std::string path;
    std::int64_t kind = 0; // index in Archive::Value
    std::string nodes;     // name of a set of nodes, or ""
    std::int64_t checksum = 0;
  };
  struct Set
  {
    std::string name;
    std::int64_t size = 0, checksum = 0; // of the nodes' numbers
  };
  std::vector<Entry> entries;
  std::vector<Set> sets;
};

// Throws h5::Error if the parts do not fit each other.
Contents readContents(h5::File const& file);

// Runs a step of the work on every rank, and throws on all of them what one of them throws.
using Together = std::function<void(std::function<void()> const&)>;

// The archive of this rank. All ranks have the file open, each for itself. Steps throw h5::Error
// for what is damaged, InputError if a set has other nodes now. Collective.
Archive readArchive(h5::File const& file, Contents const& contents, NodeOrders const& orders,
                    Together const& together, Communicator const& comm);
} // namespace asperity::io::detail
