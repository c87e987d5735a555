#include "registry/LawParameters.hpp"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

namespace asperity
{
namespace
{
struct Base
{
  double stiffness;
};

// The order of the members is not that of the table, and one member is derived.
struct SampleLaw : Base
{
  static constexpr char const* name = "Sample";
  double angle, half_angle, strength;

  static constexpr ParameterOf<SampleLaw> parameters[] = {
    {&SampleLaw::strength, {"Strength", "Pa", 1, Range::atLeast(0), "."}},
    {&SampleLaw::stiffness, {"Stiffness", "Pa", 2, Range::atLeast(0), "."}},
    {&SampleLaw::angle, {"Angle", "deg", 3, Range::atLeast(0), "."}}};

  KOKKOS_INLINE_FUNCTION void prepare() { half_angle = angle / 2; }
};
static_assert(std::is_trivially_copyable_v<SampleLaw>);

struct WithoutParameters
{
  static constexpr char const* name = "Without";
};

struct OtherBase
{
  double weight;
};

// What the table must not do: bind members of a second base. Some compilers get it right.
struct TwoBases : Base, OtherBase
{
  static constexpr ParameterOf<TwoBases> parameters[] = {
    {&TwoBases::stiffness, {"Stiffness", "Pa", 2, Range::atLeast(0), "."}},
    {&TwoBases::weight, {"Weight", "kg", 3, Range::atLeast(0), "."}}};
};

// Two parameters, one member.
struct Twice : Base
{
  static constexpr ParameterOf<Twice> parameters[] = {
    {&Twice::stiffness, {"Stiffness", "Pa", 2, Range::atLeast(0), "."}},
    {&Twice::stiffness, {"Weight", "kg", 3, Range::atLeast(0), "."}}};
};

TEST(LawParameters, GoToTheMembersThatTheTableNames)
{
  const std::vector<double> values = {10, 20, 30};
  auto const law = loadLaw<SampleLaw>(values.data());
  EXPECT_EQ(law.strength, 10);
  EXPECT_EQ(law.stiffness, 20);
  EXPECT_EQ(law.angle, 30);
}

TEST(LawParameters, AreLoadedBeforeWhatIsDerivedFromThem)
{
  const std::vector<double> values = {10, 20, 30};
  EXPECT_EQ(loadLaw<SampleLaw>(values.data()).half_angle, 15);
}

TEST(LawParameters, AreListedInTheOrderOfTheTable)
{
  std::vector<Parameter> parameters;
  appendParameters<SampleLaw>(parameters);
  std::vector<std::string> names;
  for (auto const& parameter : parameters) {
    names.emplace_back(parameter.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"Strength", "Stiffness", "Angle"}));
}

TEST(LawParameters, AreBoundToMembersOfTheirOwn)
{
  EXPECT_TRUE(bindsDistinctMembers<SampleLaw>());
  EXPECT_TRUE(bindsDistinctMembers<WithoutParameters>());
  EXPECT_FALSE(bindsDistinctMembers<Twice>());
  const std::vector<double> values = {10, 20};
  auto const law = loadLaw<TwoBases>(values.data());
  EXPECT_EQ(bindsDistinctMembers<TwoBases>(), law.stiffness == 10 && law.weight == 20);
}

TEST(LawParameters, MayBeNone)
{
  std::vector<Parameter> parameters;
  appendParameters<WithoutParameters>(parameters);
  EXPECT_TRUE(parameters.empty());
  EXPECT_EQ(num_parameters<WithoutParameters>, 0);
  loadLaw<WithoutParameters>(static_cast<double const*>(nullptr));
}
} // namespace
} // namespace asperity
