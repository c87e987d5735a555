#include "dynamics/checks/FaultResolution.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
namespace
{
const fem::Material crust = {2670, 50e9, 30e9, 0, 0};
const Teuchos::SerialComm<int> one_rank;

// Three places in space, of which the last one strengthens.
FaultPlaces threePlaces()
{
  return {3, fem::OtherSide::body, {{80, 100}, {40, 50}, {1, 1}}, {2, 7, 5}};
}

FrictionOfNodes frictionOfPlaces()
{
  return {{0.01, 0.01, 0.02}, {0.015, 0.015, 0.015}, {0.008, 0.004, 1e-9}, {50e6, 50e6, 50e6}};
}
} // namespace

TEST(FaultResolution, OfPlacesWithoutAMesh)
{
  const auto found =
    faultResolution(threePlaces(), 3, {crust, crust, crust}, frictionOfPlaces(), one_rank);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->smallest_cell, 40);
  EXPECT_EQ(found->largest_cell, 100);
  const double first = 30e9 * 0.008 / (0.015 * 50e6), second = first / 2; // Lambda0
  EXPECT_NEAR(found->cohesive_zone, second, 1e-9 * second);
  EXPECT_NEAR(found->cells_per_zone, first / 100, 1e-9); // second / 50 is as much
  EXPECT_NEAR(found->nucleation_length, 2 / M_PI * 9 * second, 1e-9 * second);
  EXPECT_NEAR(found->unstable_wavelength, 3 * M_PI * second, 1e-9 * second);
  EXPECT_EQ(found->slip_distance, 0.004);
  EXPECT_NEAR(found->crossing_time, 40 / std::sqrt(30e9 / 2670), 1e-9);
  EXPECT_NEAR(found->weakening_length, 3, 1e-12); // the root of 2 + 7
  EXPECT_FALSE(found->weakens_everywhere);
}

TEST(FaultResolution, IsEmptyWhereFrictionStrengthens)
{
  auto strengthening = frictionOfPlaces();
  strengthening.b.assign(3, 0.005);
  EXPECT_FALSE(faultResolution(threePlaces(), 3, {crust, crust, crust}, strengthening, one_rank));
}
} // namespace asperity::dynamics
