#include "io/files/OutputDirectory.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "io/Output.hpp"
#include "io/files/DurableFile.hpp"

#include <algorithm>
#include <cctype>
#include <fcntl.h>
#include <functional>
#include <string>
#include <unistd.h>

namespace asperity::io
{
namespace
{
namespace fs = std::filesystem;

// Files of the outputs and of every run, relative to its folder; '*' is any text.
std::vector<std::string> namesOfFiles()
{
  std::vector<std::string> names{"parameters.xml", "run.log", "run.jsonl", "checkpoint.h5"};
  const auto add = [&names](std::vector<std::string> const& more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  for (auto const& name : OutputRegistry::instance().names()) {
    add(OutputRegistry::instance().at(name).files());
  }
  return names;
}

// "fault_000012.h5", "fault_geometry.h5", or the temporary form of one.
bool isSegment(fs::path file)
{
  if (file == detail::temporaryName(file.parent_path() / file.stem())) {
    file.replace_extension();
  }
  const std::string stem = file.stem().string();
  const std::string geometry = "_geometry";
  if (file.extension() == ".h5" && stem.size() > geometry.size() &&
      stem.compare(stem.size() - geometry.size(), geometry.size(), geometry) == 0) {
    return true;
  }
  const std::size_t digits = stem.find_last_of('_') + 1;
  return file.extension() == ".h5" && digits > 1 && stem.size() - digits >= 6 &&
         std::all_of(stem.begin() + digits, stem.end(),
                     [](unsigned char letter) { return std::isdigit(letter); });
}

// "fltst_*", "events_*.csv" or, also in its temporary form, "events.csv".
bool hasName(fs::path const& file, std::string const& pattern)
{
  const std::string name = file.filename().string();
  const auto star = pattern.find('*');
  if (star != std::string::npos) {
    const auto ending = pattern.substr(star + 1);
    return name.size() >= star + ending.size() && name.compare(0, star, pattern, 0, star) == 0 &&
           name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  }
  return name == pattern || name == detail::temporaryName(pattern).string();
}

// Adds the regular files and the links in a folder, if there is one, that `belongs` accepts.
void addFiles(fs::path const& folder, std::function<bool(fs::path const&)> const& belongs,
              std::vector<fs::path>& files)
{
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return;
  }
  const fs::directory_iterator entries(folder, error);
  ASPERITY_REQUIRE(!error, folder.string() << " cannot be read: " << error.message()
                                           << ". Choose another directory with --output DIR.");
  for (auto const& entry : entries) {
    if ((entry.is_symlink() || entry.is_regular_file()) && belongs(entry.path())) {
      files.push_back(entry.path());
    }
  }
}

// The same below `directory`. Of a link in the place of the folder the link itself is added.
void addFilesBelow(fs::path const& directory, fs::path const& folder,
                   std::function<bool(fs::path const&)> const& belongs,
                   std::vector<fs::path>& files)
{
  std::error_code ignored;
  if (!folder.empty() && fs::is_symlink(directory / folder, ignored)) {
    files.push_back(directory / folder);
  } else {
    addFiles(directory / folder, belongs, files);
  }
}

// Permissions alone do not tell (read-only file systems, quotas, root). Opens no existing file.
bool isWritable(fs::path const& directory)
{
  constexpr int private_file = 0600;
  const auto probe = directory / (".asperity_write_test." + std::to_string(::getpid()));
  const int descriptor =
    ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, private_file);
  if (descriptor < 0) {
    return false;
  }
  const bool is_written = ::write(descriptor, "test", 4) == 4;
  ::close(descriptor);
  ::unlink(probe.c_str());
  return is_written;
}

void requireWritable(fs::path const& directory)
{
  std::error_code error;
  fs::create_directories(directory, error);
  ASPERITY_REQUIRE(!error && fs::is_directory(directory),
                   "The output directory " << directory.string() << " cannot be made"
                                           << (error ? ": " + error.message() : "")
                                           << ". Choose another one with --output DIR.");
  ASPERITY_REQUIRE(isWritable(directory),
                   "The output directory "
                     << directory.string()
                     << " cannot be written. Check its permissions and the space on the disk, or "
                        "choose another one with --output DIR.");
}

// A run would write to what links lead to, wherever that is.
void requireNoLinks(fs::path const& directory)
{
  for (auto const& file : resultFiles(directory)) {
    std::error_code ignored;
    ASPERITY_REQUIRE(!fs::is_symlink(file, ignored),
                     file.string() << " is a link where a run writes; a run follows no link below "
                                      "its output directory. Remove the link, or choose another "
                                      "directory with --output DIR.");
  }
}

void requireNoResult(fs::path const& directory)
{
  const auto earlier = resultFiles(directory);
  ASPERITY_REQUIRE(earlier.empty(),
                   "The output directory "
                     << directory.string() << " holds the result of an earlier run ("
                     << earlier.front().string()
                     << "). Replace it with --overwrite, or choose another one with --output "
                        "DIR.");
}

void removeResult(fs::path const& directory)
{
  for (auto const& file : resultFiles(directory)) {
    std::error_code error;
    fs::remove(file, error);
    ASPERITY_REQUIRE(!error, file.string() << " cannot be removed: " << error.message() << ".");
  }
  std::error_code ignored; // a folder with other files in it stays
  fs::remove(directory / "segments", ignored);
  for (auto const& name : namesOfFiles()) {
    const auto folder = fs::path(name).parent_path();
    if (!folder.empty()) {
      fs::remove(directory / folder, ignored);
    }
  }
}
} // namespace

std::vector<fs::path> resultFiles(fs::path const& directory)
{
  std::vector<fs::path> files;
  for (auto const& name : namesOfFiles()) {
    const auto pattern = fs::path(name).filename().string();
    addFilesBelow(
      directory, fs::path(name).parent_path(),
      [&](fs::path const& file) { return hasName(file, pattern); }, files);
  }
  addFilesBelow(directory, "segments", isSegment, files);
  return files;
}

DirectoryLock prepareOutputDirectory(fs::path const& directory, ExistingResult existing,
                                     Communicator const& comm)
{
  DirectoryLock lock;
  onRoot(comm, [&] {
    ASPERITY_REQUIRE(!directory.empty(), "The name of the output directory is empty.");
    const bool must_be_new = existing == ExistingResult::refuse;
    if (existing != ExistingResult::overwrite) { // which removes links
      requireNoLinks(directory);
    }
    if (must_be_new) {
      requireNoResult(directory);
    }
    requireWritable(directory);
    lock = DirectoryLock(directory);
    if (must_be_new) {
      requireNoResult(directory); // of a run that ended in between
    }
    if (existing == ExistingResult::overwrite) {
      removeResult(directory);
    }
  });
  return lock;
}
} // namespace asperity::io
