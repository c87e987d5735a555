// Every field of a state takes part in all that is done to states, also one that a model adds.

#include "base/Views.hpp"
#include "dynamics/control/NotFinite.hpp"
#include "dynamics/control/StepControl.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
std::vector<std::string> namesOf(State const& state)
{
  std::vector<std::string> names;
  State::visitFields([&](FieldInfo const& info, auto const&) { names.push_back(info.name); },
                     state);
  return names;
}

// Fields number 0, 1, ... have the values 1, 2, ... times `factor`.
void count(State& state, double factor)
{
  double value = 0;
  State::visitFields(
    [&](FieldInfo const&, auto const& field) {
      Kokkos::deep_copy(overwritten(field), factor * ++value);
    },
    state);
}

std::vector<double> firstValues(State const& state)
{
  std::vector<double> values;
  State::visitFields(
    [&](FieldInfo const&, auto const& field) { values.push_back(toHost(valuesOf(field))(0)); },
    state);
  return values;
}

class AState : public ::testing::Test
{
protected:
  AState()
  {
    const FieldInfo pressure = {"p", "pressure", "Pa", true};
    state.added.push_back({std::make_shared<const FieldInfo>(pressure),
                           NodeView("asperity::test::p", state.alpha.extent(0))});
    count(state, 1);
  }

  static ModelOptions withOneBranch()
  {
    auto options = slidingBlock(2);
    options.relaxation = {{0.5, 1}};
    return options;
  }

  const Model model{withOneBranch(), fem::test::selfCommunicator()};
  State state = slidingState(model);
};

TEST_F(AState, HasEachFieldOnceAndThoseThatAModelAdds)
{
  auto const names = namesOf(state);
  EXPECT_EQ(names, (std::vector<std::string>{"u", "v", "a", "jerk", "branch_1", "alpha", "sigma_n",
                                             "alpha_of_rate", "alpha_defect", "p"}));
  EXPECT_EQ(firstValues(state), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST_F(AState, IsClonedWithAllFields)
{
  auto const copy = state.clone();
  EXPECT_EQ(namesOf(copy), namesOf(state));
  count(state, 10);
  EXPECT_EQ(firstValues(copy), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST_F(AState, IsBlendedInTheFieldsThatStepsGuess)
{
  auto later = state.clone();
  count(later, 2);
  auto const guess = blend({1.5, later, state}); // 3 - 0.5 times the field's number
  auto const values = firstValues(guess);
  for (const int field : {1, 5, 6, 9}) {
    EXPECT_EQ(values[field], 2.5 * (field + 1));
  }
}

TEST_F(AState, IsSearchedForValuesThatAreNotFinite)
{
  EXPECT_FALSE(firstNotFinite(state));
  const double infinity = std::numeric_limits<double>::infinity();
  State::visitFields(
    [&](FieldInfo const& info, auto const& field) {
      auto const values = overwritten(field);
      Kokkos::deep_copy(values, infinity);
      auto const first = firstNotFinite(state);
      ASSERT_TRUE(first);
      EXPECT_EQ(first->field, info.quantity);
      EXPECT_EQ(first->index, 0);
      EXPECT_EQ(static_cast<bool>(firstNotFiniteAtFault(state)), info.is_guessed);
      Kokkos::deep_copy(values, 0.);
    },
    state);
}
} // namespace
} // namespace asperity::dynamics
