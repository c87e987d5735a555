#include "io/files/OutputDirectory.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "io/TextFormat.hpp"
#include "io/files/DurableFile.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <string>

namespace asperity::io
{
namespace
{
namespace fs = std::filesystem;

// Of the outputs and of what every run writes, relative to its folder; '*' at the end is anything.
std::vector<std::string> namesOfFiles()
{
  std::vector<std::string> names{"parameters.xml", "run.log", "run.jsonl", "checkpoint.h5"};
  const auto add = [&names](std::vector<std::string> const& more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  for (auto const& name : OutputRegistry::instance().names()) {
    add(OutputRegistry::instance().create(name, "Output")->files());
  }
  for (auto const& name : TextFormatRegistry::instance().names()) {
    add(TextFormatRegistry::instance().create(name, "Text Format")->files());
  }
  return names;
}

// "fault_000012.h5", "fault_geometry.h5"
bool isSegment(fs::path const& file)
{
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

// "fltst_*" or "events.csv", of a file or of its temporary form.
bool hasName(fs::path const& file, std::string const& pattern)
{
  const std::string name = file.filename().string();
  if (!pattern.empty() && pattern.back() == '*') {
    return name.compare(0, pattern.size() - 1, pattern, 0, pattern.size() - 1) == 0;
  }
  return name == pattern || name == detail::temporaryName(pattern).string();
}

// Adds the regular files in a folder, if there is one, that `belongs` accepts.
void addFiles(fs::path const& folder, std::function<bool(fs::path const&)> const& belongs,
              std::vector<fs::path>& files)
{
  if (!fs::is_directory(folder)) {
    return;
  }
  for (auto const& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && belongs(entry.path())) {
      files.push_back(entry.path());
    }
  }
}

void requireWritable(fs::path const& directory)
{
  std::error_code error;
  fs::create_directories(directory, error);
  ASPERITY_REQUIRE(!error && fs::is_directory(directory),
                   "The output directory " << directory.string() << " cannot be made"
                                           << (error ? ": " + error.message() : "")
                                           << ". Choose another one with --output DIR.");
  // Permissions alone do not tell (read-only file systems, quotas, root).
  const auto probe = directory / ".asperity_write_test";
  const bool is_writable = static_cast<bool>(std::ofstream(probe) << "test\n" << std::flush);
  fs::remove(probe, error);
  ASPERITY_REQUIRE(is_writable,
                   "The output directory "
                     << directory.string()
                     << " cannot be written. Check its permissions and the space on the disk, or "
                        "choose another one with --output DIR.");
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
    addFiles((directory / name).parent_path(),
             [&](fs::path const& file) { return hasName(file, pattern); }, files);
  }
  addFiles(directory / "segments", isSegment, files);
  return files;
}

DirectoryLock prepareOutputDirectory(fs::path const& directory, ExistingResult existing,
                                     Communicator const& comm)
{
  DirectoryLock lock;
  onRoot(comm, [&] {
    ASPERITY_REQUIRE(!directory.empty(), "The name of the output directory is empty.");
    const bool must_be_new = existing == ExistingResult::refuse;
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
