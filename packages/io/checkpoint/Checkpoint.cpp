#include "io/checkpoint/Checkpoint.hpp"

#include "base/Errors.hpp"
#include "base/hdf5/File.hpp"
#include "base/parallel/Agreement.hpp"
#include "io/checkpoint/ArchiveBytes.hpp"
#include "io/files/DurableFile.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <vector>

namespace asperity::io
{
namespace
{
constexpr char const* format_name = "asperity checkpoint";
constexpr std::int64_t format_version = 1;

std::string groupOfRank(int rank) { return "rank_" + std::to_string(rank); }

void sendBytes(std::vector<char> const& bytes, int rank, Communicator const& comm)
{
  const int size = static_cast<int>(bytes.size());
  Teuchos::send(comm, size, rank);
  Teuchos::send(comm, size, bytes.data(), rank);
}

std::vector<char> receiveBytes(int rank, Communicator const& comm)
{
  int size = 0;
  Teuchos::receive(comm, rank, &size);
  std::vector<char> bytes(size);
  Teuchos::receive(comm, rank, size, bytes.data());
  return bytes;
}

struct ValueWriter
{
  h5::Group& group;
  std::string const& path;

  void operator()(std::int64_t value) const
  {
    group.create(path, h5::Type::int64, {}).write(&value);
  }
  void operator()(double value) const { group.create(path, h5::Type::float64, {}).write(&value); }
  void operator()(std::string const& text) const
  {
    group.create(path, h5::Type::int8, {text.size()})
      .write(reinterpret_cast<std::int8_t const*>(text.data()));
  }
  void operator()(std::vector<double> const& values) const
  {
    group.create(path, h5::Type::float64, {values.size()}).write(values.data());
  }
  void operator()(std::vector<std::int64_t> const& values) const
  {
    group.create(path, h5::Type::int64, {values.size()}).write(values.data());
  }
};

void writeRank(h5::File& file, int rank, std::vector<char> const& bytes)
{
  h5::Group group = file.createGroup(groupOfRank(rank));
  group.setAttribute("checksum", detail::checksum(bytes));
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
  ASPERITY_REQUIRE(group.integerAttribute("checksum") == detail::checksum(bytes),
                   name << " is damaged: the values of rank " << rank
                        << " differ from what was written. Use an earlier checkpoint.");
  return bytes;
}

void checkHeader(h5::File const& file, std::string const& name, std::string const& fingerprint,
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
  ASPERITY_REQUIRE(file.textAttribute("fingerprint") == fingerprint,
                   name << " belongs to another deck. Restart it with the deck that it was "
                           "written for (parameters.xml beside it is a copy).");
}

// The bytes of every rank's archive, all read before any is sent, so that errors come first.
std::vector<std::vector<char>> readAllRanks(std::filesystem::path const& path,
                                            std::string const& fingerprint, int num_ranks)
{
  const std::string name = path.string();
  ASPERITY_REQUIRE(std::filesystem::is_regular_file(path),
                   "There is no checkpoint " << name << ". Check the path after --restart.");
  try {
    const h5::File file = h5::File::open(path);
    checkHeader(file, name, fingerprint, num_ranks);
    std::vector<std::vector<char>> bytes;
    for (int rank = 0; rank < num_ranks; ++rank) {
      bytes.push_back(readRank(file, rank, name));
    }
    return bytes;
  } catch (h5::Error const& error) {
    throw InputError(name + " is damaged or not a checkpoint of Asperity. " + error.what());
  }
}
} // namespace

void writeCheckpoint(std::filesystem::path const& path, Archive const& archive,
                     std::string const& fingerprint, Communicator const& comm)
{
  const auto mine = detail::toBytes(archive);
  if (comm.getRank() > 0) {
    sendBytes(mine, 0, comm);
  }
  std::vector<std::vector<char>> of_ranks;
  if (comm.getRank() == 0) {
    of_ranks.push_back(mine);
    for (int rank = 1; rank < comm.getSize(); ++rank) {
      of_ranks.push_back(receiveBytes(rank, comm));
    }
  }
  onRoot(comm, [&] {
    h5::File file = h5::File::create(detail::temporaryName(path));
    file.setAttribute("format", format_name);
    file.setAttribute("format_version", format_version);
    file.setAttribute("num_ranks", std::int64_t(comm.getSize()));
    file.setAttribute("fingerprint", fingerprint);
    for (int rank = 0; rank < comm.getSize(); ++rank) {
      writeRank(file, rank, of_ranks[rank]);
    }
    file.close();
    detail::replaceDurably(path);
  });
}

Archive readCheckpoint(std::filesystem::path const& path, std::string const& fingerprint,
                       Communicator const& comm)
{
  std::vector<std::vector<char>> of_ranks;
  onRoot(comm, [&] { of_ranks = readAllRanks(path, fingerprint, comm.getSize()); });
  if (comm.getRank() > 0) {
    return detail::fromBytes(receiveBytes(0, comm));
  }
  for (int rank = 1; rank < comm.getSize(); ++rank) {
    sendBytes(of_ranks[rank], rank, comm);
  }
  return detail::fromBytes(of_ranks[0]);
}
} // namespace asperity::io
