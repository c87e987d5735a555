#include "mesh/file/detail/CompleteFile.hpp"

#include "base/Errors.hpp"
#include "base/WriteFailure.hpp"

#include <filesystem>

namespace asperity::mesh::detail
{
void writeCompletely(std::string const& file_name, std::vector<std::string> const& boundaries,
                     std::function<void(h5::File& file)> const& write)
{
  const std::string where = "Mesh file '" + file_name + "'";
  for (auto const& name : boundaries) {
    ASPERITY_REQUIRE(!name.empty() && name != "." && name.find('/') == std::string::npos,
                     where << ": '" << name
                           << "' cannot be the name of a boundary. A name has at least one "
                              "character, is not '.' and contains no '/'.");
  }
  const std::string unfinished = file_name + ".part";
  std::string reason;
  try {
    h5::File file = h5::File::create(unfinished, h5::Layout::sealed);
    write(file);
    file.close();
    std::filesystem::rename(unfinished, file_name);
    return;
  } catch (OutputError const& error) {
    reason = error.what();
  } catch (std::filesystem::filesystem_error const& error) {
    reason = error.code().message() + ".";
  }
  std::error_code ignored;
  if (std::filesystem::remove(unfinished, ignored)) {
    throw OutputError(where + " cannot be written. " + reason + ' ' + diskFullHint());
  }
  throw InputError(where + " cannot be written. " + reason +
                   " Does the folder exist, may you write there, and is there space?");
}
} // namespace asperity::mesh::detail
