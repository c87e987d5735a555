#include "FuzzTarget.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

namespace
{
std::vector<std::filesystem::path> filesIn(int num_folders, char** folders)
{
  std::vector<std::filesystem::path> files;
  for (int i = 0; i < num_folders; ++i) {
    if (std::filesystem::is_directory(folders[i])) { // there may be no finds
      for (auto const& entry : std::filesystem::directory_iterator(folders[i])) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// A crash or a time limit leaves the file's name behind.
bool isHandled(std::filesystem::path const& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string input((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::cout << path.string() << std::endl;
  try {
    const auto refusal = asperity::fuzz::checkInput(input);
    std::cout << (refusal.empty() ? "  is read\n" : "  is refused: " + refusal + '\n');
    if (refusal.empty() || path.extension() != ".h5") {
      return true;
    }
    std::cerr << path.string() << ", which our programs wrote, is refused: " << refusal
              << " If the format has changed, make_corpus.py writes the file anew.\n";
  } catch (std::exception const& error) {
    std::cerr << path.string() << " is not refused as input: " << error.what() << '\n';
  } catch (...) {
    std::cerr << path.string() << " throws something unknown\n";
  }
  return false;
}

long peakMemory() // kB
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}
} // namespace

// Arguments: folders, all files of which are inputs of the target.
int main(int argc, char** argv)
{
  constexpr long most_memory = 1 << 20; // kB
  const auto files = filesIn(argc - 1, argv + 1);
  asperity::fuzz::start(argc, argv);
  const auto failures =
    std::count_if(files.begin(), files.end(), [](auto const& file) { return !isHandled(file); });
  const bool is_small = peakMemory() < most_memory;
  if (!is_small) {
    std::cerr << "More than 1 GiB of memory was used\n";
  }
  std::cout << files.size() << " inputs, " << failures << " failures\n";
  return files.empty() || failures > 0 || !is_small ? 1 : 0;
}
