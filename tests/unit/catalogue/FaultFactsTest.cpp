#include "catalogue/FaultFacts.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/io/Support.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::catalogue;
using test::world;

namespace
{
using Numbers = std::vector<double>;

io::Facts factsOf(Mesh<2> const& mesh, bool is_foot_wall = false)
{
  auto fault = io::boundaryDomain("fault", mesh, "base", world());
  fault.is_foot_wall = is_foot_wall;
  return faultFacts(fault, {0, 1, 0});
}
} // namespace

TEST(FaultFacts, AMapHasNoThrusts)
{
  const auto facts = factsOf(test::stripMesh(5)); // segments of x = 0, 1/16, 1/4, 9/16, 1
  EXPECT_EQ(facts.at("level"), Numbers{1});
  EXPECT_EQ(facts.at("thrust_sign"), Numbers{1});
  EXPECT_NEAR(facts.at("element_size").front(), 1.0 / 16, 1e-15);
  EXPECT_EQ(facts.count("strike"), 0u);
}

// A fault that dips to the right, its hanging wall there: its tangent points down dip.
TEST(FaultFacts, InASectionSlipOfThrustsHasASign)
{
  EXPECT_EQ(factsOf(test::dippingStrip(6)).at("level"), Numbers{0});
  EXPECT_EQ(factsOf(test::dippingStrip(6)).at("thrust_sign"), Numbers{-1});
  EXPECT_EQ(factsOf(test::dippingStrip(6), true).at("thrust_sign"), Numbers{1});
}

// x = 0, y from 0 down to -4, the body in x > 0: strike is z.
TEST(FaultFacts, InSpaceDirectionsAreThoseOfThePlane)
{
  const auto mesh = test::blockMesh(false, [](Point<3> const& x) {
    return Point<3>{x[1], 0 - x[0], x[2]};
  });
  const auto facts = faultFacts(io::boundaryDomain("fault", mesh, "base", world()), {0, 2, 0});
  for (auto const& [name, expected] : {std::pair("strike", Numbers{0, 0, 1}),
                                       {"dip", Numbers{0, -1, 0}},
                                       {"down", Numbers{0, -1, 0}},
                                       {"inward", Numbers{1, 0, 0}},
                                       {"top", Numbers{0}}}) {
    auto const& found = facts.at(name);
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 1e-15) << name;
    }
  }
  EXPECT_EQ(facts.count("level"), 0u);
}
