#include "mesh/generation/BoxMesh.hpp"

namespace asperity::mesh
{
namespace
{
void check(BoxShape const& shape)
{
  double num_vertices = 1.0;
  char const* const size_names[] = {"Box / Width", "Box / Height", "Box / Depth"};
  for (int d = 0; d < 3; ++d) {
    requirePositive(shape.size[d], size_names[d]);
    requirePositive(shape.num_cells[d], std::string("Box / Cells ") + "XYZ"[d]);
    num_vertices *= shape.num_cells[d] + 1.0;
  }
  requireFewVertices(num_vertices, shape.limit);
}

// The six ways from the lowest to the highest corner of a brick, one axis at a time. The last three
// give tetrahedra of the other orientation.
constexpr int axis_orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

// `step`: the difference of the numbers of neighbours along each axis.
void addBrick(int lowest, std::array<int, 3> const& step, std::vector<GlobalMesh<3>::Cell>& cells)
{
  for (int w = 0; w < 6; ++w) {
    auto const& axis_order = axis_orders[w];
    const int second = lowest + step[axis_order[0]], third = second + step[axis_order[1]];
    const int highest = third + step[axis_order[2]];
    if (w < 3) {
      cells.push_back({lowest, second, third, highest});
    } else {
      cells.push_back({lowest, third, second, highest});
    }
  }
}

// The two triangles of a brick's side with steps u and v, where u x v points along an axis;
// outward if the side is the higher one along it.
void addSide(int lowest, int u, int v, bool is_higher, std::vector<GlobalMesh<3>::Facet>& facets)
{
  if (!is_higher) {
    std::swap(u, v);
  }
  facets.push_back({lowest, lowest + u, lowest + u + v});
  facets.push_back({lowest, lowest + u + v, lowest + v});
}
// Calls the function with all (i, j, k) with 0 <= (i, j, k) < counts; i runs fastest.
template <class Call>
void forEach(std::array<int, 3> const& counts, Call const& call)
{
  for (int k = 0; k < counts[2]; ++k) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int i = 0; i < counts[0]; ++i) {
        call(std::array<int, 3>{i, j, k});
      }
    }
  }
}
} // namespace

GlobalMesh<3> boxMesh(BoxShape const& shape)
{
  check(shape);
  auto const& n = shape.num_cells;
  GlobalMesh<3> mesh;
  forEach({n[0] + 1, n[1] + 1, n[2] + 1}, [&](std::array<int, 3> const& place) {
    Point<3> point;
    for (int d = 0; d < 3; ++d) {
      point[d] = shape.lowest_corner[d] + shape.size[d] * place[d] / n[d];
    }
    mesh.vertices.push_back(point);
  });
  constexpr char const* low_names[] = {"left", "bottom", "front"};
  constexpr char const* high_names[] = {"right", "top", "back"};
  const std::array<int, 3> step = {1, n[0] + 1, (n[0] + 1) * (n[1] + 1)};
  forEach(n, [&](std::array<int, 3> const& place) {
    const int lowest = place[0] * step[0] + place[1] * step[1] + place[2] * step[2];
    addBrick(lowest, step, mesh.cells);
    for (int d = 0; d < 3; ++d) {
      const int u = step[(d + 1) % 3], v = step[(d + 2) % 3];
      if (place[d] == 0) {
        addSide(lowest, u, v, false, mesh.boundaries[low_names[d]]);
      }
      if (place[d] + 1 == n[d]) {
        addSide(lowest + step[d], u, v, true, mesh.boundaries[high_names[d]]);
      }
    }
  });
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
  return mesh;
}
} // namespace asperity::mesh
