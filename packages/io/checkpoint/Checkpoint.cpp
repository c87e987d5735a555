#include "io/checkpoint/Checkpoint.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"
#include "hdf5/File.hpp"
#include "io/checkpoint/Redistribution.hpp"
#include "io/checkpoint/SharedArchive.hpp"
#include "io/files/DurableFile.hpp"

#include "base/parallel/Gather.hpp"

#include <functional>
#include <optional>
#include <sstream>
#include <vector>

namespace asperity::io
{
namespace
{
constexpr char const* format_name = "asperity checkpoint";
constexpr std::int64_t format_version = 10;

std::string checksumOf(std::vector<std::string> const& parameters,
                       std::vector<std::string> const& values,
                       std::vector<std::string> const& contents)
{
  return hexadecimal(Checksum().add(parameters).add(values).add(contents).value());
}

void writeHeader(h5::File& file, Fingerprint const& fingerprint, int num_ranks)
{
  file.setAttribute("format", format_name, h5::TextLength::fixed);
  file.setAttribute("format_version", format_version);
  file.setAttribute("num_ranks", std::int64_t(num_ranks));
  std::vector<std::string> parameters, values, contents;
  for (auto const& entry : fingerprint.entries) {
    parameters.push_back(entry.parameter);
    values.push_back(entry.value);
    contents.push_back(entry.content);
  }
  file.setAttribute("fingerprint", checksumOf(parameters, values, contents), h5::TextLength::fixed);
  file.createTexts("fingerprint/parameters", parameters, h5::TextLength::fixed);
  file.createTexts("fingerprint/values", values, h5::TextLength::fixed);
  file.createTexts("fingerprint/contents", contents, h5::TextLength::fixed);
}

Fingerprint readFingerprint(h5::File const& file)
{
  const auto parameters = file.openDataset("fingerprint/parameters").readTexts();
  const auto values = file.openDataset("fingerprint/values").readTexts();
  const auto contents = file.openDataset("fingerprint/contents").readTexts();
  if (values.size() != parameters.size() || contents.size() != parameters.size() ||
      file.textAttribute("fingerprint") != checksumOf(parameters, values, contents)) {
    throw h5::Error("The fingerprint in " + file.what() + " is damaged.");
  }
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    fingerprint.entries.push_back({parameters[i], values[i], contents[i]});
  }
  return fingerprint;
}

void checkHeader(h5::File const& file, std::string const& name, Fingerprint const& fingerprint)
{
  ASPERITY_REQUIRE(file.textAttribute("format") == format_name,
                   name << " is not a checkpoint of Asperity.");
  const auto version = file.integerAttribute("format_version");
  ASPERITY_REQUIRE(version == format_version,
                   name << " has format version " << version << ", but this version "
                        << "reads " << format_version
                        << ". Restart it with the version that wrote it.");
  ASPERITY_REQUIRE(file.integerAttribute("num_ranks") > 0, name << " was written by no rank.");
  const std::string change = difference(readFingerprint(file), fingerprint);
  ASPERITY_REQUIRE(change.empty(), name << " belongs to another deck: " << change
                                        << " Restart it with the deck and the files that it was "
                                           "written for (parameters.xml beside it is a copy of "
                                           "the deck), or begin a new run from its state with "
                                           "--restart-from.");
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

h5::File openCheckpoint(std::filesystem::path const& path, Fingerprint const& fingerprint)
{
  const std::string name = path.string();
  std::error_code ignored;
  ASPERITY_REQUIRE(std::filesystem::is_regular_file(path, ignored),
                   "There is no checkpoint " << name << ". Check the path after --restart.");
  ASPERITY_REQUIRE(
    h5::File::isSealed(path),
    name << " is damaged or not a checkpoint of Asperity. It does not begin as one.");
  return orRefuse(name, [&] {
    h5::File file = h5::File::open(path);
    checkHeader(file, name, fingerprint);
    return file;
  });
}

// What the first rank reads of the file before the others, the same for all of them.
struct Contents
{
  std::int64_t num_ranks = 0;
  std::vector<detail::ArchiveEntry> entries;
};

Contents contentsOf(std::filesystem::path const& path, Fingerprint const& fingerprint,
                    Communicator const& comm)
{
  std::ostringstream text;
  onRoot(comm, [&] {
    const h5::File file = openCheckpoint(path, fingerprint);
    text << file.integerAttribute("num_ranks") << '\n'
         << detail::linesOf(orRefuse(path.string(), [&] { return detail::readEntries(file); }));
  });
  const std::string mine = text.str();
  const auto all = gatherToAll(std::vector<char>(mine.begin(), mine.end()), comm);
  const std::string received(all.begin(), all.end());
  const auto end = received.find('\n');
  return {std::stoll(received.substr(0, end)), detail::entriesOf(received.substr(end + 1))};
}

// A checkpoint that all ranks read together.
class Reading
{
public:
  Reading(std::filesystem::path const& path, Contents const& contents, Communicator const& comm)
      : name_(path.string())
      , contents_(contents)
      , comm_(comm)
  {
    together([&] { file_ = h5::File::openSharedForReading(path, rawCommunicator(comm)); });
    together([&] {
      sizes_ = detail::readSizes(*file_, contents_.entries, numRanks());
      checksums_ = file_->openDataset("checksums").read<std::int64_t>();
    });
  }

  std::size_t numRanks() const { return static_cast<std::size_t>(contents_.num_ranks); }

  // The archive of the rank that was number `row` when the file was written; an empty one if there
  // is none. Collective, as are all functions here.
  Archive archiveOf(std::optional<std::size_t> row) const
  {
    auto archive = read(row, [](auto const&) { return true; });
    together([&] {
      ASPERITY_REQUIRE(!row || checksums_[*row] == detail::checksumOf(archive),
                       name_ << " is damaged: the values of rank " << *row
                             << " differ from what was written. Use an earlier checkpoint.");
    });
    return archive;
  }

  // What all ranks had in common, or the first one alone.
  Archive common() const
  {
    return read(0, [](detail::ArchiveEntry const& entry) {
      return entry.nodes.empty() && entry.path.compare(0, 6, detail::pathOfNodes("")) != 0;
    });
  }

private:
  void together(std::function<void()> const& work) const
  {
    onEveryRank(comm_, [&] {
      orRefuse(name_, [&] {
        work();
        return 0;
      });
    });
  }

  Archive read(std::optional<std::size_t> row, detail::ArchiveLayout::Wanted const& wanted) const
  {
    const detail::ArchiveLayout layout(contents_.entries, sizes_, row, wanted, comm_);
    return layout.read(*file_, [this](auto const& work) { together(work); });
  }

  std::string name_;
  Contents const& contents_;
  Communicator const& comm_;
  std::optional<h5::File> file_;
  std::vector<std::int64_t> sizes_;     // (num_ranks, num_entries)
  std::vector<std::int64_t> checksums_; // (num_ranks)
};

// The archives that this rank reads of those of `num_ranks`: one block of them for each rank.
std::vector<Archive> archivesOfBlock(Reading const& reading, Communicator const& comm)
{
  const std::size_t num_ranks = reading.numRanks(), here = comm.getSize(), rank = comm.getRank();
  const std::size_t end = num_ranks * (rank + 1) / here;
  std::size_t row = num_ranks * rank / here;
  std::vector<Archive> archives;
  for (std::size_t round = 0; round < (num_ranks + here - 1) / here; ++round, ++row) {
    const bool has_one = row < end;
    auto archive = reading.archiveOf(has_one ? std::optional<std::size_t>(row) : std::nullopt);
    if (has_one) {
      archives.push_back(std::move(archive));
    }
  }
  return archives;
}
} // namespace

void writeCheckpoint(std::filesystem::path const& path, Archive archive,
                     Fingerprint const& fingerprint, Communicator const& comm, NodeSets const& here)
{
  for (auto const& [name, nodes] : here) {
    if (archive.belongsTo(name)) {
      archive.set(detail::pathOfNodes(name), nodes);
    }
  }
  const detail::ArchiveLayout layout(archive, comm);
  const auto temporary = detail::temporaryName(path);
  onRoot(comm, [&] {
    h5::File file = h5::File::create(temporary, h5::Layout::sealed);
    writeHeader(file, fingerprint, comm.getSize());
    layout.create(file, comm.getSize());
    file.close();
  });
  std::optional<h5::File> file;
  onEveryRank(comm, [&] { file = h5::File::openShared(temporary, rawCommunicator(comm)); });
  layout.write(*file, archive, comm);
  file->close();
  onEveryRank(comm, [&] { detail::synchronise(temporary); });
  onRoot(comm, [&] { detail::replaceDurably(path); });
}

Archive readCheckpoint(std::filesystem::path const& path, Fingerprint const& fingerprint,
                       Communicator const& comm, NodeSets const& here)
{
  const auto contents = contentsOf(path, fingerprint, comm);
  const Reading reading(path, contents, comm);
  auto archives = archivesOfBlock(reading, comm);
  const bool is_same =
    contents.num_ranks == comm.getSize() && detail::hasNodes(archives.front(), here);
  if (minOverRanks(is_same ? 1 : 0, comm) == 1) {
    return std::move(archives.front());
  }
  return detail::redistributed(reading.common(), archives, contents.entries, here, comm);
}
} // namespace asperity::io
