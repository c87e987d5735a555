#include "io/checkpoint/SharedArchive.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "io/parallel/BlocksInOrder.hpp"

#include <algorithm>
#include <cstring>
#include <set>
#include <stdexcept>

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

constexpr char const* no_nodes = "-";

std::string pathOf(std::string const& entry) { return "values/" + entry; }

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

// A value of this kind that consists of `count` numbers.
Archive::Value valueOf(std::int64_t kind, std::size_t count)
{
  switch (kind) {
  case integer: return std::int64_t(0);
  case real: return 0.0;
  case text: return std::string(count, '\0');
  case reals: return std::vector<double>(count);
  default: return std::vector<std::int64_t>(count);
  }
}

// A sum over the numbers of a value, of which these are the ones from place `first` on: the sums of
// its blocks give that of the whole.
template <class Number>
std::uint64_t checksumOf(Number const* numbers, std::size_t size, std::uint64_t first)
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < size; ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &numbers[i], sizeof(Number));
    sum += splitMix(splitMix(first + i) ^ bits);
  }
  return sum;
}

// Integers as MPI sends them.
std::vector<double> const& sent(std::vector<double> const& values) { return values; }
std::vector<long long> sent(std::vector<std::int64_t> const& values)
{
  return {values.begin(), values.end()};
}

// How many numbers each node has, the same on all ranks.
std::size_t componentsOf(std::string const& path, std::size_t size, NodeOrder const& order,
                         Communicator const& comm)
{
  const auto total = sumOverRanks(static_cast<std::int64_t>(size), comm);
  const auto nodes = static_cast<std::int64_t>(order.blocks.total());
  const auto components = nodes > 0 ? total / nodes : 0;
  onEveryRank(comm, [&] {
    if (size != order.blocks.numOwned() * static_cast<std::size_t>(components)) {
      throw std::logic_error("asperity::io: values of '" + path +
                             "' are not the same number at each node");
    }
  });
  return static_cast<std::size_t>(components);
}

// Writes the values at nodes and returns their checksum, on rank 0 the one of all ranks.
template <class T>
std::int64_t writeAtNodes(std::optional<h5::File>& file, std::string const& path,
                          std::vector<T> const& values, NodeOrder const& order,
                          Communicator const& comm)
{
  const auto components = componentsOf(path, values.size(), order, comm);
  auto const block = order.blocks(sent(values), 1, components);
  using Number = typename std::decay_t<decltype(block)>::value_type;
  std::optional<h5::Dataset> dataset;
  hsize_t first = 0;
  onRoot(comm, [&] {
    dataset = file->create(pathOf(path), h5::typeOf<Number>(),
                           {hsize_t(order.blocks.total()) * components});
  });
  std::uint64_t sum = 0;
  visitInOrder<Number>(block, comm, [&](std::vector<Number> const& numbers) {
    if (!numbers.empty()) {
      dataset->writePart(numbers.data(), {first, numbers.size()});
    }
    sum += checksumOf(numbers.data(), numbers.size(), first);
    first += numbers.size();
  });
  return static_cast<std::int64_t>(sum);
}

// Writes the value that rank 0 has.
std::int64_t writeCommon(h5::File& file, std::string const& path, Archive::Value const& value)
{
  std::uint64_t sum = 0;
  withNumbers(value, [&](auto const* numbers, std::size_t size) {
    file.store(pathOf(path), numbers, {hsize_t(size)});
    sum = checksumOf(numbers, size, 0);
  });
  return static_cast<std::int64_t>(sum);
}

void writeContents(h5::File& file, Contents const& contents)
{
  std::vector<std::string> paths, nodes, sets;
  std::vector<std::int64_t> kinds, checksums, set_sizes, set_checksums;
  for (auto const& entry : contents.entries) {
    paths.push_back(entry.path);
    nodes.push_back(entry.nodes.empty() ? no_nodes : entry.nodes);
    kinds.push_back(entry.kind);
    checksums.push_back(entry.checksum);
  }
  for (auto const& set : contents.sets) {
    sets.push_back(set.name);
    set_sizes.push_back(set.size);
    set_checksums.push_back(set.checksum);
  }
  file.createTexts("entries", paths, h5::TextLength::fixed);
  file.createTexts("nodes", nodes, h5::TextLength::fixed);
  file.store("kinds", kinds.data(), {kinds.size()});
  file.store("checksums", checksums.data(), {checksums.size()});
  file.createTexts("sets", sets, h5::TextLength::fixed);
  file.store("set_sizes", set_sizes.data(), {set_sizes.size()});
  file.store("set_checksums", set_checksums.data(), {set_checksums.size()});
}

// All ranks have the same values at nodes.
void requireSameEntries(Archive const& archive, Communicator const& comm)
{
  Checksum checksum;
  for (auto const& [path, value] : archive.values()) {
    if (auto const& nodes = archive.nodesOf(path); !nodes.empty()) {
      checksum.add(path).add(std::uint64_t(value.index())).add(nodes);
    }
  }
  const auto mine = static_cast<std::int64_t>(checksum.value());
  if (minOverRanks(mine, comm) != maxOverRanks(mine, comm)) {
    throw std::logic_error("asperity::io: ranks save different values at nodes");
  }
}

// The names of the sets of nodes to which values of the archive belong, sorted.
std::vector<std::string> setsOf(Archive const& archive)
{
  std::set<std::string> names;
  for (auto const& [path, value] : archive.values()) {
    names.insert(archive.nodesOf(path));
  }
  names.erase("");
  return {names.begin(), names.end()};
}

// A value of the file, or this rank's block of it.
struct Block
{
  Archive::Value value;
  std::size_t components = 0;
  std::uint64_t checksum = 0; // the sum over the ranks is that of the entry
};

void refuseShape(h5::Dataset const& dataset)
{
  throw h5::Error(dataset.what() + " has another shape or type than its kind says.");
}

// order: null for what belongs to no nodes.
Block readBlock(h5::File const& file, Contents::Entry const& entry, NodeOrder const* order,
                bool is_root)
{
  const auto dataset = file.openDataset(pathOf(entry.path));
  const auto shape = dataset.shape();
  const bool is_single = entry.kind == integer || entry.kind == real;
  if (shape.size() != 1 || dataset.type() != typeOf(entry.kind) || (is_single && shape[0] != 1)) {
    refuseShape(dataset);
  }
  dataset.requireStorage();
  Block block;
  h5::Part part{0, shape[0]};
  if (order != nullptr) {
    const auto nodes = static_cast<hsize_t>(order->blocks.total());
    block.components = nodes > 0 ? shape[0] / nodes : 0;
    if (shape[0] != block.components * nodes) {
      refuseShape(dataset);
    }
    part = {hsize_t(order->blocks.first()) * block.components,
            hsize_t(order->blocks.count()) * block.components};
  }
  block.value = valueOf(entry.kind, part.count);
  withNumbers(block.value, [&](auto* numbers, std::size_t size) {
    dataset.readPart(numbers, part);
    if (order != nullptr || is_root) {
      block.checksum = checksumOf(numbers, size, part.first);
    }
  });
  return block;
}

// Puts the value into the archive, that of a block where this rank's nodes are. Collective.
void put(Archive& archive, Contents::Entry const& entry, Block const& block, NodeOrder const* order)
{
  std::visit(
    [&](auto const& value) {
      using Value = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, std::vector<double>> ||
                    std::is_same_v<Value, std::vector<std::int64_t>>) {
        if (order != nullptr) {
          auto const mine = order->blocks.back(sent(value), block.components);
          archive.setAtNodes(entry.path, Value(mine.begin(), mine.end()), entry.nodes);
          return;
        }
      }
      archive.set(entry.path, value);
    },
    block.value);
}

NodeOrder const* orderFor(Contents::Entry const& entry, NodeOrders const& orders)
{
  return entry.nodes.empty() ? nullptr : &orders.at(entry.nodes);
}
} // namespace

NodeOrders ordersOf(NodeSets const& here, std::vector<std::string> const& names,
                    Communicator const& comm)
{
  NodeOrders orders;
  for (auto const& name : names) {
    if (const auto found = here.find(name); found != here.end()) {
      orders.emplace(name, orderOf(found->second, comm));
    }
  }
  return orders;
}

void writeArchive(std::optional<h5::File>& file, Archive const& archive, NodeSets const& here,
                  Communicator const& comm)
{
  requireSameEntries(archive, comm); // or ranks would wait for each other
  const auto orders = ordersOf(here, setsOf(archive), comm);
  Contents contents;
  for (auto const& [path, value] : archive.values()) {
    contents.entries.push_back({path, std::int64_t(value.index()), archive.nodesOf(path), 0});
    auto& entry = contents.entries.back();
    if (!entry.nodes.empty()) {
      auto const& order = orders.at(entry.nodes);
      entry.checksum =
        entry.kind == reals
          ? writeAtNodes(file, path, std::get<std::vector<double>>(value), order, comm)
          : writeAtNodes(file, path, std::get<std::vector<std::int64_t>>(value), order, comm);
    }
  }
  for (auto const& [name, order] : orders) {
    contents.sets.push_back({name, std::int64_t(order.blocks.total()), order.checksum});
  }
  onRoot(comm, [&] {
    for (auto& entry : contents.entries) {
      if (entry.nodes.empty()) {
        entry.checksum = writeCommon(*file, entry.path, archive.values().at(entry.path));
      }
    }
    writeContents(*file, contents);
  });
}

Contents readContents(h5::File const& file)
{
  const auto paths = file.openDataset("entries").readTexts();
  const auto nodes = file.openDataset("nodes").readTexts();
  const auto kinds = file.openDataset("kinds").read<std::int64_t>();
  const auto checksums = file.openDataset("checksums").read<std::int64_t>();
  const auto sets = file.openDataset("sets").readTexts();
  const auto set_sizes = file.openDataset("set_sizes").read<std::int64_t>();
  const auto set_checksums = file.openDataset("set_checksums").read<std::int64_t>();
  const bool is_known = std::all_of(kinds.begin(), kinds.end(), [](std::int64_t kind) {
    return kind >= 0 && kind < std::int64_t(num_kinds);
  });
  if (kinds.size() != paths.size() || nodes.size() != paths.size() ||
      checksums.size() != paths.size() || set_sizes.size() != sets.size() ||
      set_checksums.size() != sets.size() || !is_known) {
    throw h5::Error("Entries, kinds and sets in " + file.what() + " do not fit each other.");
  }
  Contents contents;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    contents.sets.push_back({sets[s], set_sizes[s], set_checksums[s]});
  }
  for (std::size_t e = 0; e < paths.size(); ++e) {
    const bool is_list = kinds[e] == reals || kinds[e] == integers;
    const bool has_set = std::find(sets.begin(), sets.end(), nodes[e]) != sets.end();
    if (nodes[e] != no_nodes && (!is_list || !has_set)) {
      throw h5::Error(paths[e] + " in " + file.what() + " cannot belong to nodes.");
    }
    contents.entries.push_back(
      {paths[e], kinds[e], nodes[e] == no_nodes ? "" : nodes[e], checksums[e]});
  }
  return contents;
}

Archive readArchive(h5::File const& file, Contents const& contents, NodeOrders const& orders,
                    Together const& together, Communicator const& comm)
{
  for (auto const& set : contents.sets) { // the same on all ranks
    const auto order = orders.find(set.name);
    ASPERITY_REQUIRE(order != orders.end(), "The checkpoint has values at the nodes of '"
                                              << set.name
                                              << "', which this run does not have. It was written "
                                                 "by another version or for another deck.");
    ASPERITY_REQUIRE(set.size == std::int64_t(order->second.blocks.total()) &&
                       set.checksum == order->second.checksum,
                     "The checkpoint has other nodes than the mesh. It belongs to another mesh.");
  }
  std::vector<Block> blocks;
  std::vector<std::int64_t> checksums;
  together([&] {
    for (auto const& entry : contents.entries) {
      blocks.push_back(readBlock(file, entry, orderFor(entry, orders), comm.getRank() == 0));
      checksums.push_back(static_cast<std::int64_t>(blocks.back().checksum));
    }
  });
  checksums = sumOverRanks(checksums, comm);
  Archive archive;
  for (std::size_t e = 0; e < blocks.size(); ++e) {
    auto const& entry = contents.entries[e];
    if (checksums[e] != entry.checksum) {
      throw h5::Error("The values of '" + entry.path + "' differ from what was written.");
    }
    put(archive, entry, blocks[e], orderFor(entry, orders));
    blocks[e] = Block();
  }
  return archive;
}
} // namespace asperity::io::detail
