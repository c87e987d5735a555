#include "io/checkpoint/SharedArchive.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace asperity::io::detail
{
namespace
{
enum Kind : std::int64_t
{
  integer,
  real,
  text,
  reals,
  integers,
  num_kinds
};
static_assert(std::variant_size_v<Archive::Value> == num_kinds);

std::string pathOf(ArchiveEntry const& entry) { return "values/" + entry.path; }

h5::Type typeOf(std::int64_t kind)
{
  return kind == text                      ? h5::Type::int8
         : (kind == real || kind == reals) ? h5::Type::float64
                                           : h5::Type::int64;
}

// Calls use(numbers, size) with what a value consists of, or what it is to be read into.
template <class Value, class Use>
void withNumbers(Value& value, Use const& use)
{
  std::visit(
    [&](auto& each) {
      using Each = std::decay_t<decltype(each)>;
      if constexpr (std::is_arithmetic_v<Each>) {
        use(&each, std::size_t(1));
      } else if constexpr (std::is_same_v<Each, std::string>) {
        using Byte = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(each)>>,
                                        std::int8_t const, std::int8_t>;
        use(reinterpret_cast<Byte*>(each.data()), each.size());
      } else {
        use(each.data(), each.size());
      }
    },
    value);
}

Archive::Value valueOf(std::int64_t kind, std::int64_t size)
{
  const auto count = static_cast<std::size_t>(size);
  switch (kind) {
  case integer: return std::int64_t(0);
  case real: return 0.0;
  case text: return std::string(count, '\0');
  case reals: return std::vector<double>(count);
  default: return std::vector<std::int64_t>(count);
  }
}

std::vector<ArchiveEntry> entriesOfAll(Archive const& archive, Communicator const& comm)
{
  std::vector<ArchiveEntry> mine;
  for (auto const& [path, value] : archive.values()) {
    mine.push_back({path, std::int64_t(value.index()), archive.nodesOf(path)});
  }
  const std::string lines = linesOf(mine);
  const auto all = gatherToAll(std::vector<char>(lines.begin(), lines.end()), comm);
  std::map<std::string, ArchiveEntry> known;
  for (auto const& entry : entriesOf(std::string(all.begin(), all.end()))) {
    auto const& first = known.emplace(entry.path, entry).first->second;
    // Ranks may have different values of a path, but of the same kind.
    ASPERITY_ASSERT(first.kind == entry.kind && first.nodes == entry.nodes);
  }
  std::vector<ArchiveEntry> entries;
  entries.reserve(known.size());
  for (auto const& [path, entry] : known) {
    entries.push_back(entry);
  }
  return entries;
}

constexpr char const* no_nodes = "-";

// A rank's part of a value is written or read in rounds; all ranks have the same number of rounds.
class Rounds
{
public:
  Rounds(std::int64_t first, std::int64_t size, std::int64_t largest, std::size_t numbers)
      : first_(static_cast<hsize_t>(first))
      , mine_(static_cast<std::uint64_t>(size), numbers)
      , largest_(static_cast<std::uint64_t>(largest), numbers)
  {
  }

  // Calls use(offset, part): numbers of this rank from `offset` on are the part of the dataset.
  template <class Use>
  void forEach(Use const& use) const
  {
    for (std::uint64_t round = 0; round < largest_.count(); ++round) {
      const bool is_here = round < mine_.count();
      const std::uint64_t offset = is_here ? mine_.first(round) : 0;
      use(offset, is_here ? h5::Part{first_ + offset, hsize_t(mine_.size(round))} : h5::Part());
    }
  }

private:
  hsize_t first_;
  Pieces mine_, largest_;
};

void requireShape(h5::Dataset const& dataset, h5::Shape const& shape, h5::Type type)
{
  if (dataset.shape() != shape || dataset.type() != type) {
    throw h5::Error(dataset.what() + " has another shape or type than sizes and kinds say.");
  }
}

void put(Archive& archive, ArchiveEntry const& entry, Archive::Value const& value)
{
  std::visit(
    [&](auto const& each) {
      using Each = std::decay_t<decltype(each)>;
      if constexpr (std::is_same_v<Each, std::vector<double>> ||
                    std::is_same_v<Each, std::vector<std::int64_t>>) {
        if (!entry.nodes.empty()) {
          archive.setAtNodes(entry.path, each, entry.nodes);
          return;
        }
      }
      archive.set(entry.path, each);
    },
    value);
}
} // namespace

bool isRealList(ArchiveEntry const& entry) { return entry.kind == reals; }

std::string linesOf(std::vector<ArchiveEntry> const& entries)
{
  std::ostringstream lines;
  for (auto const& entry : entries) {
    lines << entry.kind << ' ' << (entry.nodes.empty() ? no_nodes : entry.nodes) << ' '
          << entry.path << '\n';
  }
  return lines.str();
}

std::vector<ArchiveEntry> entriesOf(std::string const& lines)
{
  std::istringstream stream(lines);
  std::vector<ArchiveEntry> entries;
  ArchiveEntry entry;
  while (stream >> entry.kind >> entry.nodes && stream.get() && std::getline(stream, entry.path)) {
    entry.nodes = entry.nodes == no_nodes ? "" : entry.nodes;
    entries.push_back(entry);
  }
  return entries;
}

ArchiveLayout::ArchiveLayout(Archive const& archive, Communicator const& comm)
    : entries_(entriesOfAll(archive, comm))
{
  std::vector<std::int64_t> counts;
  for (auto const& entry : entries_) {
    const auto found = archive.values().find(entry.path);
    sizes_.push_back(-1);
    if (found != archive.values().end()) {
      withNumbers(found->second, [this](auto const*, std::size_t size) {
        sizes_.back() = static_cast<std::int64_t>(size);
      });
    }
    counts.push_back(std::max(sizes_.back(), std::int64_t(0)));
  }
  firsts_.assign(counts.size(), 0);
  MPI_Exscan(counts.data(), firsts_.data(), static_cast<int>(counts.size()), MPI_INT64_T, MPI_SUM,
             rawCommunicator(comm));
  if (comm.getRank() == 0) {
    firsts_.assign(counts.size(), 0); // MPI leaves it undefined
  }
  totals_ = sumOverRanks(counts, comm);
  largest_ = maxOverRanks(counts, comm);
}

ArchiveLayout::ArchiveLayout(std::vector<ArchiveEntry> const& entries,
                             std::vector<std::int64_t> const& sizes, std::optional<std::size_t> row,
                             Wanted const& wanted, Communicator const& comm)
    : entries_(entries)
    , sizes_(entries.size(), -1)
    , firsts_(entries.size(), 0)
    , totals_(entries.size(), 0)
{
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::size_t e = i % entries.size();
    const auto size = std::max(sizes[i], std::int64_t(0));
    totals_[e] += size;
    firsts_[e] += row && i / entries.size() < *row ? size : 0;
    if (row && i / entries.size() == *row && wanted(entries[e])) {
      sizes_[e] = sizes[i];
    }
  }
  auto counts = sizes_;
  std::replace(counts.begin(), counts.end(), std::int64_t(-1), std::int64_t(0));
  largest_ = maxOverRanks(counts, comm);
}

void ArchiveLayout::create(h5::File& file, int num_ranks) const
{
  std::vector<std::string> paths;
  std::vector<std::string> nodes;
  std::vector<std::int64_t> kinds;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    paths.push_back(entries_[e].path);
    nodes.push_back(entries_[e].nodes.empty() ? no_nodes : entries_[e].nodes);
    kinds.push_back(entries_[e].kind);
    file.create(pathOf(entries_[e]), typeOf(entries_[e].kind), {hsize_t(totals_[e])});
  }
  file.createTexts("entries", paths, h5::TextLength::fixed);
  file.createTexts("nodes", nodes, h5::TextLength::fixed);
  file.store("kinds", kinds.data(), {kinds.size()});
  file.create("sizes", h5::Type::int64, {hsize_t(num_ranks), entries_.size()});
  file.create("checksums", h5::Type::int64, {hsize_t(num_ranks)});
}

void ArchiveLayout::write(h5::File& file, Archive const& archive, Communicator const& comm,
                          std::size_t round) const
{
  const h5::Part mine{hsize_t(comm.getRank()), 1};
  const std::int64_t checksum = checksumOf(archive);
  file.openDataset("checksums").writePart(&checksum, mine);
  if (!entries_.empty()) {
    file.openDataset("sizes").writePart(sizes_.data(), mine);
  }
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const auto found = archive.values().find(entries_[e].path);
    const auto nothing = valueOf(entries_[e].kind, 0);
    auto const& value = found == archive.values().end() ? nothing : found->second;
    const auto size = std::max(sizes_[e], std::int64_t(0));
    Rounds(firsts_[e], size, largest_[e], round).forEach([&](auto offset, h5::Part const& part) {
      auto dataset = file.openDataset(pathOf(entries_[e]));
      withNumbers(value, [&](auto const* numbers, std::size_t) {
        dataset.writePart(numbers + offset, part);
      });
    });
  }
}

Archive ArchiveLayout::read(h5::File const& file, Together const& together, std::size_t round) const
{
  Archive archive;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const auto kind = entries_[e].kind;
    const auto size = std::max(sizes_[e], std::int64_t(0));
    together([&] {
      requireShape(file.openDataset(pathOf(entries_[e])), {hsize_t(totals_[e])}, typeOf(kind));
    });
    auto value = valueOf(kind, size);
    Rounds(firsts_[e], size, largest_[e], round).forEach([&](auto offset, h5::Part const& part) {
      together([&] {
        const auto dataset = file.openDataset(pathOf(entries_[e]));
        withNumbers(value,
                    [&](auto* numbers, std::size_t) { dataset.readPart(numbers + offset, part); });
      });
    });
    if (sizes_[e] >= 0) {
      put(archive, entries_[e], value);
    }
  }
  return archive;
}

std::vector<ArchiveEntry> readEntries(h5::File const& file)
{
  const auto paths = file.openDataset("entries").readTexts();
  const auto nodes = file.openDataset("nodes").readTexts();
  const auto kinds = file.openDataset("kinds").read<std::int64_t>();
  const bool is_known = std::all_of(kinds.begin(), kinds.end(), [](std::int64_t kind) {
    return kind >= 0 && kind < std::int64_t(num_kinds);
  });
  if (kinds.size() != paths.size() || nodes.size() != paths.size() || !is_known) {
    throw h5::Error("Entries and kinds in " + file.what() + " do not fit each other.");
  }
  std::vector<ArchiveEntry> entries;
  for (std::size_t e = 0; e < paths.size(); ++e) {
    if ((kinds[e] != reals && kinds[e] != integers) && nodes[e] != no_nodes) {
      throw h5::Error(paths[e] + " in " + file.what() + " cannot belong to nodes.");
    }
    entries.push_back({paths[e], kinds[e], nodes[e] == no_nodes ? "" : nodes[e]});
  }
  return entries;
}

std::vector<std::int64_t> readSizes(h5::File const& file, std::vector<ArchiveEntry> const& entries,
                                    std::size_t num_ranks)
{
  const auto dataset = file.openDataset("sizes");
  requireShape(dataset, {num_ranks, entries.size()}, h5::Type::int64);
  requireShape(file.openDataset("checksums"), {num_ranks}, h5::Type::int64);
  auto sizes = dataset.read<std::int64_t>();
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const auto values = file.openDataset(pathOf(entries[e]));
    const auto shape = values.shape();
    // No size is larger than what is left: sums cannot overflow.
    auto left = shape.size() == 1 ? static_cast<std::int64_t>(shape[0]) : -1;
    const bool is_single = entries[e].kind == integer || entries[e].kind == real;
    for (std::size_t rank = 0; rank < num_ranks; ++rank) {
      const std::int64_t size = sizes[rank * entries.size() + e];
      if (size < -1 || size > left || (is_single && size != -1 && size != 1)) {
        throw h5::Error(values.what() + " has another shape or type than sizes and kinds say.");
      }
      left -= std::max(size, std::int64_t(0));
    }
  }
  return sizes;
}

std::int64_t checksumOf(Archive const& archive)
{
  Checksum checksum;
  for (auto const& [path, value] : archive.values()) {
    checksum.add(path).add(std::uint64_t(value.index()));
    withNumbers(value, [&](auto const* numbers, std::size_t size) {
      checksum.add(std::vector(numbers, numbers + size));
    });
  }
  return static_cast<std::int64_t>(checksum.value());
}
} // namespace asperity::io::detail
