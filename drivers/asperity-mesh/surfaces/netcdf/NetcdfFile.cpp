#include "surfaces/netcdf/NetcdfFile.hpp"

#include "surfaces/files/BinaryFile.hpp"
#include "surfaces/netcdf/NetcdfClassic.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <algorithm>
#include <array>

namespace asperity::geometry
{
std::string NetcdfVariable::text(std::string const& attribute) const
{
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? "" : found->second.text;
}

bool NetcdfFile::has(std::string const& name) const
{
  return std::any_of(variables_.begin(), variables_.end(),
                     [&](auto const& each) { return each.name == name; });
}

NetcdfVariable const& NetcdfFile::variable(std::string const& name) const
{
  std::vector<std::string> names;
  for (auto const& each : variables_) {
    if (each.name == name) {
      return each;
    }
    names.push_back(each.name);
  }
  throw InputError(where_ + " has no variable '" + name + "'." + didYouMean(name, names));
}

std::unique_ptr<NetcdfFile> openNetcdf(std::string const& file_name, std::string const& what)
{
  BinaryFile file(file_name, what);
  std::array<char, 4> magic{};
  if (file.size() >= magic.size()) {
    file.read(magic.data(), magic.size());
  }
  const std::string begin(magic.data(), magic.size());
  if (begin == "\x89HDF") {
    return openNetcdf4(file_name, what);
  }
  ASPERITY_REQUIRE(begin.substr(0, 3) == "CDF",
                   file.where() << " is no netCDF file: it begins with neither CDF nor HDF.");
  return std::make_unique<NetcdfClassic>(file_name, what);
}
} // namespace asperity::geometry
