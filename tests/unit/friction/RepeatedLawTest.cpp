// A program of its own: after a mistake in a registration the registry is of no use.
#include "friction/Registration.hpp"
#include "friction/Registry.hpp"
#include "friction/laws/AgeingLaw.hpp"

#include <gtest/gtest.h>

#include <algorithm>

ASPERITY_REGISTER_STATE_LAW(asperity::friction::AgeingLaw) // the package has one of this name

namespace asperity::friction
{
TEST(RepeatedLaw, IsNamedAndMakesTheRegistryUnusable)
{
  const auto all = stateLaws().registrations();
  EXPECT_EQ(std::count(all.begin(), all.end(), "state law 'Ageing'"), 2);
  EXPECT_EQ(std::count(all.begin(), all.end(), "state law 'Slip'"), 1);
  EXPECT_THROW(stateLaws().names(), std::logic_error);
  EXPECT_THROW(stateLaws().at("Slip"), std::logic_error);
  EXPECT_EQ(frictionLaws().names().size(), 5u);
}
} // namespace asperity::friction
