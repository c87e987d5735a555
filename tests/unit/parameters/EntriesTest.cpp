#include "parameters/Entries.hpp"

#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

// Entries that are declared and read by one call each.
namespace
{
using namespace asperity;
using namespace asperity::test;

enum class Colour
{
  red,
  blue
};

struct Sample
{
  double length = 2;
  std::optional<double> width;
  int number = 3;
  bool is_on = true;
  std::string law = "First";
  std::string boundary;
  Colour colour = Colour::blue;
  std::vector<double> times = {1, 2};
  std::optional<std::vector<double>> direction;
  std::vector<int> levels = {4};
  std::vector<std::string> fields = {"slip"};

  static Entries<Sample> entries()
  {
    using S = Sample;
    return Entries<S>()
      .real("Length", &S::length, "m", Range::positive(), "A length.")
      .real("Width", &S::width, optional, "m", Range::positive(), "A width.")
      .integer("Number", &S::number, Range::atLeast(0), "A number.")
      .boolean("On", &S::is_on, "A switch.")
      .choiceOfWords("Law", &S::law, {"First", "Second"}, "A law.")
      .text("Boundary", &S::boundary, required, "A boundary.")
      .choice("Colour", &S::colour, {{"Red", Colour::red}, {"Blue", Colour::blue}}, "A colour.")
      .realArray("Times", &S::times, "s", Range::atLeast(0), "Times.")
      .realArray("Direction", &S::direction, optional, "-", Range::any(), "A direction.")
      .integerArray("Levels", &S::levels, Range::closed(0, 60), "Levels.")
      .textArray("Fields", &S::fields, "Fields.");
  }
};

Sample read(ParameterList list)
{
  completeAndValidate(list, *Sample::entries().list(), "Sample");
  return Sample::entries().read(list, "Sample");
}

ParameterList withBoundary()
{
  ParameterList list;
  list.set("Boundary", "base");
  return list;
}
} // namespace

TEST(Entries, HaveTheDefaultsOfTheStruct)
{
  auto const found = read(withBoundary());
  EXPECT_EQ(found.length, 2);
  EXPECT_FALSE(found.width);
  EXPECT_EQ(found.number, 3);
  EXPECT_TRUE(found.is_on);
  EXPECT_EQ(found.law, "First");
  EXPECT_EQ(found.boundary, "base");
  EXPECT_EQ(found.colour, Colour::blue);
  EXPECT_EQ(found.times, (std::vector<double>{1, 2}));
  EXPECT_FALSE(found.direction);
  EXPECT_EQ(found.levels, (std::vector<int>{4}));
  EXPECT_EQ(found.fields, (std::vector<std::string>{"slip"}));
}

TEST(Entries, ReadWhatTheDeckGives)
{
  auto list = withBoundary();
  list.set("Length", 5.).set("Width", 6.).set("Number", 7).set("On", false);
  list.set("Law", "Second").set("Colour", "Red");
  list.set("Times", array<double>({8})).set("Direction", array<double>({9, 10}));
  list.set("Levels", array<int>({11, 12}));
  list.set("Fields", array<std::string>({}));
  auto const found = read(list);
  EXPECT_EQ(found.length, 5);
  EXPECT_EQ(found.width, 6);
  EXPECT_EQ(found.number, 7);
  EXPECT_FALSE(found.is_on);
  EXPECT_EQ(found.law, "Second");
  EXPECT_EQ(found.colour, Colour::red);
  EXPECT_EQ(found.times, (std::vector<double>{8}));
  EXPECT_EQ(found.direction, (std::vector<double>{9, 10}));
  EXPECT_EQ(found.levels, (std::vector<int>{11, 12}));
  EXPECT_TRUE(found.fields.empty());
}

TEST(Entries, RefuseWhatIsMissingOrOutOfRange)
{
  expectRefusal([] { read(ParameterList()); }, {"Sample / Boundary", "missing"});
  auto list = withBoundary();
  list.set("Levels", array<int>({61}));
  expectRefusal([&] { read(list); }, {"Sample / Levels", "61"});
  list = withBoundary();
  list.set("Law", "Third");
  expectRefusal([&] { read(list); }, {"Sample / Law", "Third", "First"});
}
