#include "io/checkpoint/Redistribution.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "io/checkpoint/NodeTransfer.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

namespace asperity::io::detail
{
namespace
{
using Integers = std::vector<std::int64_t>;

Integers const& nodesOf(Archive const& archive, std::string const& name)
{
  return archive.get<Integers>(pathOfNodes(name));
}

// The lists of the archives, one after the other.
template <class T>
std::vector<T> joined(std::vector<Archive> const& archives, std::string const& path)
{
  std::vector<T> all;
  for (auto const& archive : archives) {
    if (archive.has(path)) {
      auto const& part = archive.get<std::vector<T>>(path);
      all.insert(all.end(), part.begin(), part.end());
    }
  }
  return all;
}

// How many values each node has, the same in all archives of all ranks.
template <class T>
std::size_t componentsOf(std::vector<Archive> const& archives, ArchiveEntry const& entry,
                         Communicator const& comm)
{
  const auto numNodes = [&](Archive const& archive) {
    return nodesOf(archive, entry.nodes).size();
  };
  std::int64_t components = 0;
  onEveryRank(comm, [&] {
    for (auto const& archive : archives) {
      if (archive.has(entry.path) && numNodes(archive) > 0) {
        const auto size = archive.get<std::vector<T>>(entry.path).size();
        components = std::max(components, static_cast<std::int64_t>(size / numNodes(archive)));
      }
    }
  });
  components = maxOverRanks(components, comm);
  onEveryRank(comm, [&] {
    for (auto const& archive : archives) {
      const auto size =
        archive.has(entry.path) ? archive.get<std::vector<T>>(entry.path).size() : 0;
      ASPERITY_REQUIRE(size == numNodes(archive) * static_cast<std::size_t>(components),
                       "The checkpoint has " << size << " values of '" << entry.path << "' for "
                                             << numNodes(archive)
                                             << " nodes. It was written by another version.");
    }
  });
  return static_cast<std::size_t>(components);
}

template <class T>
void transfer(std::vector<Archive> const& archives, ArchiveEntry const& entry,
              NodeTransfer const& send, Communicator const& comm, Archive& result)
{
  const auto components = componentsOf<T>(archives, entry, comm);
  result.setAtNodes(entry.path, send(joined<T>(archives, entry.path), components), entry.nodes);
}
} // namespace

bool hasNodes(Archive const& archive, NodeSets const& here)
{
  return std::all_of(here.begin(), here.end(), [&](auto const& item) {
    const auto path = pathOfNodes(item.first);
    return !archive.has(path) || archive.get<Integers>(path) == item.second;
  });
}

Archive redistributed(Archive common, std::vector<Archive> const& archives,
                      std::vector<ArchiveEntry> const& entries, NodeSets const& here,
                      Communicator const& comm)
{
  std::map<std::string, NodeTransfer> transfers;
  for (auto const& entry : entries) {
    if (entry.nodes.empty()) {
      continue;
    }
    const auto wanted = here.find(entry.nodes);
    ASPERITY_REQUIRE(wanted != here.end(),
                     "The checkpoint has values at the nodes of '"
                       << entry.nodes
                       << "', which this run does not have. Restart it on the number "
                          "of ranks that it was written by.");
    auto send = transfers.find(entry.nodes);
    if (send == transfers.end()) {
      const auto held = joined<std::int64_t>(archives, pathOfNodes(entry.nodes));
      send = transfers.try_emplace(entry.nodes, held, wanted->second, comm).first;
      common.set(pathOfNodes(entry.nodes), wanted->second);
    }
    if (isRealList(entry)) {
      transfer<double>(archives, entry, send->second, comm, common);
    } else {
      transfer<std::int64_t>(archives, entry, send->second, comm, common);
    }
  }
  return common;
}
} // namespace asperity::io::detail
