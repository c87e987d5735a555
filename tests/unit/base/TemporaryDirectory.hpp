#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace asperity::test
{
// A directory of this process alone, which is removed with its files.
class TemporaryDirectory
{
public:
  TemporaryDirectory()
  {
    static int count = 0;
    const std::string name =
      "asperity_" + std::to_string(::getpid()) + "_" + std::to_string(count++);
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(TemporaryDirectory const&) = delete;
  TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;

  std::string file(std::string const& name) const { return (path_ / name).string(); }

  std::string write(std::string const& name, std::string const& content) const
  {
    std::ofstream(file(name)) << content;
    return file(name);
  }

private:
  std::filesystem::path path_;
};
} // namespace asperity::test
