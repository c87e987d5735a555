#include "io/checkpoint/Checkpoint.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/hdf5/File.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"
#include "io/checkpoint/ArchiveBytes.hpp"
#include "io/files/DurableFile.hpp"

#include <optional>
#include <vector>

namespace asperity::io
{
namespace
{
constexpr char const* format_name = "asperity checkpoint";
constexpr std::int64_t format_version = 2;

std::int64_t checksumOf(std::vector<char> const& bytes)
{
  return static_cast<std::int64_t>(Checksum().add(bytes).value());
}

std::string groupOfRank(int rank) { return "rank_" + std::to_string(rank); }

struct ValueWriter
{
  h5::Group& group;
  std::string const& path;

  void operator()(std::int64_t value) const { group.store(path, &value, {}); }
  void operator()(double value) const { group.store(path, &value, {}); }
  void operator()(std::string const& text) const
  {
    group.store(path, reinterpret_cast<std::int8_t const*>(text.data()), {text.size()});
  }
  void operator()(std::vector<double> const& values) const
  {
    group.store(path, values.data(), {values.size()});
  }
  void operator()(std::vector<std::int64_t> const& values) const
  {
    group.store(path, values.data(), {values.size()});
  }
};

void writeRank(h5::File& file, int rank, std::vector<char> const& bytes)
{
  h5::Group group = file.createGroup(groupOfRank(rank));
  group.setAttribute("checksum", checksumOf(bytes));
  const Archive archive = detail::fromBytes(bytes);
  for (auto const& entry : archive.values()) {
    std::visit(ValueWriter{group, entry.first}, entry.second);
  }
}

void readValue(h5::Dataset const& dataset, std::string const& path, Archive& archive)
{
  const bool is_single = dataset.shape().empty();
  if (dataset.type() == h5::Type::int8) {
    archive.set(path, dataset.readBytes());
  } else if (dataset.type() == h5::Type::float64) {
    const auto values = dataset.read<double>();
    is_single ? archive.set(path, values[0]) : archive.set(path, values);
  } else {
    const auto values = dataset.read<std::int64_t>();
    is_single ? archive.set(path, values[0]) : archive.set(path, values);
  }
}

void readGroup(h5::Group const& group, std::string const& prefix, Archive& archive)
{
  for (auto const& name : group.names()) {
    if (group.isGroup(name)) {
      readGroup(group.openGroup(name), prefix + name + "/", archive);
    } else {
      readValue(group.openDataset(name), prefix + name, archive);
    }
  }
}

std::vector<char> readRank(h5::File const& file, int rank, std::string const& name)
{
  const h5::Group group = file.openGroup(groupOfRank(rank));
  Archive archive;
  readGroup(group, "", archive);
  const auto bytes = detail::toBytes(archive);
  ASPERITY_REQUIRE(group.integerAttribute("checksum") == checksumOf(bytes),
                   name << " is damaged: the values of rank " << rank
                        << " differ from what was written. Use an earlier checkpoint.");
  return bytes;
}

void writeHeader(h5::File& file, Fingerprint const& fingerprint, int num_ranks)
{
  file.setAttribute("format", format_name);
  file.setAttribute("format_version", format_version);
  file.setAttribute("num_ranks", std::int64_t(num_ranks));
  std::vector<std::string> parameters, values, contents;
  for (auto const& entry : fingerprint.entries) {
    parameters.push_back(entry.parameter);
    values.push_back(entry.value);
    contents.push_back(entry.content);
  }
  file.createTexts("fingerprint/parameters", parameters);
  file.createTexts("fingerprint/values", values);
  file.createTexts("fingerprint/contents", contents);
}

Fingerprint readFingerprint(h5::File const& file)
{
  const auto parameters = file.openDataset("fingerprint/parameters").readTexts();
  const auto values = file.openDataset("fingerprint/values").readTexts();
  const auto contents = file.openDataset("fingerprint/contents").readTexts();
  if (values.size() != parameters.size() || contents.size() != parameters.size()) {
    throw h5::Error("The fingerprint in " + file.what() + " is incomplete.");
  }
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    fingerprint.entries.push_back({parameters[i], values[i], contents[i]});
  }
  return fingerprint;
}

void checkHeader(h5::File const& file, std::string const& name, Fingerprint const& fingerprint,
                 int num_ranks)
{
  ASPERITY_REQUIRE(file.textAttribute("format") == format_name,
                   name << " is not a checkpoint of Asperity.");
  const auto version = file.integerAttribute("format_version");
  ASPERITY_REQUIRE(version == format_version,
                   name << " has format version " << version << ", but " << format_version
                        << " is read. Restart it with the version that wrote it.");
  const auto ranks = file.integerAttribute("num_ranks");
  ASPERITY_REQUIRE(ranks == num_ranks, name << " was written by " << ranks
                                            << " rank(s) and cannot be read by " << num_ranks
                                            << ". Restart with mpirun -np " << ranks << ".");
  const std::string change = difference(readFingerprint(file), fingerprint);
  ASPERITY_REQUIRE(change.empty(), name << " belongs to another deck: " << change
                                        << " Restart it with the deck and the files that it was "
                                           "written for (parameters.xml beside it is a copy of "
                                           "the deck).");
}

// Calls read(); what HDF5 cannot read is damaged.
template <class Read>
auto orRefuse(std::string const& name, Read const& read)
{
  try {
    return read();
  } catch (h5::Error const& error) {
    throw InputError(name + " is damaged or not a checkpoint of Asperity. " + error.what());
  }
}

h5::File openCheckpoint(std::filesystem::path const& path, Fingerprint const& fingerprint,
                        int num_ranks)
{
  const std::string name = path.string();
  ASPERITY_REQUIRE(std::filesystem::is_regular_file(path),
                   "There is no checkpoint " << name << ". Check the path after --restart.");
  return orRefuse(name, [&] {
    h5::File file = h5::File::open(path);
    checkHeader(file, name, fingerprint, num_ranks);
    return file;
  });
}

// The bytes of the rank `from` on the rank `to`; nothing elsewhere.
std::vector<char> moveBytes(std::vector<char> const& bytes, int from, int to,
                            Communicator const& comm)
{
  const int rank = comm.getRank();
  if (rank == from && from != to) {
    sendBytes(bytes, to, comm);
  }
  if (rank == to) {
    return from == to ? bytes : receiveBytes(from, comm);
  }
  return {};
}
} // namespace

// The first rank has the bytes of one rank at a time.
void writeCheckpoint(std::filesystem::path const& path, Archive const& archive,
                     Fingerprint const& fingerprint, Communicator const& comm)
{
  const auto mine = detail::toBytes(archive);
  std::optional<h5::File> file;
  onRoot(comm, [&] {
    file = h5::File::create(detail::temporaryName(path));
    writeHeader(*file, fingerprint, comm.getSize());
  });
  for (int rank = 0; rank < comm.getSize(); ++rank) {
    const auto bytes = moveBytes(mine, rank, 0, comm);
    onRoot(comm, [&] { writeRank(*file, rank, bytes); });
  }
  onRoot(comm, [&] {
    file->close();
    detail::replaceDurably(path);
  });
}

Archive readCheckpoint(std::filesystem::path const& path, Fingerprint const& fingerprint,
                       Communicator const& comm)
{
  std::optional<h5::File> file;
  onRoot(comm, [&] { file = openCheckpoint(path, fingerprint, comm.getSize()); });
  std::vector<char> mine;
  for (int rank = 0; rank < comm.getSize(); ++rank) {
    std::vector<char> bytes;
    onRoot(comm, [&] {
      bytes = orRefuse(path.string(), [&] { return readRank(*file, rank, path.string()); });
    });
    bytes = moveBytes(bytes, 0, rank, comm);
    if (comm.getRank() == rank) {
      mine = std::move(bytes);
    }
  }
  return detail::fromBytes(mine);
}
} // namespace asperity::io
