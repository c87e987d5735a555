#pragma once

#include "base/Errors.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

namespace asperity::geometry
{
// A new folder beside a file that is to be made. The destructor removes it.
class TemporaryFolder
{
public:
  // InputError if it cannot be made.
  explicit TemporaryFolder(std::string const& beside) : path_(beside + ".XXXXXX")
  {
    ASPERITY_REQUIRE(::mkdtemp(path_.data()) != nullptr,
                     "'" << beside << "' cannot be written. " << std::strerror(errno)
                         << ". Does the folder exist, may you write there, and is there space?");
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(TemporaryFolder const&) = delete;
  TemporaryFolder& operator=(TemporaryFolder const&) = delete;

  std::string file(std::string const& name) const { return path_ + "/" + name; }

private:
  std::string path_;
};
} // namespace asperity::geometry
