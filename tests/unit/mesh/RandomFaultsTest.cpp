#include "RandomFaults.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
// How many of the meshes can be split; the others are refused with one message.
template <int Dim>
int numSplit(GlobalMesh<Dim> const& mesh, int num_trials, BranchEnd branch_end)
{
  std::mt19937 random(1);
  int num_split = 0;
  for (int trial = 0; trial < num_trials; ++trial) {
    const auto faulted = withRandomFaults(mesh, random);
    auto result = faulted;
    try {
      splitFaults(result, "Here", branch_end);
    } catch (InputError const& error) {
      EXPECT_EQ(std::string(error.what()).rfind("Here: ", 0), 0u);
      continue;
    }
    SCOPED_TRACE(trial);
    expectGoodSplit(faulted, result);
    expectSidesOfFacets(result);
    ++num_split;
  }
  return num_split;
}
} // namespace

// Whatever is not refused is a good split.
TEST(RandomFaults, InThePlane)
{
  const auto mesh = rectangleMesh({4.0, 4.0, 4, 4, {0.0, 0.0}});
  EXPECT_GT(numSplit(mesh, 2000, BranchEnd::tip), 500);
  EXPECT_GT(numSplit(mesh, 2000, BranchEnd::joint), 500);
}

TEST(RandomFaults, InSpace)
{
  const auto mesh = boxMesh({{3.0, 3.0, 3.0}, {3, 3, 3}, {0.0, 0.0, 0.0}});
  EXPECT_GT(numSplit(mesh, 2000, BranchEnd::tip), 250);
  EXPECT_GT(numSplit(mesh, 2000, BranchEnd::joint), 250);
}
