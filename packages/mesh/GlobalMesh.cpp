#include "mesh/GlobalMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/Conformity.hpp"
#include "mesh/detail/InnerBoundaries.hpp"
#include "mesh/detail/SplitCheck.hpp"

#include <set>

namespace asperity::mesh
{
namespace
{
template <std::size_t N>
std::string numbers(std::array<int, N> const& simplex)
{
  std::string list;
  for (int vertex : simplex) {
    list += (list.empty() ? "" : ", ") + std::to_string(vertex);
  }
  return list;
}

// The order matters: each check relies on those before it.
template <int Dim>
class Check
{
public:
  Check(GlobalMesh<Dim> const& mesh, std::string const& where) : mesh_(mesh), where_(where) {}

  void run() const
  {
    checkVertices();
    checkPeriod();
    checkNumbers();
    checkRegions();
    checkCells();
    checkVerticesAreUsed();
    checkFacets();
  }

private:
  void checkVertices() const
  {
    ASPERITY_REQUIRE(!mesh_.cells.empty(), where_ << ": the mesh has no cells.");
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      for (double x : mesh_.vertices[v]) {
        ASPERITY_REQUIRE(std::isfinite(x), where_ << ": vertex " << v << " at "
                                                  << text(mesh_.vertices[v]) << " is not finite.");
      }
    }
  }

  void checkPeriod() const
  {
    for (int d = 0; d < Dim; ++d) {
      const double period = mesh_.period[d];
      ASPERITY_REQUIRE(period >= 0.0 && std::isfinite(period),
                       where_ << ": the period along "
                              << "xyz"[d] << ", " << period << " m, is outside [0, inf).");
    }
  }

  template <std::size_t N>
  void checkRange(std::array<int, N> const& simplex, std::string const& what) const
  {
    const auto num_vertices = static_cast<int>(mesh_.vertices.size());
    for (int vertex : simplex) {
      ASPERITY_REQUIRE(vertex >= 0 && vertex < num_vertices,
                       where_ << ": " << what << " has vertex " << vertex << ", outside [0, "
                              << num_vertices << "). Vertices are numbered from 0.");
    }
  }

  void checkNumbers() const
  {
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      checkRange(mesh_.cells[c], "cell " + std::to_string(c));
    }
    for (auto const& [name, facets] : mesh_.boundaries) {
      for (auto const& facet : facets) {
        checkRange(facet, "a facet of boundary '" + name + "'");
      }
    }
  }

  void checkRegions() const
  {
    ASPERITY_REQUIRE(mesh_.cell_regions.size() == mesh_.cells.size(),
                     where_ << ": there are regions for " << mesh_.cell_regions.size()
                            << " cells, but " << mesh_.cells.size() << " cells.");
    const auto num_regions = static_cast<int>(mesh_.region_names.size());
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      const int region = mesh_.cell_regions[c];
      ASPERITY_REQUIRE(region >= 0 && region < num_regions,
                       where_ << ": cell " << c << " has region " << region << ", outside [0, "
                              << num_regions << ").");
    }
  }

  void checkCells() const
  {
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      const auto points = corners(mesh_, mesh_.cells[c]);
      const double measure = signedMeasure(points);
      const double rounding = 1e-14 * std::pow(longestEdge(points), Dim);
      ASPERITY_REQUIRE(std::abs(measure) > rounding,
                       where_ << ": cell " << c << " with corners " << text(points)
                              << " is degenerate: its corners lie "
                              << (Dim == 2 ? "on a line." : "in a plane."));
      ASPERITY_REQUIRE(measure > 0.0, where_ << ": cell " << c << " with corners " << text(points)
                                             << " is inverted. "
                                             << "Swap two of its vertices.");
    }
  }

  void checkVerticesAreUsed() const
  {
    std::vector<bool> is_used(mesh_.vertices.size(), false);
    for (auto const& cell : mesh_.cells) {
      for (int vertex : cell) {
        is_used[static_cast<std::size_t>(vertex)] = true;
      }
    }
    for (auto const& pair : mesh_.splits) { // checkSplits checks these
      if (pair.plus >= 0 && static_cast<std::size_t>(pair.plus) < is_used.size()) {
        is_used[static_cast<std::size_t>(pair.plus)] = true;
      }
    }
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      ASPERITY_REQUIRE(is_used[v], where_ << ": vertex " << v << " at " << text(mesh_.vertices[v])
                                          << " belongs to no cell.");
    }
  }

  void checkFacets() const
  {
    const detail::FacetTable<Dim> table(mesh_.cells);
    auto const& entries = table.entries();
    for (std::size_t i = 2; i < entries.size(); ++i) {
      ASPERITY_REQUIRE(entries[i].key != entries[i - 2].key,
                       where_ << ": cells " << entries[i - 2].cell << ", " << entries[i - 1].cell
                              << " and " << entries[i].cell << " share the facet with vertices "
                              << numbers(entries[i].key) << "; at most two may.");
    }
    detail::checkSplits(mesh_, table, where_);
    for (auto const& [name, facets] : mesh_.boundaries) {
      auto const& split = mesh_.faults;
      const bool is_split_fault = std::find(split.begin(), split.end(), name) != split.end();
      std::set<typename GlobalMesh<Dim>::Facet> known;
      for (auto const& facet : facets) {
        if (!is_split_fault) {
          checkBoundaryFacet(table, name, facet);
        }
        ASPERITY_REQUIRE(known.insert(detail::sorted(facet)).second,
                         where_ << ": boundary '" << name << "' has the facet with vertices "
                                << numbers(facet) << " twice.");
      }
    }
    const auto inner = detail::innerBoundaries(mesh_, table, where_);
    ASPERITY_REQUIRE(inner.empty() || mesh_.faults.empty(),
                     where_ << ": the mesh is split along its faults, but not along '"
                            << inner.front() << "', which lies inside the body, too.");
    detail::requireConforming(mesh_, table, where_);
  }

  void checkBoundaryFacet(detail::FacetTable<Dim> const& table, std::string const& name,
                          typename GlobalMesh<Dim>::Facet const& facet) const
  {
    const auto [first, last] = table.find(facet);
    ASPERITY_REQUIRE(first != last, where_ << ": the facet of boundary '" << name
                                           << "' with vertices " << numbers(facet) << " at "
                                           << text(corners(mesh_, facet))
                                           << " is not a facet of any cell. Cells have to follow "
                                              "it: in Gmsh, embed it: "
                                           << (Dim == 2 ? "Curve{...} In Surface{...};"
                                                        : "Surface{...} In Volume{...};"));
  }

  GlobalMesh<Dim> const& mesh_;
  std::string const& where_;
};
} // namespace

template <int Dim>
void checkMesh(GlobalMesh<Dim> const& mesh, std::string const& where)
{
  Check<Dim>(mesh, where).run();
}

template <int Dim>
void orientFacets(GlobalMesh<Dim>& mesh)
{
  const detail::FacetTable<Dim> table(mesh.cells);
  for (auto& [name, facets] : mesh.boundaries) {
    if (std::find(mesh.faults.begin(), mesh.faults.end(), name) != mesh.faults.end()) {
      continue; // splitFaults has chosen their sides
    }
    for (auto& facet : facets) {
      const auto [first, last] = table.find(facet);
      if (last - first == 1) {
        facet = first->outward;
      }
    }
  }
}

template <int Dim>
int orientCells(GlobalMesh<Dim>& mesh)
{
  int num_swapped = 0;
  for (auto& cell : mesh.cells) {
    if (signedMeasure(corners(mesh, cell)) < 0.0) {
      std::swap(cell[Dim - 1], cell[Dim]);
      ++num_swapped;
    }
  }
  return num_swapped;
}

template void checkMesh(GlobalMesh<2> const&, std::string const&);
template void checkMesh(GlobalMesh<3> const&, std::string const&);
template void orientFacets(GlobalMesh<2>&);
template void orientFacets(GlobalMesh<3>&);
template int orientCells(GlobalMesh<2>&);
template int orientCells(GlobalMesh<3>&);
} // namespace asperity::mesh
