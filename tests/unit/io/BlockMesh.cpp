#include "unit/io/BlockMesh.hpp"
#include "unit/io/ByTurns.hpp"

#include <array>

namespace asperity::test
{
namespace
{
// The six tetrahedra along the diagonal of a brick; bit d of a corner's number is its side along d.
constexpr std::array<std::array<int, 4>, 6> tetrahedra{
  {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

void addBrick(GlobalMesh<3>& mesh, std::array<int, 8> const& corners)
{
  for (auto const& local : tetrahedra) {
    mesh.cells.push_back(
      {corners[local[0]], corners[local[1]], corners[local[2]], corners[local[3]]});
  }
}
} // namespace

Mesh<3> blockMesh(bool periodic, Placement const& placement)
{
  const std::array<int, 3> layers{block_nx, 1, block_nz};
  const int deep = periodic ? block_nz : block_nz + 1; // vertices along z
  const int count = (block_nx + 1) * 2 * deep;
  const auto vertex = [&](int i, int j, int k) { // against all orders
    return count - 1 - ((i * 2 + j) * deep + k % deep);
  };
  GlobalMesh<3> block;
  block.vertices.resize(count);
  for (int i = 0; i <= layers[0]; ++i) {
    for (int j = 0; j <= 1; ++j) {
      for (int k = 0; k < deep; ++k) {
        block.vertices[vertex(i, j, k)] = placement({double(i), double(j), double(k)});
      }
    }
  }
  for (int i = 0; i < layers[0]; ++i) {
    for (int k = 0; k < layers[2]; ++k) {
      std::array<int, 8> corners;
      for (int c = 0; c < 8; ++c) {
        corners[c] = vertex(i + (c & 1), (c >> 1) & 1, k + (c >> 2));
      }
      addBrick(block, corners);
      // Counter-clockwise about the outward normal, -y.
      block.boundaries["base"].push_back({corners[0], corners[1], corners[5]});
      block.boundaries["base"].push_back({corners[0], corners[5], corners[4]});
    }
  }
  block.period = {0, 0, periodic ? double(block_nz) : 0};
  return byTurns(block);
}

Mesh<3> tetrahedron()
{
  Mesh<3> mesh;
  mesh.num_global_vertices = 4;
  mesh.boundaries["base"] = {};
  if (world()->getRank() == 0) {
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0.5, 0.25, 4}};
    mesh.global_ids = {0, 1, 2, 3};
    mesh.num_owned = 4;
    mesh.cells = {{0, 1, 2, 3}};
    mesh.boundaries["base"] = {{0, 2, 1}};
  }
  return mesh;
}
} // namespace asperity::test
