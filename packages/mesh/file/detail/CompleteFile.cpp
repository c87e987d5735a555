#include "mesh/file/detail/CompleteFile.hpp"

#include "base/Errors.hpp"

#include <filesystem>

namespace asperity::mesh::detail
{
void writeCompletely(std::string const& file_name, std::string const& where,
                     std::function<void(std::string const&)> const& write)
{
  const std::string unfinished = file_name + ".part";
  std::string reason;
  try {
    write(unfinished);
    std::filesystem::rename(unfinished, file_name);
    return;
  } catch (OutputError const& error) {
    reason = error.what();
  } catch (std::filesystem::filesystem_error const& error) {
    reason = error.code().message() + ".";
  }
  std::error_code ignored;
  if (std::filesystem::remove(unfinished, ignored)) {
    throw OutputError(where + " cannot be written. " + reason + " Is the disk full?");
  }
  throw InputError(where + " cannot be written. " + reason +
                   " Does the folder exist, may you write there, and is there space?");
}

void requireGroupName(std::string const& boundary, std::string const& where)
{
  ASPERITY_REQUIRE(!boundary.empty() && boundary != "." && boundary.find('/') == std::string::npos,
                   where << ": '" << boundary
                         << "' cannot be the name of a boundary. A name has at least one "
                            "character, is not '.' and contains no '/'.");
}
} // namespace asperity::mesh::detail
