#include "dynamics/observables/FaultSample.hpp"

#include "unit/dynamics/SlidingBlock.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
const DyadicTime milliseconds(4e-3, 4);
constexpr Rotation turn = {{{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}};
} // namespace

// The base of a turned block does not move across itself, so that its motion is the slip.
TEST(FaultSample, HasVectorsAlongTheAxesInSpace)
{
  const ModelIn<3> model(slidingBlockInSpace({5, 3, 4}, turn), fem::test::selfCommunicator());
  auto state = slidingState(model, turn);
  auto const start = model.body.vector();
  Tpetra::deep_copy(*start, *state.v);
  state.u->update(3, *state.v, 0);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  balance.start(state);
  FaultSample sample(*model.surface, *start);
  sample.begin(state, 5, balance);

  ASSERT_EQ(sample.numComponents(), 3);
  const NodeView mu("asperity::test::mu", model.surface->numNodes());
  model.fault.friction().coefficient(balance.slipVelocity(), state.alpha_of_rate, mu);
  double fastest = 0;
  for (int i = 0; i < model.surface->numNodes(); ++i) {
    auto const v = model.valueAt(*state.v, model.surface->vertex(i));
    const double V = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    EXPECT_NEAR(sample.slipRate()[i], V, 1e-14 * V);
    fastest = std::max(fastest, model.surface->slides(i) ? V : 0);
    EXPECT_EQ(sample.alpha()[i], state.alpha(i));
    EXPECT_EQ(sample.normalStress()[i], 2000);
    const double strength = 2000 * mu(i) + 20;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(sample.slipVelocity()[3 * i + c], v[c], 1e-14 * V);
      EXPECT_NEAR(sample.slip()[3 * i + c], 2 * v[c], 1e-13 * V);
      if (!model.surface->held(i, 0) && !model.surface->held(i, 1)) {
        EXPECT_NEAR(sample.traction()[3 * i + c], strength * v[c] / V, 1e-12 * strength);
      }
    }
  }
  EXPECT_NEAR(sample.peakSlipRate(), fastest, 1e-14 * fastest);
}

TEST(FaultSample, KeepsWhatItHasReadUntilTheNextStep)
{
  const dynamics::test::Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto state = slidingState(model);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  balance.start(state);
  FaultSample sample(*model.surface, *state.u);
  sample.begin(state, 0, balance);
  auto const rates = sample.slipRate();
  ASSERT_EQ(sample.numComponents(), 1);
  EXPECT_EQ(sample.slip(), std::vector<double>(rates.size(), 0));
  state.u->update(1, *state.v, 1);
  state.v->scale(2);
  balance.advance(state);
  EXPECT_EQ(sample.slip(), std::vector<double>(rates.size(), 0));
  EXPECT_EQ(sample.slipRate(), rates);
  sample.begin(state, 0, balance);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    EXPECT_EQ(std::abs(sample.slip()[i]), rates[i]);
    EXPECT_EQ(sample.slipRate()[i], 2 * rates[i]);
  }
}
} // namespace asperity::dynamics
