#include "RefinementSamples.hpp"

#include "mesh/MeetingFaults.hpp"

#include "unit/mesh/RandomFaults.hpp"

using namespace asperity;
using namespace asperity::refinement;
using namespace asperity::refinement::test;

namespace
{
// A vertex by its place and by what it is: 0 an ordinary one, or a sum of 1 for the minus of a
// pair, 2 for the plus of one, 4 for a tip, 8 for a joint.
template <int Dim>
using Copy = std::pair<Point<Dim>, int>;

template <int Dim>
std::vector<Copy<Dim>> copies(GlobalMesh<Dim> const& mesh)
{
  std::vector<Copy<Dim>> result;
  for (auto const& point : mesh.vertices) {
    result.push_back({point, 0});
  }
  for (auto const& [plus, minus, is_tip, is_joint] : mesh.splits) {
    result[plus].second += is_tip ? 6 : is_joint ? 10 : 2;
    result[minus].second += is_tip ? 0 : 1;
  }
  return result;
}

template <class Simplex, class OneCopy>
std::multiset<std::vector<OneCopy>> ofCopies(std::vector<Simplex> const& simplices,
                                             std::vector<OneCopy> const& copies)
{
  std::multiset<std::vector<OneCopy>> result;
  for (auto const& simplex : simplices) {
    std::vector<OneCopy> places;
    places.reserve(simplex.size());
    for (int vertex : simplex) {
      places.push_back(copies[vertex]);
    }
    std::sort(places.begin(), places.end());
    result.insert(places);
  }
  return result;
}

template <int Dim>
std::multiset<std::vector<Copy<Dim>>> pairsOf(GlobalMesh<Dim> const& mesh)
{
  std::vector<std::array<int, 2>> pairs;
  for (auto const& pair : mesh.splits) {
    pairs.push_back({pair.plus, pair.minus});
  }
  return ofCopies(pairs, copies(mesh));
}

// The places of crossings, with the names of their faults.
template <int Dim>
std::set<std::pair<Point<Dim>, std::array<std::string, 2>>> crossingsAt(GlobalMesh<Dim> const& mesh)
{
  std::set<std::pair<Point<Dim>, std::array<std::string, 2>>> result;
  for (auto const& [place, faults] : mesh::namedCrossings(mesh)) {
    result.insert({place, faults});
  }
  return result;
}

// The same cells on the same sides of the same faults, whatever the numbers.
template <int Dim>
void expectSameSplit(GlobalMesh<Dim> const& refined, GlobalMesh<Dim> const& made)
{
  EXPECT_EQ(refined.vertices.size(), made.vertices.size());
  EXPECT_EQ(refined.splits.size(), made.splits.size());
  EXPECT_TRUE(pairsOf(refined) == pairsOf(made));
  EXPECT_TRUE(ofCopies(refined.cells, copies(refined)) == ofCopies(made.cells, copies(made)));
  EXPECT_EQ(refined.faults, made.faults);
  EXPECT_EQ(crossingsAt(refined), crossingsAt(made));
  for (auto const& [name, facets] : made.boundaries) {
    EXPECT_TRUE(ofCopies(refined.boundaries.at(name), copies(refined)) ==
                ofCopies(facets, copies(made)))
      << name;
    expectNear(integralOfNormal(refined, name), integralOfNormal(made, name), 1e-12, name);
  }
}

template <int Dim>
void expectGoodParts(GlobalMesh<Dim> const& coarse, int refinements)
{
  const auto fine = wholeRefined(coarse, refinements);
  checkMesh(fine, "test");
  expectPartOf(fine, refined(coarse, refinements));
}

GlobalMesh<3> boxWith(Conditions<3> const& faults, int cells)
{
  auto mesh = boxMesh({{4, 4, 4}, {cells, cells, cells}, {0, -2, 0}});
  addFaults(mesh, faults);
  return split(mesh);
}

// Refined after the split, and split after the refinement: all comes to the same.
void expectGoodRefinement(Conditions<3> const& faults)
{
  const auto coarse = boxWith(faults, 4);
  expectSameSplit(wholeRefined(coarse, 1), boxWith(faults, 8));
  expectGoodParts(coarse, 1);
  expectGoodParts(coarse, 2);
}

// Squares of two triangles with parallel diagonals, which stay so when they are refined.
GlobalMesh<2> slanted(Conditions<2> const& faults, int cells, BranchEnd branch_end = BranchEnd::tip)
{
  auto mesh = rectangleMesh({4, 4, cells, cells, {0, -2}});
  mesh.cells.clear();
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, d = a + cells + 1;
      mesh.cells.push_back({a, a + 1, d + 1});
      mesh.cells.push_back({a, d + 1, d});
    }
  }
  addFaults(mesh, faults);
  splitFaults(mesh, "test", branch_end);
  return mesh;
}

template <int Dim>
bool canSplit(GlobalMesh<Dim>& mesh, BranchEnd branch_end)
{
  try {
    splitFaults(mesh, "test", branch_end);
  } catch (InputError const&) {
    return false;
  }
  return true;
}

// How many of the meshes can be split before the refinement and afterwards, and both come to the
// same. A mesh that cannot be split afterwards is refused before.
template <int Dim>
int numRefined(GlobalMesh<Dim> const& mesh, int num_trials, BranchEnd branch_end)
{
  std::mt19937 random(1);
  int num_refined = 0;
  for (int trial = 0; trial < num_trials; ++trial) {
    SCOPED_TRACE(trial);
    const auto faulted = withRandomFaults(mesh, random);
    auto coarse = faulted;
    if (!canSplit(coarse, branch_end)) {
      continue;
    }
    auto made = wholeRefined(faulted, 1);
    if (!canSplit(made, branch_end)) {
      EXPECT_THROW(refined(coarse, 1), InputError);
      continue;
    }
    GlobalMesh<Dim> fine;
    try {
      fine = wholeRefined(coarse, 1);
    } catch (InputError const& error) { // the edges of cells do not tell the copies apart
      asperity::test::expectParts(error.what(), {"between two tips", "before it is split"});
      continue;
    }
    expectSameSplit(fine, made);
    expectGoodParts(coarse, 1);
    ++num_refined;
  }
  return num_refined;
}
} // namespace

TEST(FaultRefinement, OfBranchesInThePlane)
{
  const auto coarse = slanted(branchInThePlane(), 4);
  expectSameSplit(wholeRefined(coarse, 1), slanted(branchInThePlane(), 8));
  expectSameSplit(wholeRefined(coarse, 2), slanted(branchInThePlane(), 16));
  expectGoodParts(coarse, 1);
  expectGoodParts(coarse, 3);
}

// Those of antiplane models, on one side and on both sides of a fault, also from one joint to
// another by a single facet.
TEST(FaultRefinement, OfJointsInThePlane)
{
  const auto is_main = [](auto& p) { return p[1] == 0.0; };
  for (auto const& faults :
       {branchInThePlane(),
        Conditions<2>{{"below", [](auto& p) { return p[0] == 2.0 && p[1] <= 0.0; }},
                      {"main", is_main},
                      {"splay", [](auto& p) { return p[0] == p[1] + 2.0 && p[1] >= 0.0; }}},
        Conditions<2>{{"link", [](auto& p) { return p[0] == 2.0 && p[1] >= 0.0 && p[1] <= 1.0; }},
                      {"main", is_main},
                      {"upper", [](auto& p) { return p[1] == 1.0; }}}}) {
    const auto coarse = slanted(faults, 4, BranchEnd::joint);
    EXPECT_GE(jointsOf(coarse.splits).size(), 1u);
    expectSameSplit(wholeRefined(coarse, 1), slanted(faults, 8, BranchEnd::joint));
    expectGoodParts(coarse, 1);
    expectGoodParts(coarse, 2);
  }
}

// Two faults that cross a third one, at facets that have a crossing at each end.
TEST(FaultRefinement, OfCrossings)
{
  const Conditions<2> faults = {{"first", [](auto& p) { return p[0] == 2.0; }},
                                {"main", [](auto& p) { return p[1] == 0.0 && p[0] >= 1.0; }},
                                {"second", [](auto& p) { return p[0] == 3.0 && p[1] >= -1.0; }}};
  const auto coarse = slanted(faults, 4);
  ASSERT_EQ(crossingsAt(coarse).size(), 2u);
  expectSameSplit(wholeRefined(coarse, 1), slanted(faults, 8));
  expectSameSplit(wholeRefined(coarse, 2), slanted(faults, 16));
  expectGoodParts(coarse, 1);
  expectGoodParts(coarse, 3);
}

// Names that continue each other across a fault, and branches on both sides of it.
TEST(FaultRefinement, OfJointsOfNames)
{
  const auto faults = [](auto const& is_west) {
    return Conditions<2>{{"dyke", [](auto& p) { return p[0] == 2.0; }},
                         {"east", [](auto& p) { return p[1] == 0.0 && p[0] >= 2.0; }},
                         {"west", is_west}};
  };
  const auto straight = faults([](auto& p) { return p[1] == 0.0 && p[0] <= 2.0; });
  const auto bent = faults([](auto& p) { return p[1] == p[0] - 2.0 && p[0] <= 2.0; });
  EXPECT_EQ(crossingsAt(slanted(straight, 4)).size(), 1u);
  EXPECT_EQ(crossingsAt(slanted(bent, 4)).size(), 0u);
  for (auto const& conditions : {straight, bent}) {
    const auto coarse = slanted(conditions, 4);
    expectSameSplit(wholeRefined(coarse, 1), slanted(conditions, 8));
    expectGoodParts(coarse, 1);
    expectGoodParts(coarse, 2);
  }
}

// A piece of one facet, which has two tips and no node that slips before it is refined.
TEST(FaultRefinement, OfASingleFacet)
{
  const Conditions<2> faults = {
    {"main", [](auto& p) { return p[1] == 0.0 && ((p[0] >= 0.0 && p[0] <= 2.0) || p[0] >= 3.0); }},
    {"upper",
     [](auto& p) { return p[1] == 1.0 && (p[0] <= 1.0 || (p[0] >= 2.0 && p[0] <= 3.0)); }}};
  const auto coarse = slanted(faults, 4);
  expectSameSplit(wholeRefined(coarse, 1), slanted(faults, 8));
  expectGoodParts(coarse, 1);
  expectGoodParts(coarse, 2);
}

TEST(FaultRefinement, OfBranchesInSpace)
{
  EXPECT_GT(jointsOf(boxWith(branchInSpace(), 4).splits).size(), 0u);
  expectGoodRefinement(branchInSpace());
}

// The line is one edge, at both of whose ends the branch has tips: its midpoint is a joint.
TEST(FaultRefinement, OfAJointAtOneEdge)
{
  const Conditions<3> faults = {{"main", [](auto& p) { return p[1] == 0.0; }},
                                {"splay", [](auto& p) {
                                   return p[0] == 2.0 && p[1] >= 0.0 &&
                                          (p[1] >= 1.0 || (p[2] >= 1.0 && p[2] <= 2.0));
                                 }}};
  EXPECT_TRUE(jointsOf(boxWith(faults, 4).splits).empty());
  EXPECT_FALSE(jointsOf(wholeRefined(boxWith(faults, 4), 1).splits).empty());
  expectGoodParts(boxWith(faults, 4), 2);
}

// Branches on both sides of a fault, on its minus side with a short one. The centres of the oblique
// facets have rounding errors.
TEST(FaultRefinement, OfJointsOnBothSides)
{
  const auto is_oblique = [](auto& p) { return std::abs(p[1] - p[0] + 2.0) < 1e-9; };
  const Conditions<3> faults = {
    {"above", [](auto& p) { return p[0] == 2.0 && p[1] >= 0.0; }},
    {"below", [=](auto& p) { return is_oblique(p) && p[1] <= 0.0 && p[2] <= 2.0; }},
    {"main", [](auto& p) { return p[1] == 0.0; }}};
  std::set<bool> sides;
  for (auto const& joint : jointsOf(boxWith(faults, 4).splits)) {
    sides.insert(joint.is_on_plus_side);
  }
  EXPECT_EQ(sides.size(), 2u);
  expectGoodRefinement(faults);
}

// The joints' line leads on the minus side of the main fault from a tip of both faults to one of
// the branch: its midpoint has a larger number for the joint than for the plus of the main fault.
TEST(FaultRefinement, OfAJointFromATipOfBothFaults)
{
  const Conditions<3> faults = {{"main", [](auto& p) { return p[1] == 0.0 && p[2] >= 1.0; }},
                                {"splay", [](auto& p) {
                                   return p[0] == 2.0 && p[2] >= 1.0 &&
                                          ((p[1] <= 0.0 && p[2] <= 2.0) || p[1] <= -1.0);
                                 }}};
  EXPECT_TRUE(jointsOf(boxWith(faults, 4).splits).empty());
  const auto joints = jointsOf(wholeRefined(boxWith(faults, 4), 1).splits);
  ASSERT_EQ(joints.size(), 1u);
  EXPECT_FALSE(joints[0].is_on_plus_side);
  EXPECT_GT(joints[0].plus, joints[0].main);
  expectGoodRefinement(faults);
}

TEST(FaultRefinement, OfAFaultInsideTheBody) { expectGoodRefinement(buried()); }

TEST(FaultRefinement, OfAFaultThroughTheBody)
{
  expectGoodRefinement({{"main", [](auto& p) { return p[1] == 0.0; }}});
}

TEST(FaultRefinement, OfFaultsThatContinueEachOther)
{
  expectGoodRefinement(
    {{"shallow", [](auto& p) { return p[1] == 0.0 && p[2] >= 2.0 && p[0] >= 1.0 && p[0] <= 3.0; }},
     {"deep", [](auto& p) { return p[1] == 0.0 && p[2] <= 2.0 && p[2] >= 1.0 && p[0] >= 1.0; }}});
}

// The line ends on the surface, at a tip of one fault, at one of both, or below at a tip of one and
// above at one of the other.
TEST(FaultRefinement, OfCrossingsInSpace)
{
  const auto is_dyke = [](auto& p) { return p[0] == 2.0; };
  const auto is_deep = [](auto& p) { return p[0] == 2.0 && p[2] >= 1.0; };
  const auto is_short = [](auto& p) { return p[0] == 2.0 && p[2] >= 1.0 && p[2] <= 3.0; };
  const auto is_main = [](auto& p) { return p[1] == 0.0; };
  const auto is_short_main = [](auto& p) { return p[1] == 0.0 && p[2] >= 1.0 && p[2] <= 3.0; };
  for (auto const& faults : {Conditions<3>{{"dyke", is_dyke}, {"main", is_main}},
                             Conditions<3>{{"dyke", is_deep}, {"main", is_main}},
                             Conditions<3>{{"dyke", is_short}, {"main", is_short_main}},
                             Conditions<3>{{"dyke", is_deep}, {"main", [](auto& p) {
                                                                 return p[1] == 0.0 && p[2] <= 3.0;
                                                               }}}}) {
    EXPECT_GE(crossingsAt(boxWith(faults, 4)).size(), 1u);
    expectGoodRefinement(faults);
  }
}

// A branch below z = 2, a crossing above.
TEST(FaultRefinement, OfACrossingThatBecomesABranch)
{
  expectGoodRefinement(
    {{"dyke", [](auto& p) { return p[0] == 2.0 && (p[1] >= 0.0 || p[2] >= 2.0); }},
     {"main", [](auto& p) { return p[1] == 0.0; }}});
}

// The line of the crossing is one edge, at both of whose ends the dyke has tips.
TEST(FaultRefinement, RefusesACrossingAtOneEdge)
{
  const auto coarse =
    boxWith({{"dyke",
              [](auto& p) {
                return p[0] == 2.0 && (std::abs(p[1]) >= 1.0 || (p[2] >= 1.0 && p[2] <= 2.0));
              }},
             {"main", [](auto& p) { return p[1] == 0.0; }}},
            4);
  EXPECT_TRUE(crossingsAt(coarse).empty());
  asperity::test::expectRefusal([&] { refined(coarse, 1); },
                                {"fault 'dyke' meets itself or another one between two tips",
                                 "(2, 0, 1.5)", "before it is split"});
}

// A fault whose trace on the surface is a single edge.
TEST(FaultRefinement, OfANeckBelowTheSurface)
{
  expectGoodRefinement({{"main", [](auto& p) {
                           return p[1] == 0.0 && p[0] >= 1.0 && p[2] >= 1.0 &&
                                  p[0] <= (p[2] > 3.0 ? 2.0 : 3.0);
                         }}});
}

// Two routes to one mesh: the coarse mesh is split and refined, or refined and then split.
TEST(FaultRefinement, OfRandomFaultsInThePlane)
{
  const auto mesh = rectangleMesh({4.0, 4.0, 4, 4, {0.0, 0.0}});
  EXPECT_GT(numRefined(mesh, 300, BranchEnd::tip), 100);
  EXPECT_GT(numRefined(mesh, 300, BranchEnd::joint), 100);
}

TEST(FaultRefinement, OfRandomFaultsInSpace)
{
  EXPECT_GT(numRefined(unitBox(3), 300, BranchEnd::joint), 40);
}
