#include "fem/FaultMesh.hpp"

#include "base/parallel/Reductions.hpp"
#include "fem/BodyMatrices.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem
{
using namespace fem::test;

namespace
{
using Place = std::array<double, 3>;

// A boundary of a body as a fault, with its mesh.
template <int Dim>
struct Meshed
{
  Meshed(GlobalMesh<Dim> const& whole, std::string const& boundary, OtherSide side)
      : body(whole, conditions(boundary), Dim == 2 ? 1 : Dim)
  {
    auto const matrices =
      assembleBody<Dim>(body.mesh, body.dofs, body.constraints.frames(),
                        std::vector<Material>(body.mesh.cells.size(), {900, 5e4, 2e4, 1e3, 1e3}));
    surface = makeFaultSurface(body.mesh, boundary, body.constraints, body.dofs,
                               *matrices.stiffness->getCrsGraph(), side);
    mesh = makeFaultMesh(body.mesh, *surface);
  }

  static std::vector<VelocityCondition<Dim>> conditions(std::string const& boundary)
  {
    if constexpr (Dim == 2) { // antiplane
      return {};
    }
    return {{"Fault", boundary, SlidingWall{}}};
  }

  template <class Function>
  std::vector<double> at(Function const& f) const
  {
    std::vector<double> values;
    for (auto const& node : *surface) {
      values.push_back(f(node.place));
    }
    return values;
  }

  // K p, (num_nodes)
  std::vector<double> product(CrsMatrix const& K, std::vector<double> const& p) const
  {
    Vector x(K.getRowMap()), y(K.getRowMap());
    {
      auto const values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < p.size(); ++i) {
        values(i, 0) = p[i];
      }
    }
    K.apply(x, y);
    auto const values = y.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::vector<double> result(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      result[i] = values(i, 0);
    }
    return result;
  }

  Constrained<Dim> body;
  std::shared_ptr<const FaultSurface> surface;
  std::shared_ptr<const FaultMesh> mesh;
};

double sumOf(std::vector<double> const& a, std::vector<double> const& b)
{
  double mine = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mine += a[i] * b[i];
  }
  return asperity::sumOverRanks(mine, *worldCommunicator());
}

// The unit cube, whose top rises by `slope` beyond its middle.
GlobalMesh<3> roofed(double slope)
{
  auto mesh = uniformCube(4);
  for (auto& x : mesh.vertices) {
    x[2] += x[2] * slope * std::max(0., x[0] - 0.5);
  }
  return mesh;
}
} // namespace

TEST(FaultMesh, OfALineHasTheEnergyOfALinearFunction)
{
  const Meshed<2> line(rectangle(0.3), "bottom", OtherSide::rigid_foundation); // 3 m long
  const auto along = [](Place const& x) { return std::cos(0.3) * x[0] + std::sin(0.3) * x[1]; };
  auto const K = line.mesh->stiffness(line.at([&](Place const& x) { return 2 + along(x); }));
  auto const p = line.at([&](Place const& x) { return 5 * along(x) + 7; });
  EXPECT_NEAR(sumOf(p, line.product(*K, p)), 25 * (2 * 3 + 4.5), 1e-10);
  auto const rest = line.product(*K, line.at([](Place const&) { return 1e3; }));
  for (const double value : rest) {
    EXPECT_NEAR(value, 0, 1e-10);
  }
}

TEST(FaultMesh, OfASurfaceHasTheEnergyOfALinearFunction)
{
  const Meshed<3> square(uniformCube(4), "top", OtherSide::rigid_foundation);
  auto const K = square.mesh->stiffness(square.at([](Place const& x) { return 1 + x[0]; }));
  auto const p = square.at([](Place const& x) { return 3 * x[0] - 4 * x[1] + 2 * x[2]; });
  EXPECT_NEAR(sumOf(p, square.product(*K, p)), 25 * 1.5, 1e-12);
}

TEST(FaultMesh, OfAFoldedSurfaceHasGradientsAlongIt)
{
  constexpr double slope = 0.75; // so that the rising half is 5/4 as long as wide
  const Meshed<3> roof(roofed(slope), "top", OtherSide::rigid_foundation);
  auto const p =
    roof.at([](Place const& x) { return std::min(x[0], 0.5) + 1.25 * std::max(0., x[0] - 0.5); });
  auto const K = roof.mesh->stiffness(std::vector<double>(p.size(), 1.));
  EXPECT_NEAR(roof.surface->totalWeight(), 1.125, 1e-13);
  EXPECT_NEAR(sumOf(p, roof.product(*K, p)), 1.125, 1e-13);
}

TEST(FaultMesh, InsideTheBodyHasItsTips)
{
  auto whole = uniformRectangle(6, 4, 3, 2);
  mesh::addFaults<2>(whole, {{"fault", [](Point<2> const& x) {
                                return std::abs(x[1] - 1) < 1e-9 && x[0] > 0.9 && x[0] < 2.1;
                              }}});
  mesh::splitFaults(whole, "test");
  const Meshed<2> inside(whole, "fault", OtherSide::body);
  auto const p = inside.at([](Place const& x) { return x[0]; });
  auto const K = inside.mesh->stiffness(std::vector<double>(p.size(), 2.));
  EXPECT_NEAR(sumOf(p, inside.product(*K, p)), 2 * 1, 1e-12);
}

TEST(FaultMesh, OfALinearFunctionHasItsGradientAtEveryNode)
{
  const auto expect = [](std::vector<double> const& gradient, Place const& all_over) {
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      EXPECT_NEAR(gradient[i], all_over[i % 3], 1e-12);
    }
  };
  const Meshed<2> line(rectangle(0.3), "bottom", OtherSide::rigid_foundation);
  auto const c = std::cos(0.3), s = std::sin(0.3);
  expect(line.mesh->gradient(line.at([&](Place const& x) { return 5 * (c * x[0] + s * x[1]); })),
         {5 * c, 5 * s, 0});
  const Meshed<3> square(uniformCube(4), "top", OtherSide::rigid_foundation);
  expect(
    square.mesh->gradient(square.at([](Place const& x) { return 3 * x[0] - 4 * x[1] + 2 * x[2]; })),
    {3, -4, 0});
}

TEST(FaultMesh, AtAKinkHasTheMeanOfTheGradientsBesideIt)
{
  const Meshed<2> line(rectangle(0), "bottom", OtherSide::rigid_foundation);
  auto const p = line.at([](Place const& x) { return std::abs(x[0] - 1); });
  auto const gradient = line.mesh->gradient(p);
  for (int node = 0; node < line.surface->numNodes(); ++node) {
    const double x = (*line.surface)[node].place[0];
    EXPECT_NEAR(gradient[3 * node], std::abs(x - 1) < 1e-9 ? 0 : (x < 1 ? -1 : 1), 1e-12) << x;
  }
}

TEST(FaultMesh, SharesAPointAmongTheNodesOfItsFacet)
{
  const Meshed<3> square(uniformCube(4), "top", OtherSide::rigid_foundation);
  // Inside a facet, on an edge, at a node, above the surface, and beside it.
  for (Place const& place :
       {Place{0.3, 0.4, 1}, {0.3, 0.25, 1}, {0.5, 0.75, 1}, {0.6, 0.1, 1.2}, {1.3, 0.6, 1.4}}) {
    auto const nearest = square.mesh->nearest(place);
    const Place foot = {std::min(place[0], 1.), place[1], 1};
    double sum = 0, moment_x = 0, moment_y = 0;
    for (auto const& [node, share] : nearest.shares) {
      auto const& x = (*square.surface)[node].place;
      sum += share;
      moment_x += share * x[0];
      moment_y += share * x[1];
    }
    auto const world = worldCommunicator();
    EXPECT_NEAR(asperity::sumOverRanks(sum, *world), 1, 1e-14);
    EXPECT_NEAR(asperity::sumOverRanks(moment_x, *world), foot[0], 1e-14);
    EXPECT_NEAR(asperity::sumOverRanks(moment_y, *world), foot[1], 1e-14);
    EXPECT_NEAR(nearest.distance, std::hypot(place[0] - foot[0], place[2] - 1), 1e-14);
    EXPECT_NEAR(nearest.cell_size, std::sqrt(2.) / 4, 1e-14);
  }
}
} // namespace asperity::fem
