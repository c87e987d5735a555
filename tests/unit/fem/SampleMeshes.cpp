#include "unit/fem/SampleMeshes.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity::fem::test
{
double pseudorandom(GlobalOrdinal index, int sequence)
{
  const double x = std::sin(12.9898 * static_cast<double>(index) + 78.233 * sequence) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}

GlobalMesh<2> uniformRectangle(int cells_x, int cells_y, double width, double height)
{
  GlobalMesh<2> mesh;
  auto const vertex = [=](int i, int j) { return j * (cells_x + 1) + i; };
  for (int j = 0; j <= cells_y; ++j) {
    for (int i = 0; i <= cells_x; ++i) {
      mesh.vertices.push_back({width * i / cells_x, height * j / cells_y});
    }
  }
  for (int j = 0; j < cells_y; ++j) {
    for (int i = 0; i < cells_x; ++i) {
      mesh.cells.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.cells.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
    mesh.boundaries["right"].push_back({vertex(cells_x, j), vertex(cells_x, j + 1)});
    mesh.boundaries["left"].push_back({vertex(0, j + 1), vertex(0, j)});
  }
  for (int i = 0; i < cells_x; ++i) {
    mesh.boundaries["bottom"].push_back({vertex(i, 0), vertex(i + 1, 0)});
    mesh.boundaries["top"].push_back({vertex(i + 1, cells_y), vertex(i, cells_y)});
  }
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
  return mesh;
}

namespace
{
// The facets of the box by the side that they lie on.
void nameSides(GlobalMesh<3>& mesh, Point<3> const& size)
{
  static const char* names[3][2] = {{"left", "right"}, {"bottom", "top"}, {"front", "back"}};
  for (auto const& cell : mesh.cells) {
    for (int left_out = 0; left_out < 4; ++left_out) {
      std::array<int, 3> facet{};
      for (int k = 0, n = 0; k < 4; ++k) {
        if (k != left_out) {
          facet[n++] = cell[k];
        }
      }
      for (int axis = 0; axis < 3; ++axis) {
        for (int side : {0, 1}) {
          const bool on_side = std::all_of(facet.begin(), facet.end(), [&](int v) {
            return mesh.vertices[v][axis] == side * size[axis];
          });
          if (on_side) {
            mesh.boundaries[names[axis][side]].push_back(facet);
          }
        }
      }
    }
  }
  mesh::orientFacets(mesh);
}
} // namespace

GlobalMesh<3> uniformBox(std::array<int, 3> const& cells, Point<3> const& size)
{
  GlobalMesh<3> mesh;
  const int row = cells[0] + 1;
  const int layer = row * (cells[1] + 1);
  for (int k = 0; k <= cells[2]; ++k) {
    for (int j = 0; j <= cells[1]; ++j) {
      for (int i = 0; i <= cells[0]; ++i) {
        mesh.vertices.push_back(
          {size[0] * i / cells[0], size[1] * j / cells[1], size[2] * k / cells[2]});
      }
    }
  }
  // Along the edges of a block from one corner to the opposite one, in each order of the axes.
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const int stride[3] = {1, row, layer};
  for (int corner = 0; corner < static_cast<int>(mesh.vertices.size()); ++corner) {
    if (corner % row == cells[0] || corner % layer / row == cells[1] ||
        corner / layer == cells[2]) {
      continue;
    }
    for (auto const& order : orders) {
      const int second = corner + stride[order[0]];
      const int third = second + stride[order[1]];
      mesh.cells.push_back({corner, second, third, third + stride[order[2]]});
    }
  }
  mesh::orientCells(mesh);
  nameSides(mesh, size);
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
  return mesh;
}

GlobalMesh<3> uniformCube(int cells)
{
  auto mesh = uniformBox({cells, cells, cells}, {1, 1, 1});
  auto sides = std::move(mesh.boundaries);
  mesh.boundaries = {{"bottom", sides["front"]}, {"top", sides["back"]}, {"sides", sides["left"]}};
  auto& others = mesh.boundaries["sides"];
  for (auto const* name : {"right", "bottom", "top"}) {
    others.insert(others.end(), sides[name].begin(), sides[name].end());
  }
  return mesh;
}

template <int Dim>
void distort(GlobalMesh<Dim>& mesh, double amplitude)
{
  std::set<int> outer;
  for (auto const& entry : mesh.boundaries) {
    for (auto const& facet : entry.second) {
      outer.insert(facet.begin(), facet.end());
    }
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (outer.count(static_cast<int>(v)) == 0) {
      for (int i = 0; i < Dim; ++i) {
        mesh.vertices[v][i] += amplitude * pseudorandom(v, i);
      }
    }
  }
  mesh::checkMesh(mesh, "distorted mesh");
}

template void distort<2>(GlobalMesh<2>&, double);
template void distort<3>(GlobalMesh<3>&, double);

void rotate(GlobalMesh<2>& mesh, double angle)
{
  for (auto& x : mesh.vertices) {
    x = {std::cos(angle) * x[0] - std::sin(angle) * x[1],
         std::sin(angle) * x[0] + std::cos(angle) * x[1]};
  }
}

Rotation rotationAbout(Point<3> axis, double angle)
{
  const double length = std::sqrt(mesh::dot<3>(axis, axis));
  Rotation result;
  for (int i = 0; i < 3; ++i) {
    // Rodrigues: row i is the transpose's image of the unit vector i.
    Point<3> unit{};
    unit[i] = 1;
    Point<3> n = {axis[0] / length, axis[1] / length, axis[2] / length};
    auto const turned = mesh::cross(unit, n);
    for (int c = 0; c < 3; ++c) {
      result[i][c] = unit[c] * std::cos(angle) + turned[c] * std::sin(angle) +
                     n[i] * n[c] * (1 - std::cos(angle));
    }
  }
  return result;
}

Point<3> rotated(Rotation const& rotation, Point<3> const& x)
{
  return {mesh::dot<3>(rotation[0], x), mesh::dot<3>(rotation[1], x), mesh::dot<3>(rotation[2], x)};
}

Point<3> rotatedBack(Rotation const& rotation, Point<3> const& x)
{
  Point<3> result{};
  for (int i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) {
      result[c] += rotation[i][c] * x[i];
    }
  }
  return result;
}

void rotate(GlobalMesh<3>& mesh, Rotation const& rotation)
{
  for (auto& x : mesh.vertices) {
    x = rotated(rotation, x);
  }
}
} // namespace asperity::fem::test
