#include "friction/Registry.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace asperity::friction::test
{
namespace
{
using Names = std::vector<std::string>;

Names parameterNames(std::vector<Parameter> const& parameters)
{
  Names names;
  for (auto const& parameter : parameters) {
    names.push_back(parameter.name);
  }
  return names;
}

template <class Call>
std::string messageOfOutOfRange(Call const& call)
{
  try {
    call();
  } catch (std::out_of_range const& error) {
    return error.what();
  }
  return "";
}

TEST(Registry, HoldsTheLawsOfThisPackage)
{
  EXPECT_EQ(frictionLaws().names(),
            (Names{"Cut-Off", "None", "Regularised", "Slip Weakening", "Truncated"}));
  EXPECT_EQ(stateLaws().names(), (Names{"Ageing", "Flash Heating", "None", "Slip", "Slip Weakening",
                                        "Strong Rate Weakening", "Tabulated"}));
}

TEST(Registry, HasATableOfParametersForEachLaw)
{
  for (auto const& name : {"Regularised", "Truncated"}) {
    EXPECT_EQ(parameterNames(frictionLaws().at(name).parameters),
              (Names{"a", "b", "Reference Slip Rate", "Reference Friction Coefficient"}));
  }
  for (auto const& name : {"Ageing", "Slip"}) {
    EXPECT_EQ(parameterNames(stateLaws().at(name).parameters),
              (Names{"L", "Reference Slip Rate", "c"}));
  }
  auto const& a = frictionLaws().at("Truncated").parameters[0];
  EXPECT_TRUE(a.required());
  EXPECT_EQ(a.range.lower(), 0);
  EXPECT_FALSE(a.range.hasLower());
  auto const& b = frictionLaws().at("Truncated").parameters[1];
  EXPECT_EQ(b.range.lower(), 0);
  EXPECT_TRUE(b.range.hasLower());
  EXPECT_EQ(b.range.upper(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(b.range.hasUpper());
}

TEST(Registry, KnowsWhatTheLawsSayOfThemselves)
{
  const double effects[] = {0.01, 0.015, 1e-6, 0.6}, state[] = {0.02, 1e-5};
  for (auto const& name : {"Regularised", "Truncated"}) {
    const auto sensitivity = frictionLaws().at(name).sensitivity(effects);
    EXPECT_EQ(sensitivity.slip_rate, 0.01);
    EXPECT_EQ(sensitivity.state, 0.015);
    EXPECT_NE(std::string(frictionLaws().at(name).parameters[0].hint).find("typical"),
              std::string::npos);
  }
  for (auto const& name : {"Ageing", "Slip"}) {
    EXPECT_EQ(stateLaws().at(name).slip_distance(state), 0.02);
    EXPECT_DOUBLE_EQ(stateLaws().at(name).theta_scale(state), 2000);
  }
  const double coefficients[] = {0.7, 0.5};
  EXPECT_DOUBLE_EQ(frictionLaws().at("Slip Weakening").strength_drop(coefficients), 0.2);
  EXPECT_FALSE(frictionLaws().at("Slip Weakening").sensitivity);
  EXPECT_EQ(stateLaws().registrations()[0], "state law 'Ageing'");
}

TEST(Registry, KnowsWhichStateALawDependsOn)
{
  for (auto const& friction : frictionLaws().names()) {
    for (auto const& state : stateLaws().names()) {
      const auto only = [&](char const* law) { return (friction == law) == (state == law); };
      const bool both_or_none = only("Slip Weakening") && only("None");
      EXPECT_EQ(std::string(frictionLaws().at(friction).state_variable) ==
                  stateLaws().at(state).state_variable,
                both_or_none)
        << friction << ' ' << state;
    }
  }
}

TEST(Registry, NamesTheKnownLawsWhereOneIsUnknown)
{
  const ParameterView none;
  for (auto const& message :
       {messageOfOutOfRange([] { frictionLaws().at("Regularized").parameters; }),
        messageOfOutOfRange([] { makeFrictionKernels("Regularized", FaultView()); })}) {
    EXPECT_EQ(message, "'Regularized' is not a known friction law. Choose one of 'Cut-Off', "
                       "'None', 'Regularised', 'Slip Weakening', 'Truncated'.");
  }
  for (auto const& message : {messageOfOutOfRange([] { stateLaws().at("Aging").parameters; }),
                              messageOfOutOfRange([&none] { makeStateKernels("Aging", none); })}) {
    EXPECT_EQ(message, "'Aging' is not a known state law. Choose one of 'Ageing', 'Flash Heating', "
                       "'None', 'Slip', 'Slip Weakening', 'Strong Rate Weakening', 'Tabulated'.");
  }
}

TEST(Registry, RefusesViewsThatDoNotFit)
{
  const auto two = toDevice(Values{1, 1}), three = toDevice(Values{1, 1, 1});
  const auto parameters = parametersOf({{0.01, 0.015, 1e-6, 0.6}, {0.01, 0.015, 1e-6, 0.6}});
  EXPECT_NO_THROW(makeFrictionKernels("Truncated", {two, two, two, parameters}));
  EXPECT_THROW(makeFrictionKernels("Truncated", {two, three, two, parameters}),
               std::invalid_argument);
  EXPECT_THROW(makeFrictionKernels("Truncated", {two, two, three, parameters}),
               std::invalid_argument);
  EXPECT_THROW(makeFrictionKernels("Truncated", {two, two, two, parametersOf({{1, 1}, {1, 1}})}),
               std::invalid_argument);
  EXPECT_THROW(makeStateKernels("Slip", parameters), std::invalid_argument);
}

TEST(Registry, ASlipFactorThatIsLeftOutIsOne)
{
  const auto one = toDevice(Values{1});
  const auto parameters = parametersOf({{0.01, 0.015, 1e-6, 0.6}});
  const auto v = toDevice(std::vector<Values>{{1e-3}});
  const NodeView with("with", 1), without("without", 1);
  makeFrictionKernels("Regularised", {one, one, one, parameters})->coefficient(v, one, with);
  makeFrictionKernels("Regularised", {one, one, {}, parameters})->coefficient(v, one, without);
  EXPECT_GT(toHost(with)(0), 0.6);
  EXPECT_EQ(toHost(with)(0), toHost(without)(0));
}

TEST(Registry, AFaultMayHaveNoNodesOnThisRank)
{
  const Kokkos::View<double**, MemorySpace> parameters("parameters", 4, 0);
  const NodeView none("none", 0);
  const auto kernels = makeFrictionKernels("Regularised", {none, none, {}, parameters});
  const BlockView v("v", 0, 2);
  EXPECT_EQ(kernels->minimise(IndexView(), none, v, {none, none}, v), 0);
  EXPECT_EQ(kernels->difference(v, v, {none, none}).change, 0);
  EXPECT_EQ(kernels->slope(v, v, 1, {none, none}), 0);
}
} // namespace
} // namespace asperity::friction::test
