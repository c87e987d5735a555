#include "surfaces/kinds/SurfaceKinds.hpp"

#include "surfaces/kinds/SurfaceKind.hpp"

#include "base/Text.hpp"

#include <algorithm>

namespace asperity::geometry
{
namespace
{
constexpr char const* type_name = "Type";

std::vector<SurfaceKind> const& kinds()
{
  static const std::vector<SurfaceKind> all = {surfaceFileKind(), traceKind(), contoursKind(),
                                               gridKind(), planeKind()};
  return all;
}

bool hasSource(SurfaceKind const& kind, ParameterList const& list)
{
  return std::any_of(kind.sources.begin(), kind.sources.end(),
                     [&](auto const& source) { return list.isParameter(source); });
}
} // namespace

std::vector<std::string> surfaceTypes()
{
  std::vector<std::string> names;
  for (auto const& kind : kinds()) {
    names.push_back(kind.name);
  }
  return names;
}

Declare& declareSurface(Declare& declare)
{
  declare.choice(type_name, required, surfaceTypes(),
                 "Selects how the surface is given; without this entry the one that names its "
                 "source says so: 'Surface File', 'Trace File', 'Trace', 'Contours File', 'Grid "
                 "File' or 'Top Centre'.");
  for (auto const& kind : kinds()) {
    declare.entriesWith(type_name, kind.name, kind.entries());
  }
  return declare;
}

void chooseSurfaceType(ParameterList& list, std::string const& path)
{
  if (list.isParameter(type_name)) {
    return;
  }
  std::vector<std::string> found, all;
  for (auto const& kind : kinds()) {
    all.insert(all.end(), kind.sources.begin(), kind.sources.end());
    if (hasSource(kind, list)) {
      found.push_back(kind.name);
    }
  }
  ASPERITY_REQUIRE(!found.empty(), path
                                     << " does not say where its surface comes from. Give one of "
                                     << quotedNames(all) << ".");
  ASPERITY_REQUIRE(found.size() == 1, path << " has sources of several types: "
                                           << quotedNames(found) << ". Remove all but one.");
  list.set(type_name, found.front());
}

TriangleSurface makeSurface(ParameterList const& list, std::string const& path,
                            SurfaceContext const& context)
{
  auto const& type = list.get<std::string>(type_name);
  const auto kind = std::find_if(kinds().begin(), kinds().end(),
                                 [&](auto const& each) { return each.name == type; });
  ASPERITY_ASSERT(kind != kinds().end());
  return kind->make(list, path, context);
}
} // namespace asperity::geometry
