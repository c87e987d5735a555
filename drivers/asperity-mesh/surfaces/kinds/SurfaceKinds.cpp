#include "surfaces/kinds/SurfaceKinds.hpp"

#include "surfaces/kinds/SurfaceKind.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>

namespace asperity::geometry
{
namespace
{
constexpr char const* type_name = "Type";

bool hasSource(SurfaceKind const& kind, ParameterList const& list)
{
  const auto sources = kind.sources();
  return std::any_of(sources.begin(), sources.end(),
                     [&](auto const& source) { return list.isParameter(source); });
}

// The entries of all kinds that say where a surface comes from.
std::vector<std::string> allSources()
{
  auto const& kinds = SurfaceKindRegistry::instance();
  std::vector<std::string> all;
  for (auto const& name : kinds.names()) {
    auto const sources = kinds.at(name).sources();
    all.insert(all.end(), sources.begin(), sources.end());
  }
  return all;
}
} // namespace

Declare& declareSurface(Declare& declare)
{
  auto const& kinds = SurfaceKindRegistry::instance();
  declare.choice(type_name, required, kinds.names(),
                 "Selects how the surface is given; without this entry the one that names its "
                 "source selects it: " +
                   quotedAlternatives(allSources()) + ".");
  for (auto const& name : kinds.names()) {
    declare.entriesWith(type_name, name, kinds.at(name).entries());
  }
  return declare;
}

void chooseSurfaceType(ParameterList& list, std::string const& path)
{
  if (list.isParameter(type_name)) {
    return;
  }
  auto const& kinds = SurfaceKindRegistry::instance();
  std::vector<std::string> found;
  for (auto const& name : kinds.names()) {
    if (hasSource(kinds.at(name), list)) {
      found.push_back(name);
    }
  }
  ASPERITY_REQUIRE(!found.empty(), path
                                     << " does not say where its surface comes from. Give one of "
                                     << quotedNames(allSources()) << ".");
  ASPERITY_REQUIRE(found.size() == 1, path << " has sources of several types: "
                                           << quotedNames(found) << ". Remove all but one.");
  list.set(type_name, found.front());
}

TriangleSurface makeSurface(ParameterList const& list, std::string const& path,
                            SurfaceContext const& context)
{
  return SurfaceKindRegistry::instance()
    .at(list.get<std::string>(type_name))
    .make(list, path, context);
}

std::string fileEntryFor(std::string const& file_name, std::vector<std::string> const& entries)
{
  auto const& kinds = SurfaceKindRegistry::instance();
  std::string best;
  std::ptrdiff_t most = -1;
  for (auto const& name : kinds.names()) {
    auto const& kind = kinds.at(name);
    const auto fit = kind.fit(file_name);
    if (fit == FileFit::certain) {
      return kind.fileEntry();
    }
    const auto own = kind.entries();
    const auto number =
      std::count_if(entries.begin(), entries.end(),
                    [&](std::string const& entry) { return own->isParameter(entry); });
    if (fit == FileFit::possible && number > most) {
      best = kind.fileEntry();
      most = number;
    }
  }
  return best;
}
} // namespace asperity::geometry
