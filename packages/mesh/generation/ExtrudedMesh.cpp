#include "mesh/generation/ExtrudedMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"

namespace asperity::mesh
{
namespace
{
void check(GlobalMesh<2> const& plane, std::vector<double> const& levels)
{
  ASPERITY_REQUIRE(levels.size() >= 2,
                   "Mesh: extrusion needs at least 2 levels, not " << levels.size() << '.');
  for (std::size_t k = 0; k < levels.size(); ++k) {
    ASPERITY_REQUIRE(std::isfinite(levels[k]) && (k == 0 || levels[k] > levels[k - 1]),
                     "Mesh: the levels of an extrusion have to ascend, but number "
                       << k << " is at " << levels[k] << " m.");
  }
  const auto size = static_cast<double>(plane.vertices.size());
  ASPERITY_REQUIRE(size * static_cast<double>(levels.size()) < 3e8,
                   "Mesh: " << levels.size() << " levels of " << plane.vertices.size()
                            << " vertices are too many: a mesh has fewer than 3e8 vertices.");
  for (char const* name : {"front", "back"}) {
    ASPERITY_REQUIRE(plane.boundaries.count(name) == 0,
                     "Mesh: a mesh with a boundary '"
                       << name << "' cannot be extruded: the extrusion has one itself.");
  }
}

// The prism over triangle (a, b, c), whose vertices have these numbers on the lower level and
// numbers higher by `up` on the upper one. Its tetrahedra go from the smallest vertex number to
// the largest: with p < q < r they are p q r r', p q q' r', p p' q' r'.
void addPrism(GlobalMesh<2>::Cell const& triangle, int up, std::vector<GlobalMesh<3>::Cell>& cells)
{
  auto [p, q, r] = triangle;
  bool is_turned = false;
  const auto order = [&is_turned](int& first, int& second) {
    if (first > second) {
      std::swap(first, second);
      is_turned = !is_turned;
    }
  };
  order(p, q);
  order(q, r);
  order(p, q);
  for (GlobalMesh<3>::Cell cell :
       {GlobalMesh<3>::Cell{p, q, r, r + up}, GlobalMesh<3>::Cell{p, q + up, q, r + up},
        GlobalMesh<3>::Cell{p, p + up, q + up, r + up}}) {
    if (is_turned) {
      std::swap(cell[2], cell[3]);
    }
    cells.push_back(cell);
  }
}

// The side over an edge that has the body to its left, with outward orientation.
void addSide(GlobalMesh<2>::Facet const& edge, int up, std::vector<GlobalMesh<3>::Facet>& facets)
{
  const auto [p, q] = edge;
  if (p < q) {
    facets.push_back({p, q, q + up});
    facets.push_back({p, q + up, p + up});
  } else {
    facets.push_back({p, q, p + up});
    facets.push_back({q, q + up, p + up});
  }
}
} // namespace

GlobalMesh<3> extrude(GlobalMesh<2> const& plane, std::vector<double> const& levels)
{
  check(plane, levels);
  const auto up = static_cast<int>(plane.vertices.size());
  const auto last = static_cast<int>(levels.size()) - 1;
  GlobalMesh<3> mesh;
  mesh.region_names = plane.region_names;
  mesh.period = {plane.period[0], plane.period[1], 0.0};
  for (double z : levels) {
    for (auto const& point : plane.vertices) {
      mesh.vertices.push_back({point[0], point[1], z});
    }
  }
  for (int k = 0; k < last; ++k) {
    const int first = k * up;
    for (std::size_t c = 0; c < plane.cells.size(); ++c) {
      auto const& [i, j, l] = plane.cells[c];
      addPrism({first + i, first + j, first + l}, up, mesh.cells);
      mesh.cell_regions.insert(mesh.cell_regions.end(), 3, plane.cell_regions[c]);
    }
    for (auto const& [name, edges] : plane.boundaries) {
      for (auto const& [i, j] : edges) {
        addSide({first + i, first + j}, up, mesh.boundaries[name]);
      }
    }
  }
  auto &front = mesh.boundaries["front"], &back = mesh.boundaries["back"];
  for (auto const& [i, j, l] : plane.cells) {
    front.push_back({i, l, j});
    back.push_back({last * up + i, last * up + j, last * up + l});
  }
  return mesh;
}

std::vector<double> equalLevels(double length, int num_layers)
{
  std::vector<double> levels;
  for (int k = 0; k <= num_layers; ++k) {
    levels.push_back(length * (static_cast<double>(k) / num_layers));
  }
  return levels;
}
} // namespace asperity::mesh
