#include "fem/motions/BodyPieces.hpp"

#include "SampleMeshes.hpp"

#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"

#include <cmath>
#include <functional>

using namespace asperity;
using namespace asperity::fem;

namespace
{
// The second mesh beside the first; vertices at one place are one if `joined`.
template <int Dim>
GlobalMesh<Dim> both(GlobalMesh<Dim> mesh, GlobalMesh<Dim> const& other, bool joined)
{
  std::vector<int> number;
  for (auto const& x : other.vertices) {
    const auto found = std::find(mesh.vertices.begin(), mesh.vertices.end(), x);
    const bool is_known = joined && found != mesh.vertices.end();
    number.push_back(static_cast<int>(is_known ? found - mesh.vertices.begin()
                                               : mesh.vertices.end() - mesh.vertices.begin()));
    if (!is_known) {
      mesh.vertices.push_back(x);
    }
  }
  for (auto cell : other.cells) {
    for (int& vertex : cell) {
      vertex = number[vertex];
    }
    mesh.cells.push_back(cell);
    mesh.cell_regions.push_back(0);
  }
  mesh.boundaries.clear();
  return mesh;
}

GlobalMesh<2> rectangleAt(double x, double y) { return mesh::rectangleMesh({1, 1, 4, 4, {x, y}}); }

GlobalMesh<3> boxAt(double x, double y, double z)
{
  return mesh::boxMesh({{1, 1, 1}, {2, 2, 2}, {x, y, z}});
}

template <int Dim>
BodyPieces<Dim> piecesOf(GlobalMesh<Dim> const& whole)
{
  const auto world = fem::test::worldCommunicator();
  return bodyPieces(mesh::distribute(whole, *world), world);
}

template <int Dim>
void expectPieces(GlobalMesh<Dim> const& whole, GlobalOrdinal num_pieces, GlobalOrdinal num_pinched)
{
  const auto pieces = piecesOf(whole);
  EXPECT_EQ(pieces.num_pieces, num_pieces);
  EXPECT_EQ(pieces.num_pinched, num_pinched);
  EXPECT_EQ(pieces.first_pinched >= 0, num_pinched > 0);
}

template <int Dim>
GlobalMesh<Dim> cut(GlobalMesh<Dim> mesh, std::function<bool(Point<Dim> const&)> const& where)
{
  mesh::addFaults<Dim>(mesh, {{"fault", where}});
  mesh::splitFaults(mesh, "test");
  return mesh;
}
} // namespace

TEST(BodyPieces, OneBodyIsOnePiece)
{
  expectPieces(rectangleAt(0, 0), 1, 0);
  expectPieces(boxAt(0, 0, 0), 1, 0);
  expectPieces(mesh::rectangleMesh({30, 1, 60, 2, {0, 0}}), 1, 0);
}

TEST(BodyPieces, PiecesApart)
{
  expectPieces(both(rectangleAt(0, 0), rectangleAt(2, 0), true), 2, 0);
  expectPieces(both(boxAt(0, 0, 0), boxAt(0, 3, 0), true), 2, 0);
  // Side by side, but no vertex in common.
  expectPieces(both(rectangleAt(0, 0), rectangleAt(1, 0), false), 2, 0);
}

TEST(BodyPieces, ABowTieInThePlane)
{
  const auto pieces = piecesOf(both(rectangleAt(0, 0), rectangleAt(1, 1), true));
  EXPECT_EQ(pieces.num_pieces, 2);
  EXPECT_EQ(pieces.num_pinched, 1);
  EXPECT_EQ(pieces.first_pinched, 24); // the last vertex of the first square
  EXPECT_EQ(pieces.place, (Point<2>{1, 1}));
}

TEST(BodyPieces, BoxesThatShareAVertexOrAnEdge)
{
  expectPieces(both(boxAt(0, 0, 0), boxAt(1, 1, 1), true), 2, 1);
  expectPieces(both(boxAt(0, 0, 0), boxAt(1, 1, 0), true), 2, 3);
}

TEST(BodyPieces, APieceThatTouchesItself)
{
  auto ring = both(rectangleAt(0, 0), rectangleAt(1, 0), true);
  ring = both(ring, rectangleAt(2, 1), true);
  ring = both(ring, rectangleAt(1, 1), true);
  expectPieces(ring, 1, 0);
  auto open = both(rectangleAt(0, 0), rectangleAt(1, 0), true);
  open = both(open, rectangleAt(0, 1), true);
  open = both(open, rectangleAt(0, 2), true);
  open = both(open, rectangleAt(1, 2), true);
  open = both(open, rectangleAt(2, 1), true);
  expectPieces(open, 2, 2); // (2, 1) and (2, 2)
}

TEST(BodyPieces, TheSidesOfAFaultAreOne)
{
  const auto middle = [](auto const& x) { return std::abs(x[1] - 0.5) < 1e-9; };
  expectPieces(cut<2>(rectangleAt(0, 0), middle), 1, 0);
  expectPieces(cut<3>(boxAt(0, 0, 0), middle), 1, 0);
  const auto inside = [](auto const& x) { return std::abs(x[1] - 0.5) < 1e-9 && x[0] > 0.2; };
  expectPieces(cut<2>(rectangleAt(0, 0), inside), 1, 0);
}

TEST(BodyPieces, AFaultThatBranchesOffAnotherOne)
{
  const auto level = [](auto const& x) { return std::abs(x[1] - 0.5) < 1e-9; };
  const auto branch = [](auto const& x) {
    return std::abs(x[0] - 0.5) < 1e-9 && x[1] > 0.5 - 1e-9;
  };
  const auto branched = [&](auto mesh) {
    mesh::addFaults(mesh, {{"level", level}, {"branch", branch}});
    mesh::splitFaults(mesh, "test");
    return mesh;
  };
  expectPieces(branched(rectangleAt(0, 0)), 1, 0);
  expectPieces(branched(boxAt(0, 0, 0)), 1, 0);
}

TEST(BodyPieces, WarningsNameVertexAndPieces)
{
  const auto world = fem::test::worldCommunicator();
  const auto warnings = [world](GlobalMesh<2> const& whole) {
    return warnOfPieces(mesh::distribute(whole, *world), world);
  };
  EXPECT_TRUE(warnings(rectangleAt(0, 0)).empty());
  const auto bow_tie = warnings(both(rectangleAt(0, 0), rectangleAt(1, 1), true));
  ASSERT_EQ(bow_tie.size(), 2U);
  asperity::test::expectParts(bow_tie[0].text, {"at 1 vertex", "vertex 24 at (1, 1)"});
  asperity::test::expectParts(bow_tie[1].text, {"2 pieces"});
}
