// Unknowns of a step that a test adds from outside: each is one class.

#include "dynamics/coupling/NormalStressUpdate.hpp"
#include "dynamics/coupling/StateUpdate.hpp"
#include "fem/inelastic/CellStrains.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
const DyadicTime milliseconds(4e-3, 4);

// A normal stress that slip of the step takes away, sigma_n = sigma_0 - softening V tau.
class StressThatSlipLowers final : public StepUnknown
{
public:
  static constexpr double sigma_0 = 2000, softening = 2e7; // Pa, Pa/m

  explicit StressThatSlipLowers(int num_nodes) : scale_("scale", num_nodes)
  {
    Kokkos::deep_copy(scale_, 50 / sigma_0);
  }
  NodeView valuesIn(State const& state) const override { return state.sigma_n; }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    for (int node = 0; node < image.extent_int(0); ++node) {
      image(node) = sigma_0 - softening * step.slip_rate(node) * step.tau;
    }
    return 0;
  }
  ConstNodeView scale() const override { return scale_; }

private:
  NodeView scale_;
};

// Strain that bears no stress: the share `softened` of all strain, so that the body has
// 1 - softened of its stiffness.
class SoftenedStrain final : public StepUnknown, private UnknownSpace
{
public:
  static constexpr double softened = 0.2;

  explicit SoftenedStrain(dynamics::test::Model const& model)
      : cells_(*model.body.cells)
      , dofs_(*model.dofs)
      , strains_(fem::makeCellStrains<2>(
          model.mesh, model.constraints->frames(),
          std::vector<fem::Material>(model.mesh.cells.size(), model.options.material),
          cells_.sharing().cells()))
      , local_(dofs_.overlap())
  {
  }

  NodeView valuesIn(State const& state) const override
  {
    return overwritten(state.inelastic->strain);
  }
  FollowsFrom followsFrom() const override { return FollowsFrom::body; }
  UnknownSpace const* space() const override { return this; }
  bool addsForces() const override { return true; }
  void addForces(State const& to, Vector& b) const override
  {
    cells_.addForces(to.inelastic->strain, b);
  }
  int respond(StepIterate const& step, NodeView const& image) override
  {
    ++num_asked;
    dofs_.shareWithGhosts(*step.u_in_body, local_);
    const fem::TensorView strain(image.data(), cells_.numCells(),
                                 image.extent(0) / cells_.numCells());
    strains_->strain(local_, strain);
    for (std::size_t i = 0; i < image.extent(0); ++i) {
      image(i) *= softened;
    }
    return 0;
  }

  int num_asked = 0;

private:
  ConstNodeView weights() const override { return cells_.weights(); }
  RCP<const Communicator> communicator() const override { return cells_.sharing().communicator(); }
  double distance(ConstNodeView const& values, ConstNodeView const& exact, Norm) const override
  {
    constexpr double typical = 1e-4;
    double largest = 0;
    for (std::size_t i = 0; i < values.extent(0); ++i) {
      largest = std::max(largest, std::abs(values(i) - exact(i)) / typical);
    }
    return largest;
  }

  fem::InelasticCells const& cells_;
  fem::DofMap const& dofs_;
  std::unique_ptr<fem::CellStrains> strains_;
  Vector local_;
};

CoupledStep stepWith(dynamics::test::Model const& model, StepUnknownList unknowns)
{
  const StepSettings settings = {RateUpdate::newmark(0.25), milliseconds, tightCoupling(),
                                 tightSettings(), std::size_t(1) << 30};
  return {model.body, model.fault, settings, std::move(unknowns)};
}

dynamics::test::Model softenedAsAWhole()
{
  auto options = slidingBlock(2);
  options.material.bulk_modulus *= 1 - SoftenedStrain::softened;
  options.material.shear_modulus *= 1 - SoftenedStrain::softened;
  return {options, fem::test::selfCommunicator()};
}
} // namespace

TEST(StepUnknown, OnTheFaultMeetsItsLawAtTheEndOfTheStep)
{
  const dynamics::test::Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto step = stepWith(model, {std::make_shared<StateUpdate>(model.fault),
                               std::make_shared<StressThatSlipLowers>(model.surface->numNodes())});
  SolveCount count;
  auto from = slidingState(model);
  for (int level : {2, 1, 3}) {
    auto to = from.clone();
    ASSERT_TRUE(step.solve(from, level, to, count).solved());
    auto const before = denseOf(*from.u), after = denseOf(*to.u);
    for (int node = 0; node < model.surface->numNodes(); ++node) {
      const int dof = (*model.surface)[node].dofs[0];
      const double slip = std::abs(after[dof] - before[dof]);
      const double lowered = StressThatSlipLowers::softening * slip;
      EXPECT_GT(lowered, 1);
      EXPECT_NEAR(to.sigma_n(node), StressThatSlipLowers::sigma_0 - lowered, 1e-7) << node;
    }
    from = to;
  }
  EXPECT_EQ(count.energy_increases, 0);
}

// The body is that of softer rock, whose matrices know it; it is asked less often than the fault.
TEST(StepUnknown, InCellsGivesTheBodyOfSofterRock)
{
  auto options = slidingBlock(2);
  options.yield = "Von Mises"; // so that states have a strain in each cell
  options.strength = {1e9, 0, 0, 1, 1, 0, 0};
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  auto const strain = std::make_shared<SoftenedStrain>(model);
  auto step = stepWith(
    model,
    {std::make_shared<StateUpdate>(model.fault),
     std::make_shared<NormalStressUpdate>(model.body, model.fault, ReactionSinceStart()), strain});
  const auto softer = softenedAsAWhole();
  Stepper expected_step(softer, RateUpdate::newmark(0.25), milliseconds);
  SolveCount count;
  auto from = slidingState(model), expected_from = slidingState(softer);
  for (int level : {2, 1, 3}) {
    auto to = from.clone(), expected = expected_from.clone();
    ASSERT_TRUE(step.solve(from, level, to, count).solved());
    ASSERT_TRUE(
      expected_step.step.solve(expected_from, level, expected, expected_step.count).solved());
    const double size = denseOf(*expected.u).lpNorm<Eigen::Infinity>();
    EXPECT_LE((denseOf(*to.u) - denseOf(*expected.u)).lpNorm<Eigen::Infinity>(), 1e-9 * size);
    EXPECT_LE((denseOf(to.alpha) - denseOf(expected.alpha)).lpNorm<Eigen::Infinity>(), 1e-9);
    from = to;
    expected_from = expected;
  }
  EXPECT_GT(strain->num_asked, 6);
  EXPECT_LT(strain->num_asked, count.rate_problems);
}
} // namespace asperity::dynamics
