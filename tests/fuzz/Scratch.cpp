#include "Scratch.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace asperity::fuzz
{
namespace fs = std::filesystem;

Scratch::Scratch(std::string const& name)
{
  const fs::path memory = "/dev/shm";
  std::error_code ignored;
  const auto folder = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
  path_ = (folder / ("asperity_fuzz_" + std::to_string(getpid()) + "_" + name)).string();
}

Scratch::~Scratch()
{
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void Scratch::write(std::string const& bytes) const
{
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file << bytes;
  file.close();
  if (!file) { // says nothing of the input
    std::cerr << path_ << " cannot be written\n";
    std::_Exit(1);
  }
}
} // namespace asperity::fuzz
