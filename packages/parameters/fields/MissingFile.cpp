#include "parameters/fields/MissingFile.hpp"

#include "base/NearestName.hpp"

#include <filesystem>
#include <system_error>
#include <vector>

namespace asperity
{
std::string whereNot(std::string const& file_name)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::absolute(file_name).lexically_normal().parent_path();
  fs::path known = folder;
  while (!fs::is_directory(known, ignored) && known.has_parent_path() &&
         known != known.parent_path()) {
    known = known.parent_path();
  }
  std::string text = "The folder " + folder.string();
  if (known != folder) {
    text += " does not exist; " + known.string() + " does.";
  } else {
    std::vector<std::string> names;
    for (auto const& entry : fs::directory_iterator(folder, ignored)) {
      names.push_back(entry.path().filename().string());
    }
    const auto nearest = nearestName(fs::path(file_name).filename().string(), names);
    text += " has no such file." + (nearest.empty() ? "" : " Did you mean '" + nearest + "'?");
  }
  return text + (fs::path(file_name).is_absolute()
                   ? ""
                   : " A name is relative to the deck's folder, or else to the folder in which the "
                     "program starts.");
}
} // namespace asperity
