#include "mesh/generation/RectangleMesh.hpp"

namespace asperity::mesh
{
namespace
{
void check(RectangleShape const& shape)
{
  requirePositive(shape.width, "Rectangle / Width");
  requirePositive(shape.height, "Rectangle / Height");
  requirePositive(shape.cells_x, "Rectangle / Cells X");
  requirePositive(shape.cells_y, "Rectangle / Cells Y");
  requireFewVertices((shape.cells_x + 1.0) * (shape.cells_y + 1.0), shape.limit);
}

void addCells(int lower_left, int upper_left, bool rises, GlobalMesh<2>& mesh)
{
  const int a = lower_left, b = lower_left + 1, c = upper_left + 1, d = upper_left;
  if (rises) {
    mesh.cells.push_back({a, b, c});
    mesh.cells.push_back({a, c, d});
  } else {
    mesh.cells.push_back({a, b, d});
    mesh.cells.push_back({b, c, d});
  }
}
} // namespace

GlobalMesh<2> rectangleMesh(RectangleShape const& shape)
{
  check(shape);
  const int nx = shape.cells_x, ny = shape.cells_y;
  const auto number = [&](int i, int j) { return j * (nx + 1) + i; };
  GlobalMesh<2> mesh;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      mesh.vertices.push_back(
        {shape.lower_left[0] + shape.width * i / nx, shape.lower_left[1] + shape.height * j / ny});
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      addCells(number(i, j), number(i, j + 1), (i + j) % 2 == 0, mesh);
    }
  }
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
  auto &bottom = mesh.boundaries["bottom"], &top = mesh.boundaries["top"];
  auto &left = mesh.boundaries["left"], &right = mesh.boundaries["right"];
  for (int i = 0; i < nx; ++i) {
    bottom.push_back({number(i, 0), number(i + 1, 0)});
    top.push_back({number(i + 1, ny), number(i, ny)});
  }
  for (int j = 0; j < ny; ++j) {
    left.push_back({number(0, j + 1), number(0, j)});
    right.push_back({number(nx, j), number(nx, j + 1)});
  }
  return mesh;
}
} // namespace asperity::mesh
