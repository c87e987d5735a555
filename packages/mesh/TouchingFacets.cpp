#include "mesh/TouchingFacets.hpp"

#include "base/parallel/Gather.hpp"
#include "mesh/NearestPoint.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/detail/FacetTable.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>

namespace asperity::mesh
{
namespace
{
// Over the length of a facet: the gap that two divisions of one curved surface leave, and rounding.
constexpr double largest_gap = 1e-2;
constexpr double largest_overlap = 1e-4;
constexpr double opposite = -0.9; // cosine between two outward normals

template <int Dim>
struct OuterFacet
{
  std::array<Point<Dim>, Dim> corners; // outward orientation
  int region;
  int boundary; // index of the name, or -1
};

// A grid for each power of two of lengths, so that a facet touches few of its cells.
template <int Dim>
class FacetSearch
{
public:
  explicit FacetSearch(std::vector<OuterFacet<Dim>> const& facets) : facets_(facets)
  {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const int level = levelOf(facets[f]);
      levels_.insert(level);
      insert(static_cast<int>(f), level);
    }
  }

  // The number of a facet on which this one lies, or -1.
  int under(int number) const
  {
    auto const& facet = facets_[number];
    const auto place = centroid(facet.corners);
    for (int level : levels_) {
      const auto found = cells_.find(key(cellOf(place, level), level));
      if (found != cells_.end()) {
        for (int other : found->second) {
          if (other != number && liesOn(facet, place, facets_[other])) {
            return other;
          }
        }
      }
    }
    return -1;
  }

private:
  using GridCell = std::array<std::int64_t, Dim>;

  static int levelOf(OuterFacet<Dim> const& facet)
  {
    return std::ilogb(longestEdge(facet.corners)) + 1;
  }

  static GridCell cellOf(Point<Dim> const& place, int level)
  {
    GridCell cell;
    for (int d = 0; d < Dim; ++d) {
      cell[d] = static_cast<std::int64_t>(std::floor(std::ldexp(place[d], -level)));
    }
    return cell;
  }

  static std::uint64_t key(GridCell const& cell, int level)
  {
    auto hash = static_cast<std::uint64_t>(level);
    for (const std::int64_t number : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash; // cells that share a key cost time and nothing else
  }

  void insert(int number, int level)
  {
    auto low = facets_[number].corners[0], high = low;
    const double margin = largest_gap * longestEdge(facets_[number].corners);
    for (auto const& corner : facets_[number].corners) {
      for (int d = 0; d < Dim; ++d) {
        low[d] = std::min(low[d], corner[d] - margin);
        high[d] = std::max(high[d], corner[d] + margin);
      }
    }
    const auto first = cellOf(low, level), last = cellOf(high, level);
    for (auto cell = first;;) {
      cells_[key(cell, level)].push_back(number);
      int d = 0;
      for (; d < Dim && ++cell[d] > last[d]; ++d) {
        cell[d] = first[d];
      }
      if (d == Dim) {
        return;
      }
    }
  }

  static bool liesOn(OuterFacet<Dim> const& facet, Point<Dim> const& place,
                     OuterFacet<Dim> const& other)
  {
    const auto normal = facetNormal(other.corners);
    if (dot<Dim>(facetNormal(facet.corners), normal) > opposite) {
      return false;
    }
    Simplex simplex{{}, Dim};
    for (auto const& corner : other.corners) {
      simplex.corners.push_back(corner.data());
    }
    const double length = std::min(longestEdge(facet.corners), longestEdge(other.corners));
    const double outside = dot<Dim>(normal, difference<Dim>(place, other.corners[0]));
    return outside > -largest_overlap * length &&
           nearestPoint(simplex, place.data()).distance < largest_gap * length;
  }

  std::vector<OuterFacet<Dim>> const& facets_;
  std::set<int> levels_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

template <int Dim>
std::optional<TouchingFacets<Dim>> search(std::vector<OuterFacet<Dim>> const& facets,
                                          std::vector<std::string> const& regions,
                                          std::vector<std::string> const& boundaries)
{
  const FacetSearch<Dim> others(facets);
  std::map<std::pair<int, int>, TouchingFacets<Dim>> found; // by regions
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const int other = others.under(static_cast<int>(f));
    if (other >= 0) {
      auto& touching = found[{facets[f].region, facets[other].region}];
      if (touching.number++ == 0) {
        touching.place = centroid(facets[f].corners);
        const int boundary = std::max(facets[f].boundary, facets[other].boundary);
        touching.boundary = boundary < 0 ? "" : boundaries[static_cast<std::size_t>(boundary)];
      }
    }
  }
  std::optional<TouchingFacets<Dim>> most;
  for (auto& [pair, touching] : found) {
    if (!most || touching.number > most->number) {
      most = touching;
      most->first = regions[static_cast<std::size_t>(pair.first)];
      most->second = regions[static_cast<std::size_t>(pair.second)];
    }
  }
  return most;
}

// The facets of one cell, and not of a side of a fault, that `counts` accepts.
template <template <int> class AnyMesh, int Dim, class Counts>
std::vector<OuterFacet<Dim>> outerFacets(AnyMesh<Dim> const& mesh, Counts const& counts)
{
  using Facet = typename GlobalMesh<Dim>::Facet;
  std::map<Facet, int> boundary_of;
  std::set<Facet> of_faults;
  const FaultSides<Dim> sides(mesh);
  int number = 0;
  for (auto const& [name, facets] : mesh.boundaries) {
    const bool is_fault = std::binary_search(mesh.faults.begin(), mesh.faults.end(), name);
    for (auto const& facet : facets) {
      if (is_fault) {
        of_faults.insert(detail::sorted(sides.plusSide(facet)));
        of_faults.insert(detail::sorted(sides.minusSide(facet)));
      } else {
        boundary_of[detail::sorted(facet)] = number;
      }
    }
    ++number;
  }
  const detail::FacetTable<Dim> table(mesh.cells);
  std::vector<OuterFacet<Dim>> outer;
  for (auto const* entry : table.outerEntries()) {
    if (counts(entry->key) && of_faults.count(entry->key) == 0) {
      const auto boundary = boundary_of.find(entry->key);
      outer.push_back({corners(mesh, entry->outward),
                       mesh.cell_regions[static_cast<std::size_t>(entry->cell)],
                       boundary == boundary_of.end() ? -1 : boundary->second});
    }
  }
  return outer;
}

template <class AnyMesh>
std::vector<std::string> namesOf(AnyMesh const& mesh)
{
  std::vector<std::string> names;
  for (auto const& boundary : mesh.boundaries) {
    names.push_back(boundary.first);
  }
  return names;
}
} // namespace

template <int Dim>
std::optional<TouchingFacets<Dim>> touchingFacets(GlobalMesh<Dim> const& mesh)
{
  const auto outer = outerFacets(mesh, [](auto const&) { return true; });
  return search(outer, mesh.region_names, namesOf(mesh));
}

template <int Dim>
std::optional<TouchingFacets<Dim>> touchingFacets(Mesh<Dim> const& part,
                                                  Communicator const& communicator)
{
  // A facet counts where its vertex with the smallest number is owned: there all its cells are.
  const auto counts = [&part](typename Mesh<Dim>::Facet const& facet) {
    return *std::min_element(facet.begin(), facet.end(), [&](int a, int b) {
      return part.global_ids[a] < part.global_ids[b];
    }) < part.num_owned;
  };
  std::vector<double> mine;
  for (auto const& facet : outerFacets(part, counts)) {
    for (auto const& corner : facet.corners) {
      mine.insert(mine.end(), corner.begin(), corner.end());
    }
    mine.push_back(facet.region);
    mine.push_back(facet.boundary);
  }
  std::vector<OuterFacet<Dim>> all;
  const auto rows = gatherToAll(mine, communicator);
  for (auto value = rows.begin(); value != rows.end();) {
    auto& facet = all.emplace_back();
    for (auto& corner : facet.corners) {
      for (double& coordinate : corner) {
        coordinate = *value++;
      }
    }
    facet.region = static_cast<int>(*value++);
    facet.boundary = static_cast<int>(*value++);
  }
  return search(all, part.region_names, namesOf(part));
}

template <int Dim>
std::string sentence(TouchingFacets<Dim> const& touching)
{
  const bool is_one = touching.number == 1;
  return std::to_string(touching.number) + (is_one ? " facet" : " facets") + " of region '" +
         touching.first + (is_one ? "' lies" : "' lie") + " on facets of " +
         (touching.first == touching.second ? "the same region"
                                            : "region '" + touching.second + "'") +
         " without sharing vertices, the first at " + text(touching.place) + " m" +
         (touching.boundary.empty() ? "" : ", on boundary '" + touching.boundary + "'") +
         ". The body is open there, and no fault: nothing acts between the two sides. Let both "
         "have the same " +
         (Dim == 2 ? "curve" : "surface") +
         "; in Gmsh, BooleanFragments or Coherence make it one, and 'Coherence Mesh' joins "
         "vertices "
         "that lie at one place.";
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::optional<TouchingFacets<Dim>> touchingFacets(GlobalMesh<Dim> const&);              \
  template std::optional<TouchingFacets<Dim>> touchingFacets(Mesh<Dim> const&,                     \
                                                             Communicator const&);                 \
  template std::string sentence(TouchingFacets<Dim> const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
