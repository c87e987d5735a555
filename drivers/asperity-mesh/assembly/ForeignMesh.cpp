#include "assembly/ForeignMesh.hpp"

#include "Warnings.hpp"
#include "assembly/FaultSheets.hpp"
#include "assembly/GroupNames.hpp"
#include "assembly/SharedFacets.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::geometry
{
int ForeignMesh::region(std::string const& name)
{
  const auto found = std::find(region_names.begin(), region_names.end(), name);
  const auto position = static_cast<int>(found - region_names.begin());
  if (found == region_names.end()) {
    region_names.push_back(name);
  }
  return position;
}

ForeignMesh::Group& ForeignMesh::group(std::string const& name)
{
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](Group const& known) { return known.name == name; });
  return found != groups.end() ? *found : groups.emplace_back(Group{name, {}});
}

void ForeignMesh::addCell(int region, std::vector<int> const& nodes, int num_corners,
                          std::int64_t number)
{
  Cell cell{region, num_corners, {}};
  std::copy_n(nodes.begin(), num_corners, cell.corners.begin());
  for (std::size_t i = static_cast<std::size_t>(num_corners); i < nodes.size(); ++i) {
    middle_nodes.emplace_back(static_cast<int>(cells.size()), nodes[i]);
  }
  const bool is_linear = static_cast<int>(nodes.size()) == num_corners;
  if (first_other.empty() && (num_corners != dimension + 1 || !is_linear)) {
    first_other = "cell " + std::to_string(number) + " is a " + shapeName(dimension, num_corners) +
                  (is_linear ? "" : " of second order");
  }
  cells.push_back(cell);
}

void ForeignMesh::addSide(std::string const& group_name, int cell, std::vector<int> const& places)
{
  std::vector<int> corners;
  for (int place : places) {
    corners.push_back(
      cells[static_cast<std::size_t>(cell)].corners[static_cast<std::size_t>(place)]);
  }
  group(group_name).sides.push_back(side(corners));
}

ForeignMesh::Side ForeignMesh::side(std::vector<int> const& corners)
{
  Side result = {-1, -1, -1, -1};
  std::copy_n(corners.begin(), std::min<std::size_t>(corners.size(), 4), result.begin());
  return result;
}

namespace
{
template <int Dim>
class Assembly
{
public:
  Assembly(ForeignMesh const& mesh, AssemblyOptions const& options, std::string const& where)
      : foreign_(mesh)
      , options_(options)
      , where_(where)
  {
  }

  GlobalMesh<Dim> run()
  {
    ASPERITY_REQUIRE(options_.simplices || foreign_.first_other.empty(),
                     where_ << ": " << foreign_.first_other
                            << ". Only triangles and tetrahedra of first order can be used. Give "
                               "--simplices, which cuts all cells into them.");
    mesh_.region_names = foreign_.region_names;
    readVertices();
    cutCells();
    readBoundaries();
    mesh::orientCells(mesh_);
    mesh::orientFacets(mesh_);
    mesh::checkMesh(mesh_, where_);
    warnOfMiddleNodes();
    separate();
    return std::move(mesh_);
  }

private:
  // Of cells alone: Gmsh's files also hold the points from which lines and arcs were made.
  void readVertices()
  {
    std::vector<bool> is_used(foreign_.vertices.size(), false);
    for (auto const& cell : foreign_.cells) {
      for (int i = 0; i < cell.num_corners; ++i) {
        is_used[static_cast<std::size_t>(cell.corners[i])] = true;
      }
    }
    position_.assign(is_used.size(), -1);
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      if (is_used[v]) {
        position_[v] = static_cast<int>(mesh_.vertices.size());
        mesh_.vertices.push_back(place(v));
        size_ = std::max(size_, mesh::distance<Dim>(mesh_.vertices.back(), mesh_.vertices.front()));
      }
    }
    for (std::size_t v = 0; v < is_used.size() && Dim == 2; ++v) {
      const double z = options_.scale * foreign_.vertices[v][2];
      ASPERITY_REQUIRE(!is_used[v] || std::abs(z) <= 1e-9 * size_,
                       where_ << ": node " << number(v) << " has z = " << z
                              << ". A two-dimensional mesh lies in the plane z = 0.");
    }
  }

  Point<Dim> place(std::size_t vertex) const
  {
    Point<Dim> result;
    std::transform(foreign_.vertices[vertex].begin(), foreign_.vertices[vertex].begin() + Dim,
                   result.begin(), [this](double x) { return options_.scale * x; });
    return result;
  }

  std::int64_t number(std::size_t vertex) const
  {
    return foreign_.numbers.empty() ? static_cast<std::int64_t>(vertex) : foreign_.numbers[vertex];
  }

  // A cell that is not convex would be cut into simplices that overlap.
  void cutCells()
  {
    for (auto const& cell : foreign_.cells) {
      std::vector<int> corners;
      for (int i = 0; i < cell.num_corners; ++i) {
        corners.push_back(position_[static_cast<std::size_t>(cell.corners[i])]);
      }
      const auto simplices = simplicesOf(Dim, corners);
      ASPERITY_REQUIRE(!simplices.empty(), where_ << ": the cell at " << text(cell)
                                                  << " has no volume: corners coincide.");
      bool has_positive = false, has_negative = false;
      for (auto const& simplex : simplices) {
        auto& added = mesh_.cells.emplace_back();
        std::copy_n(simplex.begin(), Dim + 1, added.begin());
        mesh_.cell_regions.push_back(cell.region);
        const double measure = mesh::signedMeasure(mesh::corners<Dim>(mesh_.vertices, added));
        has_positive = has_positive || measure > 0;
        has_negative = has_negative || measure < 0;
      }
      ASPERITY_REQUIRE(!has_positive || !has_negative,
                       where_ << ": the " << shapeName(Dim, cell.num_corners) << " at "
                              << text(cell) << " cannot be cut into simplices: it is not convex, "
                              << "or its corners are in another order.");
    }
  }

  // Where a cell has its first corner.
  std::string text(ForeignMesh::Cell const& cell) const
  {
    const auto corner = place(static_cast<std::size_t>(cell.corners[0]));
    return formatPoint({corner.begin(), corner.end()}) + " m";
  }

  void readBoundaries()
  {
    for (auto const& group : foreign_.groups) {
      auto& facets = mesh_.boundaries[group.name];
      std::set<std::array<int, Dim>> known; // by ascending vertices
      for (auto const& facet : facets) {
        known.insert(sorted(facet));
      }
      for (auto const& side : group.sides) {
        std::vector<int> corners;
        for (int vertex : side) {
          if (vertex >= 0) {
            corners.push_back(cornerOfCell(group.name, static_cast<std::size_t>(vertex)));
          }
        }
        for (auto const& simplex : simplicesOf(Dim - 1, corners)) {
          std::array<int, Dim> facet;
          std::copy_n(simplex.begin(), Dim, facet.begin());
          if (known.insert(sorted(facet)).second) {
            facets.push_back(facet);
          }
        }
      }
    }
    leaveOut();
  }

  static std::array<int, Dim> sorted(std::array<int, Dim> facet)
  {
    std::sort(facet.begin(), facet.end());
    return facet;
  }

  // Gmsh meshes a curve or a surface that is not embedded for itself.
  int cornerOfCell(std::string const& boundary, std::size_t vertex) const
  {
    ASPERITY_REQUIRE(
      position_[vertex] >= 0,
      where_ << ": the facets of '" << boundary << "' are not sides of cells: its "
             << "node " << number(vertex) << " belongs to no cell. In Gmsh, embed it: "
             << (Dim == 2 ? "Curve{...} In Surface{...};" : "Surface{...} In Volume{...};")
             << " Or cut the body along it with BooleanFragments.");
    return position_[vertex];
  }

  void leaveOut()
  {
    std::vector<std::string> boundaries;
    for (auto const& item : mesh_.boundaries) {
      boundaries.push_back(item.first);
    }
    requireBoundaries(options_.without, boundaries, mesh_.region_names, where_);
    for (auto const& name : options_.without) {
      mesh_.boundaries.erase(name);
    }
  }

  void separate()
  {
    const auto faults = faultsOf(mesh_);
    separateFaults(mesh_, faults, where_);
    for (auto const& fault : faults) {
      divideIntoSheets(mesh_, fault, where_);
    }
  }

  // A node of second order is in the middle between two corners where sides are straight.
  void warnOfMiddleNodes() const
  {
    double largest = 0;
    for (auto const& [cell, node] : foreign_.middle_nodes) {
      const auto found = place(static_cast<std::size_t>(node));
      auto const& [region, num_corners, corners] = foreign_.cells[static_cast<std::size_t>(cell)];
      double nearest = INFINITY;
      for (int a = 0; a < num_corners; ++a) {
        for (int b = 0; b < num_corners; ++b) {
          const auto first = place(static_cast<std::size_t>(corners[a]));
          const auto second = place(static_cast<std::size_t>(corners[b]));
          Point<Dim> middle;
          for (int d = 0; d < Dim; ++d) {
            middle[d] = 0.5 * (first[d] + second[d]);
          }
          nearest = std::min(nearest, mesh::distance<Dim>(found, middle));
        }
      }
      largest = std::max(largest, nearest);
    }
    if (largest > 1e-6 * size_) {
      warn(where_ +
           ": its sides are curved or its nodes of second order are not in the middle of "
           "sides, by up to " +
           formatShort(largest) + " m. The sides are straight now.");
    }
  }

  ForeignMesh const& foreign_;
  AssemblyOptions const& options_;
  std::string const& where_;
  GlobalMesh<Dim> mesh_;
  std::vector<int> position_; // of the file's vertex among those of cells, or -1
  double size_ = 0;           // [m]
};
} // namespace

template <int Dim>
GlobalMesh<Dim> assemble(ForeignMesh const& mesh, AssemblyOptions const& options,
                         std::string const& where)
{
  return Assembly<Dim>(mesh, options, where).run();
}

template GlobalMesh<2> assemble(ForeignMesh const&, AssemblyOptions const&, std::string const&);
template GlobalMesh<3> assemble(ForeignMesh const&, AssemblyOptions const&, std::string const&);
} // namespace asperity::geometry
