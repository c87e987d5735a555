#include "io/checkpoint/Checkpoint.hpp"

#include "base/Errors.hpp"
#include "base/hdf5/File.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"
#include "io/checkpoint/SharedArchive.hpp"
#include "io/files/DurableFile.hpp"

#include "io/parallel/Gather.hpp"

#include <functional>
#include <optional>
#include <sstream>
#include <vector>

namespace asperity::io
{
namespace
{
constexpr char const* format_name = "asperity checkpoint";
constexpr std::int64_t format_version = 3;

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

// What the first rank reads of the file before the others, the same for all of them.
std::vector<detail::ArchiveEntry> entriesOf(std::filesystem::path const& path,
                                            Fingerprint const& fingerprint,
                                            Communicator const& comm)
{
  std::vector<detail::ArchiveEntry> entries;
  std::ostringstream lines;
  onRoot(comm, [&] {
    const h5::File file = openCheckpoint(path, fingerprint, comm.getSize());
    entries = orRefuse(path.string(), [&] { return detail::readEntries(file); });
    for (auto const& entry : entries) {
      lines << entry.kind << ' ' << entry.path << '\n';
    }
  });
  const std::string text = lines.str();
  const auto all = gatherToAll(std::vector<char>(text.begin(), text.end()), comm);
  std::istringstream received(std::string(all.begin(), all.end()));
  entries.clear();
  detail::ArchiveEntry entry;
  while (received >> entry.kind && received.get() && std::getline(received, entry.path)) {
    entries.push_back(entry);
  }
  return entries;
}
} // namespace

void writeCheckpoint(std::filesystem::path const& path, Archive const& archive,
                     Fingerprint const& fingerprint, Communicator const& comm)
{
  const detail::ArchiveLayout layout(archive, comm);
  const auto temporary = detail::temporaryName(path);
  onRoot(comm, [&] {
    h5::File file = h5::File::create(temporary);
    writeHeader(file, fingerprint, comm.getSize());
    layout.create(file, comm.getSize());
    file.close();
  });
  std::optional<h5::File> file;
  onEveryRank(comm, [&] { file = h5::File::openShared(temporary, rawCommunicator(comm)); });
  layout.write(*file, archive, comm);
  onEveryRank(comm, [&] { file->close(); });
  onEveryRank(comm, [&] { detail::synchronise(temporary); });
  onRoot(comm, [&] { detail::replaceDurably(path); });
}

Archive readCheckpoint(std::filesystem::path const& path, Fingerprint const& fingerprint,
                       Communicator const& comm)
{
  const std::string name = path.string();
  auto entries = entriesOf(path, fingerprint, comm);
  const auto together = [&](std::function<void()> const& work) {
    onEveryRank(comm, [&] {
      orRefuse(name, [&] {
        work();
        return 0;
      });
    });
  };
  std::optional<h5::File> file;
  together([&] { file = h5::File::openSharedForReading(path, rawCommunicator(comm)); });
  const h5::Part mine{hsize_t(comm.getRank()), 1};
  std::vector<std::int64_t> sizes(entries.size(), 0);
  std::int64_t checksum = 0;
  together([&] {
    const auto all_sizes = file->openDataset("sizes");
    if (all_sizes.shape() != h5::Shape{hsize_t(comm.getSize()), entries.size()} ||
        file->openDataset("checksums").shape() != h5::Shape{hsize_t(comm.getSize())}) {
      throw h5::Error("Sizes or checksums in " + file->what() + " are incomplete.");
    }
  });
  together([&] { file->openDataset("sizes").readPart(sizes.data(), mine); });
  together([&] { file->openDataset("checksums").readPart(&checksum, mine); });
  const detail::ArchiveLayout layout(std::move(entries), std::move(sizes), comm);
  Archive archive = layout.read(*file, together);
  together([&] {
    ASPERITY_REQUIRE(checksum == detail::checksumOf(archive),
                     name << " is damaged: the values of rank " << comm.getRank()
                          << " differ from what was written. Use an earlier checkpoint.");
  });
  return archive;
}
} // namespace asperity::io
