#include "assembly/GroupNames.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"

#include <algorithm>

namespace asperity::geometry
{
namespace
{
GivenNames givenNames(std::string const& option, std::vector<std::string> const& texts)
{
  GivenNames names;
  for (auto const& text : texts) {
    for (auto const& piece : split(text, ',')) {
      const auto equals = piece.find('=');
      const std::string old = trimmed(piece.substr(0, equals));
      const std::string name = equals == std::string::npos ? "" : trimmed(piece.substr(equals + 1));
      ASPERITY_REQUIRE(!old.empty() && !name.empty(),
                       "Option " << option << ": '" << piece
                                 << "' is not of the form NUMBER=NAME or OLD=NEW. Write as "
                                 << option << " 1=free,3=fault,5=far.");
      const auto number = readInteger(old);
      ASPERITY_REQUIRE(number ? names.by_number.emplace(*number, name).second
                              : names.by_name.emplace(old, name).second,
                       "Option " << option << " gives a name to " << old << " twice.");
    }
  }
  return names;
}
} // namespace

GroupNames::GroupNames(std::vector<std::string> const& boundary_names,
                       std::vector<std::string> const& region_names,
                       std::vector<std::string> const& without_names)
    : boundaries(givenNames(boundaries_option, boundary_names))
    , regions(givenNames(regions_option, region_names))
{
  for (auto const& text : without_names) {
    for (auto const& name : split(text, ',')) {
      ASPERITY_REQUIRE(!name.empty(), "Option --without " << text << ": a name is missing.");
      without.insert(name);
    }
  }
}

void requireBoundaries(std::set<std::string> const& without,
                       std::vector<std::string> const& boundaries,
                       std::vector<std::string> const& regions, std::string const& where)
{
  const auto has = [](std::vector<std::string> const& names, std::string const& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (auto const& name : without) {
    ASPERITY_REQUIRE(has(boundaries, name) || !has(regions, name),
                     "Option --without " << name << ": this is a region of " << where
                                         << ". Only boundaries and faults can be left out.");
    ASPERITY_REQUIRE(has(boundaries, name), "Option --without " << name << ": " << where
                                                                << " has no such boundary or fault."
                                                                << didYouMean(name, boundaries));
  }
}

void requireKnownName(std::string const& option, std::string const& name,
                      std::vector<std::string> const& names, std::string const& where)
{
  std::vector<std::string> known = names;
  known.erase(std::remove(known.begin(), known.end(), ""), known.end());
  ASPERITY_REQUIRE(std::find(known.begin(), known.end(), name) != known.end(),
                   "Option " << option << ": " << where << " has no group '" << name << "'"
                             << (known.empty() ? "" : ", only " + quotedNames(known)) << '.'
                             << didYouMean(name, known));
}
} // namespace asperity::geometry
