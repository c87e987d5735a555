#include "mesh/Crossings.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>

namespace asperity::mesh
{
namespace
{
// The pluses of the pairs without a tip, ascending, by their minus.
std::map<int, std::vector<int>> plusesOf(std::vector<SplitVertex> const& splits)
{
  std::map<int, std::vector<int>> pluses;
  for (auto const& pair : splits) {
    if (!pair.is_tip) {
      pluses[pair.minus].push_back(pair.plus);
    }
  }
  return pluses;
}

// The names that have this vertex, as in NamedCrossing; empty where a part has no facet of them.
template <template <int> class AnyMesh, int Dim>
std::string faultAt(AnyMesh<Dim> const& mesh, int plus)
{
  std::string names;
  for (auto const& name : mesh.faults) {
    auto const& facets = mesh.boundaries.at(name);
    const bool has_it = std::any_of(facets.begin(), facets.end(), [&](auto const& facet) {
      return std::find(facet.begin(), facet.end(), plus) != facet.end();
    });
    names += !has_it ? "" : names.empty() ? name : "/" + name;
  }
  return names;
}
} // namespace

std::vector<Crossing> crossingsOf(std::vector<SplitVertex> const& splits)
{
  std::vector<Crossing> crossings;
  for (auto const& [mean, plus] : plusesOf(splits)) {
    if (plus.size() == 3) {
      crossings.push_back({mean, {plus[0], plus[1]}, plus[2]});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](Crossing const& a, Crossing const& b) { return a.plus[0] < b.plus[0]; });
  return crossings;
}

template <template <int> class AnyMesh, int Dim>
void checkCrossings(AnyMesh<Dim> const& mesh, std::string const& where)
{
  for (auto const& [minus, plus] : plusesOf(mesh.splits)) {
    ASPERITY_REQUIRE(plus.size() == 1 || (Dim == 2 && plus.size() == 3),
                     where << ": vertex " << minus << " at " << text(mesh.vertices[minus])
                           << " is the minus of " << plus.size()
                           << " pairs at faults. It may be that of one pair"
                           << (Dim == 2 ? ", or of three where two faults cross." : "."));
  }
}

template <template <int> class AnyMesh, int Dim>
std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const& mesh)
{
  std::vector<NamedCrossing<Dim>> named;
  for (auto const& crossing : crossingsOf(mesh.splits)) {
    named.push_back({mesh.vertices[crossing.mean],
                     {faultAt(mesh, crossing.plus[0]), faultAt(mesh, crossing.plus[1])}});
  }
  return named;
}

#define ASPERITY_INSTANTIATE(AnyMesh, Dim)                                                         \
  template void checkCrossings(AnyMesh<Dim> const&, std::string const&);                           \
  template std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const&);
ASPERITY_INSTANTIATE(GlobalMesh, 2)
ASPERITY_INSTANTIATE(GlobalMesh, 3)
ASPERITY_INSTANTIATE(Mesh, 2)
ASPERITY_INSTANTIATE(Mesh, 3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
