#include "mesh/Boundaries.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/detail/InnerBoundaries.hpp"

#include <Teuchos_DefaultSerialComm.hpp>

#include <set>

namespace asperity::mesh
{
namespace
{
// A facet by its vertices in the whole mesh, ascending.
template <int Dim>
using FacetKey = std::array<GlobalOrdinal, Dim>;

template <template <int> class AnyMesh, int Dim>
FacetKey<Dim> keyOf(AnyMesh<Dim> const& mesh, typename Mesh<Dim>::Facet const& facet)
{
  FacetKey<Dim> key;
  std::transform(facet.begin(), facet.end(), key.begin(),
                 [&](int vertex) { return detail::globalId(mesh, vertex); });
  return detail::sorted(key);
}

// Whether this rank has all cells of the facet: it has all cells that touch its owned vertices.
template <template <int> class AnyMesh, int Dim>
bool isComplete(AnyMesh<Dim> const& mesh, typename Mesh<Dim>::Facet const& facet)
{
  return *std::min_element(facet.begin(), facet.end()) < detail::numComplete(mesh);
}

// The facets of the cells on both sides of the faults along which the mesh is split.
template <template <int> class AnyMesh, int Dim>
std::set<typename Mesh<Dim>::Facet> sidesOfFaults(AnyMesh<Dim> const& mesh)
{
  const FaultSides<Dim> sides(mesh);
  std::set<typename Mesh<Dim>::Facet> facets;
  for (auto const& fault : mesh.faults) {
    for (auto const& facet : mesh.boundaries.at(fault)) {
      facets.insert(detail::sorted(sides.plusSide(facet)));
      facets.insert(detail::sorted(sides.minusSide(facet)));
    }
  }
  return facets;
}

// The faults inside the body, along which the mesh is split or will be split.
template <int Dim>
std::vector<std::string> faultsOf(GlobalMesh<Dim> const& mesh, std::string const& where)
{
  return mesh.faults.empty() ? detail::innerBoundaries(mesh, where) : mesh.faults;
}
template <int Dim>
std::vector<std::string> faultsOf(Mesh<Dim> const& part, std::string const&)
{
  return part.faults;
}

// The facets that belong to one cell only and are not beside a fault, with outward orientation.
template <template <int> class AnyMesh, int Dim>
std::vector<typename Mesh<Dim>::Facet> outerFacets(AnyMesh<Dim> const& mesh)
{
  const auto beside_faults = sidesOfFaults(mesh);
  const detail::FacetTable<Dim> table(mesh.cells);
  std::vector<typename Mesh<Dim>::Facet> outer;
  for (auto const* entry : table.outerEntries()) {
    if (isComplete(mesh, entry->outward) && beside_faults.count(entry->key) == 0) {
      outer.push_back(entry->outward);
    }
  }
  return outer;
}

// The outer facets to which a condition gives a name.
template <template <int> class AnyMesh, int Dim>
class NamedFacets
{
public:
  using Facet = typename Mesh<Dim>::Facet;

  NamedFacets(AnyMesh<Dim> const& mesh, std::vector<NamedCondition<Dim>> const& conditions)
      : mesh_(mesh)
  {
    for (auto const& facet : outerFacets(mesh)) {
      const auto centre = centroid(corners(mesh, facet));
      for (auto const& condition : conditions) {
        if (condition.holds(centre)) {
          named_[keyOf(mesh, facet)] = {condition.name, facet};
        }
      }
    }
  }

  bool contains(Facet const& facet) const { return named_.count(keyOf(mesh_, facet)) > 0; }

  // The entry of a condition is 1 if at least one facet has its name.
  std::vector<int> areUsed(std::vector<NamedCondition<Dim>> const& conditions) const
  {
    std::set<std::string> used;
    for (auto const& [key, named] : named_) {
      used.insert(named.boundary);
    }
    std::vector<int> flags;
    flags.reserve(conditions.size());
    for (auto const& condition : conditions) {
      flags.push_back(static_cast<int>(used.count(condition.name)));
    }
    return flags;
  }

  void addTo(std::map<std::string, std::vector<Facet>>& boundaries) const
  {
    for (auto const& [key, named] : named_) {
      boundaries[named.boundary].push_back(named.outward);
    }
  }

private:
  struct Named
  {
    std::string boundary;
    Facet outward;
  };
  AnyMesh<Dim> const& mesh_;
  std::map<FacetKey<Dim>, Named> named_;
};

template <template <int> class AnyMesh, int Dim>
void assignBoundaries(AnyMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                      std::string const& where, Communicator const& communicator)
{
  const auto faults = conditions.empty() ? std::vector<std::string>() : faultsOf(mesh, where);
  for (auto const& condition : conditions) {
    ASPERITY_REQUIRE(std::find(faults.begin(), faults.end(), condition.name) == faults.end(),
                     where << " / " << condition.name
                           << ": a fault inside the body has this name. Give the boundary another "
                              "one.");
  }
  const NamedFacets<AnyMesh, Dim> named(mesh, conditions);
  const std::vector<int> are_used = maxOverRanks(named.areUsed(conditions), communicator);
  std::map<std::string, std::vector<typename Mesh<Dim>::Facet>> boundaries;
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    ASPERITY_REQUIRE(are_used[c], where
                                    << " / " << conditions[c].name
                                    << ": the boundary has no facet. Its condition holds at the "
                                    << "centre of no outer facet of the body, or the conditions of "
                                    << "later boundaries take its facets.");
    boundaries[conditions[c].name];
  }
  std::vector<int> has_facets;
  for (auto& [name, facets] : mesh.boundaries) {
    facets.erase(std::remove_if(facets.begin(), facets.end(),
                                [&](auto const& facet) { return named.contains(facet); }),
                 facets.end());
    has_facets.push_back(facets.empty() ? 0 : 1);
  }
  has_facets = maxOverRanks(has_facets, communicator);
  auto is_kept = has_facets.begin();
  for (auto& [name, facets] : mesh.boundaries) {
    if (*is_kept++) {
      boundaries[name] = std::move(facets);
    }
  }
  named.addTo(boundaries);
  mesh.boundaries = std::move(boundaries);
}
} // namespace

template <int Dim>
void overrideBoundaries(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                        std::string const& where)
{
  assignBoundaries(mesh, conditions, where, Teuchos::SerialComm<int>());
}

template <int Dim>
void overrideBoundaries(Mesh<Dim>& part, std::vector<NamedCondition<Dim>> const& conditions,
                        Communicator const& communicator, std::string const& where)
{
  assignBoundaries(part, conditions, where, communicator);
}

template <int Dim>
std::string joinBoundaries(Mesh<Dim>& part, std::vector<std::string> const& names)
{
  std::string joined;
  std::vector<typename Mesh<Dim>::Facet> all;
  for (auto const& name : names) {
    joined += (joined.empty() ? "" : " + ") + name;
    auto const& facets = part.boundaries.at(name);
    all.insert(all.end(), facets.begin(), facets.end());
  }
  part.boundaries[joined] = all;
  return joined;
}

template std::string joinBoundaries(Mesh<2>&, std::vector<std::string> const&);
template std::string joinBoundaries(Mesh<3>&, std::vector<std::string> const&);
template void overrideBoundaries(GlobalMesh<2>&, std::vector<NamedCondition<2>> const&,
                                 std::string const&);
template void overrideBoundaries(GlobalMesh<3>&, std::vector<NamedCondition<3>> const&,
                                 std::string const&);
template void overrideBoundaries(Mesh<2>&, std::vector<NamedCondition<2>> const&,
                                 Communicator const&, std::string const&);
template void overrideBoundaries(Mesh<3>&, std::vector<NamedCondition<3>> const&,
                                 Communicator const&, std::string const&);
} // namespace asperity::mesh
