#include "unit/io/ByTurns.hpp"

namespace asperity::test
{
Mesh<2> stripMesh(int num_base)
{
  GlobalMesh<2> strip;
  strip.vertices.resize(2 * num_base);
  const auto bottom = [&](int i) { return num_base - 1 - i; };
  const auto top = [&](int i) { return 2 * num_base - 1 - i; };
  for (int i = 0; i < num_base; ++i) {
    strip.vertices[bottom(i)] = {stripPosition(i, num_base), 0};
    strip.vertices[top(i)] = {stripPosition(i, num_base), 1};
  }
  for (int i = 0; i + 1 < num_base; ++i) {
    strip.cells.push_back({bottom(i), bottom(i + 1), top(i)});
    strip.cells.push_back({bottom(i + 1), top(i + 1), top(i)});
    strip.boundaries["base"].push_back({bottom(i), bottom(i + 1)});
    strip.boundaries["surface"].push_back({top(i + 1), top(i)});
  }
  return byTurns(strip);
}

Mesh<2> dippingStrip(int num_base)
{
  auto mesh = stripMesh(num_base);
  for (auto& vertex : mesh.vertices) {
    vertex[1] -= vertex[0];
  }
  return mesh;
}

Mesh<2> uprightStrip(int num_base)
{
  auto mesh = stripMesh(num_base);
  for (auto& vertex : mesh.vertices) {
    vertex = {-vertex[1], vertex[0] - 1};
  }
  return mesh;
}
} // namespace asperity::test
