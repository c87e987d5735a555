#include "io/checkpoint/Checkpoint.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/parallel/Agreement.hpp"
#include "hdf5/File.hpp"
#include "io/checkpoint/SharedArchive.hpp"
#include "io/files/DurableFile.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace asperity::io
{
namespace
{
constexpr char const* format_name = "asperity checkpoint";
constexpr std::int64_t format_version = 1;

std::string checksumOf(std::vector<std::string> const& parameters,
                       std::vector<std::string> const& values,
                       std::vector<std::string> const& contents)
{
  return hexadecimal(Checksum().add(parameters).add(values).add(contents).value());
}

void writeHeader(h5::File& file, Fingerprint const& fingerprint)
{
  file.setAttribute("format", format_name, h5::TextLength::fixed);
  file.setAttribute("format_version", format_version);
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
                        << ". Restart it with the version of Asperity that wrote it (run.log "
                           "beside it begins with the version), or begin the run anew.");
  const std::string change = difference(readFingerprint(file), fingerprint);
  ASPERITY_REQUIRE(change.empty(), name << " belongs to another deck: " << change
                                        << " Restart it with the deck and the files that it was "
                                           "written for (parameters.xml beside it is a copy of "
                                           "the deck), or begin a new run from its state with "
                                           "--restart-from.");
}

// Calls read(); what HDF5 cannot read is damaged.
template <class Read>
auto asInputError(std::string const& name, Read const& read)
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
  return asInputError(name, [&] {
    h5::File file = h5::File::open(path);
    checkHeader(file, name, fingerprint);
    return file;
  });
}

} // namespace

void writeCheckpoint(std::filesystem::path const& path, Archive const& archive,
                     Fingerprint const& fingerprint, Communicator const& comm, NodeSets const& here)
{
  const auto temporary = detail::temporaryName(path);
  std::optional<h5::File> file; // of rank 0
  onRoot(comm, [&] {
    file = h5::File::create(temporary, h5::Layout::sealed);
    writeHeader(*file, fingerprint);
  });
  detail::writeArchive(file, archive, here, comm);
  onRoot(comm, [&] {
    file->close();
    detail::synchronise(temporary);
    detail::replaceDurably(path);
  });
}

Archive readCheckpoint(std::filesystem::path const& path, Fingerprint const& fingerprint,
                       Communicator const& comm, NodeSets const& here)
{
  const std::string name = path.string();
  onRoot(comm, [&] { openCheckpoint(path, fingerprint); });
  std::optional<h5::File> file; // each rank reads it for itself
  detail::Contents contents;
  onEveryRank(comm, [&] {
    asInputError(name, [&] {
      file = h5::File::open(path);
      contents = detail::readContents(*file);
    });
  });
  std::vector<std::string> sets;
  for (auto const& set : contents.sets) {
    sets.push_back(set.name);
  }
  const auto orders = detail::ordersOf(here, sets, comm);
  const auto together = [&](std::function<void()> const& work) {
    onEveryRank(comm, [&] { asInputError(name, work); });
  };
  return asInputError(name,
                      [&] { return detail::readArchive(*file, contents, orders, together, comm); });
}
} // namespace asperity::io
