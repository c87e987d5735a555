#pragma once

#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"

#include <map>
#include <set>

namespace asperity::mesh
{
template <int Dim>
using Conditions = std::vector<NamedCondition<Dim>>;

// [0, 4] x [-2, 2] in squares of two triangles each, with sides 1 or smaller.
inline GlobalMesh<2> faultedRectangle(Conditions<2> const& faults, int cells_per_unit = 1)
{
  auto mesh = rectangleMesh({4.0, 4.0, 4 * cells_per_unit, 4 * cells_per_unit, {0.0, -2.0}});
  addFaults(mesh, faults);
  return mesh;
}

// [0, 4] x [-2, 2] x [0, 4] in unit cubes of six tetrahedra each.
inline GlobalMesh<3> faultedBox(Conditions<3> const& faults)
{
  auto mesh = boxMesh({{4.0, 4.0, 4.0}, {4, 4, 4}, {0.0, -2.0, 0.0}});
  addFaults(mesh, faults);
  return mesh;
}

template <int Dim>
GlobalMesh<Dim> split(GlobalMesh<Dim> mesh)
{
  splitFaults(mesh, "test");
  return mesh;
}

// Numbers of the tips and of the other pairs.
template <int Dim>
std::pair<int, int> numTipsAndOthers(GlobalMesh<Dim> const& mesh)
{
  int tips = 0;
  for (auto const& pair : mesh.splits) {
    tips += pair.is_tip ? 1 : 0;
  }
  return {tips, static_cast<int>(mesh.splits.size()) - tips};
}

// The area-weighted mean of the normals from minus to plus, times the area.
template <int Dim>
Point<Dim> upOf(GlobalMesh<Dim> const& mesh, std::string const& fault)
{
  auto up = integralOfNormal(mesh, fault);
  for (double& component : up) {
    component = -component;
  }
  return up;
}

// The pairs whose minus vertex is at this place.
template <int Dim>
std::vector<SplitVertex> pairsAt(GlobalMesh<Dim> const& mesh, Point<Dim> const& place)
{
  std::vector<SplitVertex> pairs;
  for (auto const& pair : mesh.splits) {
    if (mesh.vertices[pair.minus] == place) {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

// Neighbouring cells of the mesh before the split have the same vertices of the facet between them
// afterwards, unless it is a facet of a fault: then only the vertices that are tips of that fault.
template <int Dim>
void expectCutAlongFaultsOnly(GlobalMesh<Dim> const& before, GlobalMesh<Dim> const& after)
{
  using Facet = typename GlobalMesh<Dim>::Facet;
  std::map<Facet, std::set<int>> tips_of_facet; // by the original vertices
  const FaultSides<Dim> sides(after);
  for (auto const& name : after.faults) {
    auto const& facets = before.boundaries.at(name);
    for (std::size_t f = 0; f < facets.size(); ++f) {
      auto& tips = tips_of_facet[detail::sorted(facets[f])];
      for (int plus : after.boundaries.at(name)[f]) {
        auto const* pair = sides.find(plus);
        ASSERT_TRUE(pair) << "vertex " << plus << " of fault " << name;
        if (pair->is_tip) {
          tips.insert(pair->minus);
        }
      }
    }
  }
  const detail::FacetTable<Dim> table(before.cells);
  auto const& entries = table.entries();
  int num_cut = 0;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].key != entries[i - 1].key) {
      continue;
    }
    const auto cut = tips_of_facet.find(entries[i].key);
    num_cut += cut != tips_of_facet.end() ? 1 : 0;
    for (int vertex : entries[i].key) {
      std::array<int, 2> now;
      for (int side = 0; side < 2; ++side) {
        const int cell = entries[i - side].cell;
        auto const& old = before.cells[cell];
        now[side] = after.cells[cell][std::find(old.begin(), old.end(), vertex) - old.begin()];
      }
      const bool is_shared = cut == tips_of_facet.end() || cut->second.count(now[0]) > 0;
      EXPECT_EQ(now[0] == now[1], is_shared)
        << "vertex " << vertex << " of cells " << entries[i].cell << " and " << entries[i - 1].cell;
    }
  }
  EXPECT_EQ(num_cut, static_cast<int>(tips_of_facet.size()));
}

// What holds for every split: nothing moves, nothing is lost, only faults are cut, facets of faults
// look out of the body on their plus side, and those of the surface belong to their cells.
template <int Dim>
void expectGoodSplit(GlobalMesh<Dim> const& before, GlobalMesh<Dim> const& after)
{
  checkMesh(after, "test");
  const std::size_t num_originals = before.vertices.size();
  ASSERT_EQ(after.vertices.size(), num_originals + after.splits.size());
  EXPECT_TRUE(std::equal(before.vertices.begin(), before.vertices.end(), after.vertices.begin()));
  int original = 0;
  for (std::size_t s = 0; s < after.splits.size(); ++s) {
    auto const& pair = after.splits[s];
    EXPECT_EQ(pair.plus, static_cast<int>(num_originals + s));
    EXPECT_EQ(after.vertices[pair.plus], after.vertices[pair.minus]);
    const int minus = pair.minus < static_cast<int>(num_originals)
                        ? pair.minus
                        : after.splits[pair.minus - num_originals].minus;
    EXPECT_GE(minus, original) << "copies are in the order of the originals";
    original = minus;
  }
  ASSERT_EQ(after.cells.size(), before.cells.size());
  EXPECT_EQ(after.cell_regions, before.cell_regions);
  for (std::size_t c = 0; c < after.cells.size(); ++c) {
    EXPECT_EQ(corners(after, after.cells[c]), corners(before, before.cells[c]));
  }
  EXPECT_DOUBLE_EQ(cellSizes(after).measure, cellSizes(before).measure);
  expectCutAlongFaultsOnly(before, after);

  const FaultSides<Dim> sides(after);
  const detail::FacetTable<Dim> table(after.cells);
  for (auto const& [name, facets] : after.boundaries) {
    ASSERT_EQ(facets.size(), before.boundaries.at(name).size());
    const bool is_fault =
      std::find(after.faults.begin(), after.faults.end(), name) != after.faults.end();
    for (std::size_t f = 0; f < facets.size(); ++f) {
      EXPECT_DOUBLE_EQ(facetMeasure(corners(after, facets[f])),
                       facetMeasure(corners(before, before.boundaries.at(name)[f])));
      const auto facet = is_fault ? sides.plusSide(facets[f]) : facets[f];
      const auto normal = areaNormal(corners(after, facet));
      const auto [first, last] = table.find(facet);
      ASSERT_NE(first, last) << name;
      bool has_cell_inside = false; // two of them where all vertices of the facet are tips
      for (auto entry = first; entry != last; ++entry) {
        const auto inward = difference<Dim>(centroid(corners(after, after.cells[entry->cell])),
                                            centroid(corners(after, facet)));
        has_cell_inside = has_cell_inside || dot<Dim>(inward, normal) < 0.0;
      }
      EXPECT_TRUE(has_cell_inside) << name;
    }
  }
}

// FaultSides gives each facet of a fault the cells on its two sides.
template <int Dim>
void expectSidesOfFacets(GlobalMesh<Dim> const& mesh)
{
  const FaultSides<Dim> sides(mesh);
  const detail::FacetTable<Dim> table(mesh.cells);
  for (auto const& name : mesh.faults) {
    for (auto const& facet : mesh.boundaries.at(name)) {
      const auto points = corners(mesh, facet);
      for (const bool is_plus : {true, false}) {
        const auto [first, last] =
          table.find(is_plus ? sides.plusSide(facet) : sides.minusSide(facet));
        bool is_found = false; // between tips both cells have the facet
        for (auto entry = first; entry != last; ++entry) {
          const auto inside = centroid(corners(mesh, mesh.cells[entry->cell]));
          const bool is_within =
            dot<Dim>(difference<Dim>(inside, points[0]), areaNormal(points)) < 0.0;
          is_found = is_found || is_within == is_plus;
        }
        EXPECT_TRUE(is_found) << name << " at " << points[0][0] << ", " << points[0][1];
      }
    }
  }
}

// Splits and expects so many tips and other pairs.
template <int Dim>
GlobalMesh<Dim> goodSplit(GlobalMesh<Dim> const& mesh, int num_tips, int num_others)
{
  auto result = split(mesh);
  expectGoodSplit(mesh, result);
  EXPECT_EQ(numTipsAndOthers(result), (std::pair<int, int>{num_tips, num_others}));
  return result;
}
} // namespace asperity::mesh
