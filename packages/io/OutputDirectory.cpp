#include "io/OutputDirectory.hpp"

#include "base/Errors.hpp"
#include "io/detail/Gather.hpp"

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
  "parameters.xml", "run.log", "steps.csv", "events.csv", "checkpoint.h5", "fault.h5",
  "fault.xdmf", "surface.h5", "surface.xdmf", "volume.h5", "volume.xdmf"};

// "fault_000012.h5"
bool isSegment(fs::path const& file)
{
  const std::string stem = file.stem().string();
  const std::size_t digits = stem.find_last_of('_') + 1;
  return file.extension() == ".h5" && digits > 1 && stem.size() - digits >= 6 &&
         std::all_of(stem.begin() + digits, stem.end(),
                     [](unsigned char letter) { return std::isdigit(letter); });
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
  ASPERITY_REQUIRE(is_writable, "The output directory "
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
  fs::remove(directory / "segments", ignored);
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
  if (fs::is_directory(directory / "segments")) {
    for (auto const& entry : fs::directory_iterator(directory / "segments")) {
      if (entry.is_regular_file() && isSegment(entry.path())) {
        files.push_back(entry.path());
      }
    }
  }
  return files;
}

void prepareOutputDirectory(fs::path const& directory, ExistingResult existing,
                            Communicator const& comm)
{
  detail::onRoot(comm, [&] {
    ASPERITY_REQUIRE(!directory.empty(), "The name of the output directory is empty.");
    const auto earlier = resultFiles(directory);
    ASPERITY_REQUIRE(existing != ExistingResult::refuse || earlier.empty(),
                     "The output directory " << directory.string()
                       << " holds the result of an earlier run (" << earlier.front().string()
                       << "). Replace it with --overwrite, or choose another one with --output "
                          "DIR.");
    requireWritable(directory);
    if (existing == ExistingResult::overwrite) {
      removeResult(directory);
    }
  });
}
} // namespace asperity::io
