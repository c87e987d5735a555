#include "scenario/watches/SkippedTimes.hpp"

#include "SampleDeck.hpp"

namespace asperity::scenario
{
using namespace test;

namespace
{
// What is told of successive steps with these ends, under a load on a fault at y = 0.
std::vector<std::string> told(std::string const& load, std::vector<double> const& ends)
{
  const auto deck = completeDeck([&](ParameterList& given) {
    given.sublist("Friction").remove("Shear Traction", false);
    given.sublist("Friction").set("Shear Traction", load);
  });
  SkippedTimes watch(deck, {{0, 0, 0}, {7, 0, 0}}, world());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (auto const warning = watch.note(ends[i], ends[i + 1])) {
      texts.push_back(warning->text);
    }
  }
  return texts;
}
} // namespace

TEST(SkippedTimes, TellsOfAPulseOnce)
{
  auto const texts =
    told("x > 5 ? exp(-((t - 53) / 2)^2) : 0", {0, 25, 50, 100, 125, 150}); // not at x = 0
  ASSERT_EQ(texts.size(), 1u);
  expectParts(texts.front(), {"from t = 50 s to 100 s passes 53 s", "Friction / Shear Traction"});
  EXPECT_EQ(told("abs(t - 53) < 2 ? 1 : 0", {0, 50, 100}).size(), 1u);
  EXPECT_EQ(told("max(0, 1 - abs(t - 53) / 2)", {0, 50, 100}).size(), 1u);
}

TEST(SkippedTimes, SaysNothingOfWhatStepsSee)
{
  EXPECT_EQ(told("exp(-((t - 53) / 2)^2)", {0, 50, 53, 100}).size(), 0u);
  EXPECT_EQ(told("tanh((t - 60) / 2)", {0, 50, 100}).size(), 0u); // ends see where it leads
  EXPECT_EQ(told("1 + 1e-3 * (t - 60)", {0, 50, 100}).size(), 0u);
  EXPECT_EQ(told("t > 60 ? 1 : 0", {0, 50, 100}).size(), 0u);
}
} // namespace asperity::scenario
