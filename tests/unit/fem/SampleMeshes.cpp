#include "unit/fem/SampleMeshes.hpp"

#include <cmath>
#include <set>

namespace asperity::fem::testing
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

GlobalMesh<3> uniformCube(int cells)
{
  GlobalMesh<3> mesh;
  const int row = cells + 1;
  for (int k = 0; k < row; ++k) {
    for (int j = 0; j < row; ++j) {
      for (int i = 0; i < row; ++i) {
        mesh.vertices.push_back({double(i) / cells, double(j) / cells, double(k) / cells});
      }
    }
  }
  // Along the edges of the cube from one corner to the opposite one, in each order of the axes.
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const int stride[3] = {1, row, row * row};
  for (int corner = 0; corner < row * row * row; ++corner) {
    if (corner % row == cells || corner / row % row == cells || corner / (row * row) == cells) {
      continue;
    }
    for (auto const& order : orders) {
      const int second = corner + stride[order[0]];
      const int third = second + stride[order[1]];
      mesh.cells.push_back({corner, second, third, third + stride[order[2]]});
    }
  }
  mesh::orientCells(mesh);
  for (auto const& cell : mesh.cells) {
    for (int left_out = 0; left_out < 4; ++left_out) {
      std::array<int, 3> facet{};
      for (int k = 0, n = 0; k < 4; ++k) {
        if (k != left_out) {
          facet[n++] = cell[k];
        }
      }
      for (int axis = 0; axis < 3; ++axis) {
        for (double side : {0., 1.}) {
          bool on_side = true;
          for (int v : facet) {
            on_side = on_side && mesh.vertices[v][axis] == side;
          }
          if (on_side) {
            mesh.boundaries[axis < 2 ? "sides" : (side == 0 ? "bottom" : "top")].push_back(facet);
          }
        }
      }
    }
  }
  mesh::orientFacets(mesh);
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
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

void expectInputError(std::function<void()> const& call, std::vector<std::string> const& pieces)
{
  try {
    call();
    ADD_FAILURE() << "nothing was thrown; expected '" << pieces.front() << "'";
  } catch (InputError const& error) {
    const std::string message = error.what();
    for (auto const& piece : pieces) {
      EXPECT_NE(message.find(piece), std::string::npos) << "'" << piece << "' not in: " << message;
    }
  }
}
} // namespace asperity::fem::testing
