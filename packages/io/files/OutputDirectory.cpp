#include "io/files/OutputDirectory.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

namespace asperity::io
{
namespace
{
namespace fs = std::filesystem;

constexpr char const* files_of_a_run[] = {
  "parameters.xml", "run.log",     "steps.csv",    "events.csv", "global.csv",
  "checkpoint.h5",  "fault.h5",    "fault.xdmf",   "surface.h5", "surface.xdmf",
  "volume.h5",      "volume.xdmf", "receivers.h5", "rupture.h5"};

// Folders with files for the platforms, and how these begin.
constexpr char const* platform_folders[] = {"seas", "scec"};
constexpr char const* platform_files[] = {"fltst_",   "blkst_",     "fault",       "body",
                                          "slip.dat", "global.dat", "rupture.dat", "cplot"};

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

bool isForPlatform(fs::path const& file)
{
  const std::string name = file.filename().string();
  return std::any_of(std::begin(platform_files), std::end(platform_files),
                     [&](char const* beginning) { return name.rfind(beginning, 0) == 0; });
}

// Adds the regular files in a folder, if there is one, that `belongs` accepts.
void addFiles(fs::path const& folder, bool (*belongs)(fs::path const&),
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

void removeResult(fs::path const& directory)
{
  for (auto const& file : resultFiles(directory)) {
    std::error_code error;
    fs::remove(file, error);
    ASPERITY_REQUIRE(!error, file.string() << " cannot be removed: " << error.message() << ".");
  }
  std::error_code ignored; // a folder with other files in it stays
  for (char const* folder : {"segments", "seas", "scec"}) {
    fs::remove(directory / folder, ignored);
  }
}
} // namespace

std::vector<fs::path> resultFiles(fs::path const& directory)
{
  std::vector<fs::path> files;
  for (auto const& name : files_of_a_run) {
    for (auto const& file : {directory / name, directory / (std::string(name) + ".part")}) {
      if (fs::is_regular_file(file)) {
        files.push_back(file);
      }
    }
  }
  addFiles(directory / "segments", isSegment, files);
  for (char const* folder : platform_folders) {
    addFiles(directory / folder, isForPlatform, files);
  }
  return files;
}

void prepareOutputDirectory(fs::path const& directory, ExistingResult existing,
                            Communicator const& comm)
{
  onRoot(comm, [&] {
    ASPERITY_REQUIRE(!directory.empty(), "The name of the output directory is empty.");
    const auto earlier = resultFiles(directory);
    ASPERITY_REQUIRE(existing != ExistingResult::refuse || earlier.empty(),
                     "The output directory "
                       << directory.string() << " holds the result of an earlier run ("
                       << earlier.front().string()
                       << "). Replace it with --overwrite, or choose another one with --output "
                          "DIR.");
    requireWritable(directory);
    if (existing == ExistingResult::overwrite) {
      removeResult(directory);
    }
  });
}
} // namespace asperity::io
