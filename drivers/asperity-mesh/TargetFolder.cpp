#include "TargetFolder.hpp"

#include "base/Errors.hpp"
#include "base/WriteFailure.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>

namespace asperity::geometry
{
void requireFolder(std::string const& file_name)
{
  const auto folder = std::filesystem::path(file_name).parent_path();
  const int error = errorOfOpening(folder.empty() ? "." : folder, O_TMPFILE);
  ASPERITY_REQUIRE(error == 0 || error == EOPNOTSUPP, // not every file system has unnamed files
                   "'" << file_name
                       << "' cannot be written. The system says: " << std::strerror(error)
                       << ". Does the folder exist, and may you write there?");
}
} // namespace asperity::geometry
