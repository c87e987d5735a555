#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "base/parallel/Messages.hpp"
#include "hdf5/File.hpp"

#include <functional>
#include <optional>

// The archives of all ranks in one HDF5 file, which all ranks write and read together.
//
// /entries (num_entries) the paths of all values, /kinds (num_entries) which alternative of
// Archive::Value each is, /nodes (num_entries) the set of nodes that it belongs to, "-" for none;
// /values/<path> the numbers or bytes of one rank after the other; /sizes (num_ranks, num_entries)
// how many of them each rank has, -1 where it has no such value; /checksums (num_ranks). So the
// number of objects in the file does not grow with the ranks.
namespace asperity::io::detail
{
struct ArchiveEntry
{
  std::string path;
  std::int64_t kind = 0; // index in Archive::Value
  std::string nodes;     // name of a set of nodes, or ""
};

// Whether values of the entry are lists of real numbers.
bool isRealList(ArchiveEntry const& entry);

// As one line of text for each, and back.
std::string linesOf(std::vector<ArchiveEntry> const& entries);
std::vector<ArchiveEntry> entriesOf(std::string const& lines);

// The most numbers that a rank writes or reads at a time: HDF5 and MPI count bytes with int.
constexpr std::size_t numbers_per_round = largest_piece / sizeof(double);

// The values of all ranks, and where those of this rank stand in the file. Sizes have 64 bits.
class ArchiveLayout
{
public:
  // The entries are those of any rank, sorted by path. Collective.
  ArchiveLayout(Archive const& archive, Communicator const& comm);

  // What a rank reads: the archive of the rank `row` that wrote the file, of which it wants some
  // entries, or nothing if there is no such rank. sizes(num_ranks, num_entries), valid as of
  // readSizes. Collective.
  using Wanted = std::function<bool(ArchiveEntry const&)>;
  ArchiveLayout(std::vector<ArchiveEntry> const& entries, std::vector<std::int64_t> const& sizes,
                std::optional<std::size_t> row, Wanted const& wanted, Communicator const& comm);

  std::vector<ArchiveEntry> const& entries() const { return entries_; }

  // Rank 0 makes the datasets; then all ranks write, each what it has. `write` is collective.
  void create(h5::File& file, int num_ranks) const;
  void write(h5::File& file, Archive const& archive, Communicator const& comm,
             std::size_t round = numbers_per_round) const;

  // Runs a step of the work on every rank, and throws on all of them what one of them throws.
  using Together = std::function<void(std::function<void()> const&)>;

  // The archive of this rank. Steps throw h5::Error for what is damaged. Collective.
  Archive read(h5::File const& file, Together const& together,
               std::size_t round = numbers_per_round) const;

private:
  std::vector<ArchiveEntry> entries_;
  std::vector<std::int64_t> sizes_, firsts_;   // of this rank, (num_entries)
  std::vector<std::int64_t> totals_, largest_; // over the ranks, (num_entries)
};

// What ArchiveLayout::create has made, read by each rank for itself. Throws h5::Error, also if it
// does not fit the values.
std::vector<ArchiveEntry> readEntries(h5::File const& file);
std::vector<std::int64_t> readSizes(h5::File const& file, std::vector<ArchiveEntry> const& entries,
                                    std::size_t num_ranks);

// Of the paths and values, in their order.
std::int64_t checksumOf(Archive const& archive);
} // namespace asperity::io::detail
