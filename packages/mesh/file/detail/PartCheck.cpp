#include "mesh/file/detail/PartCheck.hpp"

#include "base/Errors.hpp"
#include "mesh/Joints.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/detail/Conformity.hpp"
#include "mesh/detail/SplitCheck.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace asperity::mesh::detail
{
namespace
{
template <class Number>
bool isInRange(Number number, long long size)
{
  return number >= 0 && number < size;
}

template <std::size_t N>
bool areInRange(std::vector<std::array<int, N>> const& simplices, std::size_t size)
{
  return std::all_of(simplices.begin(), simplices.end(), [&](auto const& simplex) {
    return std::all_of(simplex.begin(), simplex.end(),
                       [&](int vertex) { return isInRange(vertex, static_cast<long long>(size)); });
  });
}

template <int Dim>
void checkVertices(Mesh<Dim> const& part, std::string const& where)
{
  auto const& ids = part.global_ids;
  ASPERITY_REQUIRE(ids.size() == part.vertices.size() && part.num_owned > 0 &&
                     static_cast<std::size_t>(part.num_owned) <= ids.size(),
                   where << " has " << part.vertices.size() << " vertices, " << ids.size()
                         << " global ids and " << part.num_owned
                         << " owned vertices. Each vertex must have a global id, and at least one "
                            "must be owned.");
  const auto is_good = [&](auto first, auto last) {
    return std::adjacent_find(first, last, std::greater_equal<>()) == last &&
           (first == last || (isInRange(*first, part.num_global_vertices) &&
                              isInRange(*(last - 1), part.num_global_vertices)));
  };
  const auto first_ghost = ids.begin() + part.num_owned;
  ASPERITY_REQUIRE(is_good(ids.begin(), first_ghost) && is_good(first_ghost, ids.end()),
                   where << " has global ids that do not ascend, or are outside [0, "
                         << part.num_global_vertices << ").");
  for (std::size_t v = 0; v < part.vertices.size(); ++v) {
    for (double coordinate : part.vertices[v]) {
      ASPERITY_REQUIRE(std::isfinite(coordinate),
                       where << ": vertex " << ids[v] << " has no finite coordinates.");
    }
  }
}

template <int Dim>
void checkCells(Mesh<Dim> const& part, std::string const& where)
{
  ASPERITY_REQUIRE(areInRange(part.cells, part.vertices.size()),
                   where << " has a cell with a vertex outside [0, " << part.vertices.size()
                         << ").");
  ASPERITY_REQUIRE(part.cell_regions.size() == part.cells.size(),
                   where << " has " << part.cells.size() << " cells, but regions for "
                         << part.cell_regions.size() << '.');
  const auto num_regions = static_cast<long long>(part.region_names.size());
  for (std::size_t c = 0; c < part.cells.size(); ++c) {
    ASPERITY_REQUIRE(isInRange(part.cell_regions[c], num_regions),
                     where << ": cell " << c << " has region " << part.cell_regions[c]
                           << ", outside [0, " << num_regions << ").");
    ASPERITY_REQUIRE(signedMeasure(corners(part, part.cells[c])) > 0.0,
                     where << ": cell " << c << " with its first vertex "
                           << part.global_ids[part.cells[c][0]] << " is inverted or degenerate.");
  }
}

template <int Dim>
void checkPairs(Mesh<Dim> const& part, std::string const& where)
{
  checkNumbersOfPairs(part.splits, part.vertices.size(), where);
  for (auto const& [plus, minus, is_tip, is_joint] : part.splits) {
    ASPERITY_REQUIRE(part.vertices[plus] == part.vertices[minus] &&
                       (plus < part.num_owned) == (minus < part.num_owned),
                     where << ": vertices " << part.global_ids[plus] << " and "
                           << part.global_ids[minus]
                           << ", a pair at a fault, are not at one place, or have two owners.");
  }
  checkCrossings(part, where);
  checkJoints(part, where);
}

template <int Dim>
void checkFaults(Mesh<Dim> const& part, std::string const& where)
{
  const FaultPairs pairs(part.splits);
  for (auto const& fault : part.faults) {
    for (auto const& facet : part.boundaries.at(fault)) {
      for (int vertex : facet) {
        ASPERITY_REQUIRE(pairs.find(vertex), where << ": a facet of fault '" << fault
                                                   << "' has vertex " << part.global_ids[vertex]
                                                   << ", which is the plus of no pair.");
      }
    }
  }
}
} // namespace

template <int Dim>
void checkPart(Mesh<Dim> const& part, std::string const& where)
{
  checkVertices(part, where);
  checkCells(part, where);
  for (auto const& [name, facets] : part.boundaries) {
    ASPERITY_REQUIRE(areInRange(facets, part.vertices.size()),
                     where << " has a facet of boundary '" << name << "' with a vertex outside [0, "
                           << part.vertices.size() << ").");
  }
  checkPairs(part, where);
  checkFaults(part, where);
  requireConforming(part, FacetTable<Dim>(part.cells), where);
}

template void checkPart(Mesh<2> const&, std::string const&);
template void checkPart(Mesh<3> const&, std::string const&);
} // namespace asperity::mesh::detail
