#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"

namespace asperity::geometry
{
std::vector<std::string> ReadOptions::valuesOf(std::string const& option) const
{
  const auto found = own.find(option);
  return found == own.end() ? std::vector<std::string>() : found->second;
}

std::string ReadOptions::valueOf(std::string const& option) const
{
  const auto values = valuesOf(option);
  return values.empty() ? "" : values.front();
}

FoundFormat formatOf(std::string const& file_name)
{
  const auto found = findFormat<MeshFormat>(file_name);
  std::string endings;
  for (auto const& ending : endingsOf<MeshFormat>()) {
    endings += (endings.empty() ? "" : ", ") + ending;
  }
  ASPERITY_REQUIRE(found.format != nullptr,
                   "'" << file_name << "' is in no format that can be converted, by its name. "
                       << "Names end with one of " << endings
                       << ". The program meshio (Debian: meshio-tools) makes such files of others: "
                          "meshio convert IN OUT.vtu. A format of your own comes with --plugin. "
                          "Surfaces of faults and ground are for asperity-mesh build.");
  return found;
}
} // namespace asperity::geometry
