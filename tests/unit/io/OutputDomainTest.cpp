#include "io/OutputDomain.hpp"
#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "io/detail/CurveOrder.hpp"
#include "io/parallel/BlocksInOrder.hpp"
#include "io/parallel/NodeBlocks.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/io/Support.hpp"

#include <numeric>

using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
constexpr int num_base = 7;

double sumOverRanks(std::vector<double> const& values)
{
  const double mine = std::accumulate(values.begin(), values.end(), 0.0);
  return asperity::sumOverRanks(mine, *world());
}
} // namespace

TEST(OutputDomain, FaultNodesFollowTheOwnedVerticesAndAreNumberedByPosition)
{
  const auto mesh = test::stripMesh(num_base);
  const OutputDomain fault = boundaryDomain("fault", mesh, "base", world());
  EXPECT_TRUE(fault.isCurve());
  EXPECT_EQ(fault.num_global_nodes, num_base);
  EXPECT_TRUE(std::is_sorted(fault.vertices.begin(), fault.vertices.end()));
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    EXPECT_LT(fault.vertices[i], mesh.num_owned);
    EXPECT_EQ(fault.vertex_ids[i], mesh.global_ids[fault.vertices[i]]);
    EXPECT_EQ(fault.node_numbers[i], num_base - 1 - fault.vertex_ids[i]);
    EXPECT_NEAR(fault.positions[i], fault.coordinates[2 * i], 1e-15);
    EXPECT_EQ(fault.coordinates[2 * i + 1], 0);
  }
}

TEST(OutputDomain, WeightsAddUpToTheMeasure)
{
  const auto mesh = test::stripMesh(num_base);
  const OutputDomain fault = boundaryDomain("fault", mesh, "base", world());
  EXPECT_NEAR(sumOverRanks(fault.weights), 1, 1e-14);
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    const int number = static_cast<int>(fault.node_numbers[i]);
    const double left = test::stripPosition(std::max(0, number - 1), num_base);
    const double right = test::stripPosition(std::min(num_base - 1, number + 1), num_base);
    EXPECT_NEAR(fault.weights[i], (right - left) / 2, 1e-15);
  }
  EXPECT_NEAR(sumOverRanks(volumeDomain(mesh, world()).weights), 1, 1e-14);
}

TEST(OutputDomain, NodesAreNumberedAlongTheCurveOnAnyNumberOfRanks)
{
  const auto mesh = test::stripMesh(num_base);
  const OutputDomain surface =
    boundaryDomain("surface", mesh, "surface", world(), CurveStart::smaller_x);
  EXPECT_EQ(startText(surface), "the end with smaller x (of equal x, with smaller y)");
  const NodeBlocks blocks(surface);
  const auto ofAll = [&](std::vector<double> const& mine, std::size_t components) {
    return joinedInOrder(surface, blocks(mine, 1, components));
  };
  const auto coordinates = ofAll(surface.coordinates, 2);
  const auto positions = ofAll(surface.positions, 1);
  const auto ids = ofAll({surface.vertex_ids.begin(), surface.vertex_ids.end()}, 1);
  if (world()->getRank() > 0) {
    EXPECT_TRUE(coordinates.empty() && ids.empty());
    return;
  }
  ASSERT_EQ(positions.size(), std::size_t(num_base));
  for (int i = 0; i < num_base; ++i) { // begins at the smaller x although facets run against it
    EXPECT_NEAR(positions[i], test::stripPosition(i, num_base), 1e-15);
    EXPECT_EQ(coordinates[2 * i + 1], 1);
    EXPECT_EQ(ids[i], 2 * num_base - 1 - i);
  }
}

TEST(OutputDomain, ElementsAcrossAPeriodAreWhole)
{
  const auto mesh = test::blockMesh(true);
  const OutputDomain fault = boundaryDomain("fault", mesh, "base", world());
  EXPECT_EQ(fault.num_global_nodes, (test::block_nx + 1) * test::block_nz);
  EXPECT_NEAR(sumOverRanks(fault.weights), test::block_nx * test::block_nz, 1e-13);
  const OutputDomain volume = volumeDomain(mesh, world());
  EXPECT_NEAR(sumOverRanks(volume.weights), test::block_nx * test::block_nz, 1e-13);
  double num_wrapping = 0, farthest = 0;
  for (std::size_t i = 0; i < fault.numOwnedElements(); ++i) {
    num_wrapping += fault.wraps[i];
    for (int corner = 0; corner < 3; ++corner) {
      farthest = std::max(farthest, fault.corners[(3 * i + corner) * 3 + 2]);
    }
  }
  EXPECT_EQ(sumOverRanks({num_wrapping}), 2 * test::block_nx);
  EXPECT_EQ(maxOverRanks(farthest, *world()), test::block_nz);
}

TEST(OutputDomain, BlocksHaveRowsAndComponentsInOrder)
{
  const OutputDomain fault = boundaryDomain("fault", test::stripMesh(num_base), "base", world());
  const NodeBlocks blocks(fault);
  std::vector<double> mine;
  for (int row = 0; row < 3; ++row) {
    for (const GlobalOrdinal number : fault.node_numbers) {
      for (int component = 0; component < 2; ++component) {
        mine.push_back(100.0 * row + 10.0 * static_cast<double>(number) + component);
      }
    }
  }
  const auto block = blocks(mine, 3, 2);
  const int count = static_cast<int>(blocks.count()), first = static_cast<int>(blocks.first());
  ASSERT_EQ(block.size(), std::size_t(3 * count * 2));
  for (int i = 0; i < static_cast<int>(block.size()); ++i) {
    const int row = i / (2 * count), node = first + i / 2 % count;
    EXPECT_EQ(block[i], 100.0 * row + 10.0 * node + i % 2);
  }
}

TEST(OutputDomain, RootSeesTheBlocksOfAllRanksInOrder)
{
  const OutputDomain fault = boundaryDomain("fault", test::stripMesh(num_base), "base", world());
  const std::vector<double> numbers(fault.node_numbers.begin(), fault.node_numbers.end());
  const auto block = NodeBlocks(fault)(numbers, 1, 1);
  std::vector<double> seen;
  int calls = 0;
  visitInOrder<double>(block, *world(), [&](std::vector<double> const& next) {
    seen.insert(seen.end(), next.begin(), next.end());
    ++calls;
  });
  if (world()->getRank() > 0) {
    EXPECT_EQ(calls, 0);
    return;
  }
  std::vector<double> expected(num_base);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(calls, world()->getSize());
}

// All ranks throw, none waits, and what comes next arrives.
TEST(OutputDomain, WhatRootCannotUseIsThrownEverywhere)
{
  const std::vector<double> block(3, world()->getRank());
  int calls = 0;
  EXPECT_THROW(visitInOrder<double>(block, *world(),
                                    [&](std::vector<double> const&) {
                                      ++calls;
                                      throw OutputError("The disk is full.");
                                    }),
               OutputError);
  EXPECT_EQ(calls, world()->getRank() == 0 ? 1 : 0);
  double sum = 0;
  visitInOrder<double>(block, *world(), [&](std::vector<double> const& next) { sum += next[2]; });
  const int size = world()->getSize();
  EXPECT_EQ(sum, world()->getRank() == 0 ? size * (size - 1) / 2 : 0);
}

TEST(OutputDomain, UnknownOrEmptyBoundariesAreRefused)
{
  auto mesh = test::stripMesh(num_base);
  mesh.boundaries["left"] = {};
  test::expectRefusal([&] { boundaryDomain("fault", mesh, "bas", world()); },
                      {"no boundary 'bas' to be the fault. Did you mean 'base'?"});
  test::expectRefusal([&] { boundaryDomain("surface", mesh, "left", world()); },
                      {"'left', to be the surface, has no facets"});
}

TEST(OutputDomain, TrianglesOfATetrahedron)
{
  const auto mesh = test::tetrahedron();
  const OutputDomain fault = boundaryDomain("fault", mesh, "base", world());
  EXPECT_FALSE(fault.isCurve());
  EXPECT_TRUE(fault.positions.empty());
  EXPECT_EQ(fault.num_global_nodes, 3);
  EXPECT_NEAR(sumOverRanks(fault.weights), 3, 1e-14);
  EXPECT_NEAR(sumOverRanks(volumeDomain(mesh, world()).weights), 4, 1e-14);
}

TEST(CurveOrder, ClosedAndSeparatePieces)
{
  const std::map<GlobalOrdinal, io::detail::PlanePoint> square{
    {10, {0, 0}}, {11, {1, 0}}, {12, {1, 1}}, {13, {0, 1}}};
  const auto closed = io::detail::orderCurve({{12, 13}, {10, 11}, {13, 10}, {11, 12}}, square,
                                             io::CurveStart::smaller_x);
  EXPECT_EQ(closed.vertex_ids.front(), 10);
  EXPECT_EQ(closed.positions, (std::vector<double>{0, 1, 2, 3}));
  const auto pieces = io::detail::orderCurve({{12, 13}, {10, 11}}, square, // y = 1 and y = 0
                                             io::CurveStart::smaller_x);
  EXPECT_EQ(pieces.vertex_ids, (std::vector<GlobalOrdinal>{10, 11, 13, 12}));
  EXPECT_EQ(pieces.positions, (std::vector<double>{0, 1, 1, 2}));
  const auto from_above =
    io::detail::orderCurve({{12, 13}, {10, 11}}, square, io::CurveStart::upper_end);
  EXPECT_EQ(from_above.vertex_ids, (std::vector<GlobalOrdinal>{13, 12, 10, 11}));
}

// The end with the greater y; of ends equally high but for rounding the one with the smaller x.
TEST(CurveOrder, FaultsBeginAtTheirUpperEnd)
{
  const auto first = [](io::detail::PlanePoint a, io::detail::PlanePoint b) {
    return io::detail::orderCurve({{0, 1}}, {{0, a}, {1, b}}, io::CurveStart::upper_end)
      .vertex_ids.front();
  };
  EXPECT_EQ(first({0, -4e4}, {0, 0}), 1) << "upright";
  EXPECT_EQ(first({0, 0}, {0, -4e4}), 0) << "upright";
  EXPECT_EQ(first({0, -100}, {300, 0}), 1) << "dips to the left";
  EXPECT_EQ(first({0, 0}, {300, -100}), 0) << "dips to the right";
  EXPECT_EQ(first({5, 2}, {-5, 2}), 1) << "level";
  EXPECT_EQ(first({4e4, 1e-12}, {0, 0}), 1) << "level but for rounding";
  EXPECT_EQ(first({25600, 1e-3}, {0, 0}), 1) << "level but for a millimetre in 25.6 km";
  EXPECT_EQ(first({25600, 1}, {0, 0}), 0) << "rises by a metre";
}

// A fault that is gently inclined is not level, however many vertices it has.
TEST(CurveOrder, ManySmallStepsAreARise)
{
  constexpr int count = 20000;
  std::vector<io::detail::Segment> segments;
  std::map<GlobalOrdinal, io::detail::PlanePoint> coordinates;
  for (int i = 0; i < count; ++i) {
    coordinates[i] = {1.0 * i, 1e-4 * i};
    if (i > 0) {
      segments.push_back({i - 1, i});
    }
  }
  EXPECT_EQ(
    io::detail::orderCurve(segments, coordinates, io::CurveStart::upper_end).vertex_ids.front(),
    count - 1);
}

TEST(OutputDomain, KnowsTheBoundariesOfACurve)
{
  auto mesh = test::stripMesh(num_base);
  const double middle = test::stripPosition(2, num_base);
  mesh.boundaries.insert({{"early", {}}, {"late", {}}}); // on every rank
  for (auto const& facet : mesh.boundaries.at("base")) {
    const double x = (mesh.vertices[facet[0]][0] + mesh.vertices[facet[1]][0]) / 2;
    mesh.boundaries[x < middle ? "early" : "late"].push_back(facet);
  }
  const std::vector<std::string> names{"late", "early"};
  OutputDomain fault = boundaryDomain("fault", mesh, mesh::joinBoundaries(mesh, names), world());
  nameParts(fault, mesh, {"base"});
  EXPECT_TRUE(fault.parts.empty() && fault.boundaries.empty());
  EXPECT_EQ(partsText(fault), "");
  nameParts(fault, mesh, names);
  EXPECT_EQ(fault.boundaries, names);
  ASSERT_EQ(fault.node_boundaries.size(), fault.numOwned());
  for (std::size_t i = 0; i < fault.numOwned(); ++i) { // the node between them is of `late`
    EXPECT_EQ(fault.node_boundaries[i], fault.positions[i] < middle - 1e-9 ? 1 : 0);
  }
  ASSERT_EQ(fault.parts.size(), 2u);
  EXPECT_EQ(fault.parts[0].name, "early");
  EXPECT_EQ(fault.parts[0].begin, 0);
  EXPECT_NEAR(fault.parts[0].end, middle, 1e-15);
  EXPECT_EQ(fault.parts[1].name, "late");
  EXPECT_NEAR(fault.parts[1].begin, middle, 1e-15);
  EXPECT_NEAR(fault.parts[1].end, test::stripPosition(num_base - 1, num_base), 1e-15);
  EXPECT_EQ(partAt(fault, middle / 2), "early");
  EXPECT_EQ(partAt(fault, (1 + middle) / 2), "late");
  test::expectParts(startText(fault), {"its upper end", "; early: 0 to ", ", late: ", " m"});
}

TEST(OutputDomain, KnowsTheBoundariesOfASurface)
{
  auto mesh = test::blockMesh();
  const std::vector<std::string> names{"far", "near"};
  mesh.boundaries.insert({{"far", {}}, {"near", {}}});
  for (auto const& facet : mesh.boundaries.at("base")) {
    const bool is_near = mesh::centroid(mesh::corners(mesh, facet))[0] < 1;
    mesh.boundaries[is_near ? "near" : "far"].push_back(facet);
  }
  OutputDomain fault = boundaryDomain("fault", mesh, mesh::joinBoundaries(mesh, names), world());
  nameParts(fault, mesh, names);
  EXPECT_TRUE(fault.parts.empty());
  ASSERT_EQ(fault.node_boundaries.size(), fault.numOwned());
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    EXPECT_EQ(fault.node_boundaries[i], fault.coordinates[3 * i] < 0.5 ? 1 : 0);
  }
  ASSERT_EQ(fault.element_boundaries.size(), fault.numOwnedElements());
  for (std::size_t e = 0; e < fault.numOwnedElements(); ++e) {
    const auto first = fault.corners.begin() + 9 * e;
    const double x = (first[0] + first[3] + first[6]) / 3;
    EXPECT_EQ(fault.element_boundaries[e], x < 1 ? 1 : 0);
  }
}

TEST(CurveOrder, BranchesAreRefused)
{
  const std::map<GlobalOrdinal, io::detail::PlanePoint> star{
    {0, {0, 0}}, {1, {1, 0}}, {2, {0, 1}}, {3, {-1, 0}}};
  test::expectRefusal(
    [&] {
      io::detail::orderCurve({{0, 1}, {0, 2}, {0, 3}}, star, io::CurveStart::upper_end);
    },
    {"branches at x = 0, y = 0 m: 3 segments"});
}
