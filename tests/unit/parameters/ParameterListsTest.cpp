#include "parameters/Parameters.hpp"

#include "unit/base/Refusal.hpp"

namespace
{
using namespace asperity;
using asperity::test::expectRefusal;

Teuchos::RCP<ParameterList> meshParameters()
{
  const auto wedge = Declare().real("Length", 1.0, "m", Range::positive(), "Length.").list();
  const auto file = Declare().fileName("File Name", required, "The mesh.").list();
  return Declare()
    .choiceOfLists("Type", "Wedge", {{"Wedge", wedge}, {"File", file}}, "Where it comes from.")
    .list();
}

TEST(ParameterLists, OnlyTheChosenListIsCompleted)
{
  ParameterList list;
  completeAndValidate(list, *meshParameters(), "Asperity / Mesh");
  EXPECT_EQ(list.get<std::string>("Type"), "Wedge");
  EXPECT_EQ(list.sublist("Wedge").get<double>("Length"), 1.0);
  EXPECT_FALSE(list.isParameter("File"));

  ParameterList other;
  other.set("Type", std::string("File"));
  expectRefusal([&] { completeAndValidate(other, *meshParameters(), "Asperity / Mesh"); },
                {"Asperity / Mesh / File / File Name is missing"});
}

TEST(ParameterLists, ListsThatAreNotChosenAreStillChecked)
{
  ParameterList list;
  list.sublist("File");
  completeAndValidate(list, *meshParameters(), "Asperity / Mesh");
  EXPECT_EQ(list.sublist("File").numParams(), 0);

  ParameterList wrong;
  wrong.sublist("File").set("File Nam", std::string("a.h5"));
  expectRefusal([&] { completeAndValidate(wrong, *meshParameters(), "Asperity / Mesh"); },
                {"Asperity / Mesh / File / File Nam is unknown", "'File Name'"});
}

TEST(ParameterLists, SublistsAreCompleted)
{
  const auto inner = Declare().integer("Depth", 2, Range::atLeast(0), "Depth.").list();
  const auto valid = Declare().sublist("Always", inner, "A.").list();
  ParameterList list;
  completeAndValidate(list, *valid, "Asperity");
  EXPECT_EQ(list.sublist("Always").get<int>("Depth"), 2);
}

TEST(ParameterLists, OpenListsTakeAnyNameButNotAnyValue)
{
  const auto condition = Declare().text("<region>", required, "Condition.").list();
  const auto boundary = Declare().real("Velocity", 0.0, "m/s", Range::any(), "Velocity.").list();
  const auto valid =
    Declare()
      .openSublist("Regions", condition, "Regions.")
      .openSublist("Boundaries", Declare().sublist("<boundary>", boundary, "Each.").list(), "All.")
      .list();
  ParameterList list;
  list.sublist("Regions").set("mantle", std::string("y < -1"));
  list.sublist("Boundaries").sublist("left");
  completeAndValidate(list, *valid, "Asperity");
  EXPECT_EQ(list.sublist("Regions").numParams(), 1);
  EXPECT_EQ(list.sublist("Boundaries").sublist("left").get<double>("Velocity"), 0.0);

  ParameterList number;
  number.sublist("Regions").set("mantle", 3.0);
  expectRefusal([&] { completeAndValidate(number, *valid, "Asperity"); },
                {"Asperity / Regions / mantle = 3", "a text"});
  ParameterList unknown;
  unknown.sublist("Boundaries").sublist("left").set("Velocty", 1.0);
  expectRefusal([&] { completeAndValidate(unknown, *valid, "Asperity"); },
                {"Asperity / Boundaries / left / Velocty is unknown", "'Velocity'"});
}

TEST(ParameterLists, ForeignListsKeepTheirOwnAndGetOurDefaults)
{
  ParameterList defaults;
  defaults.set("smoother: type", std::string("RELAXATION"));
  defaults.sublist("smoother: params").set("relaxation: sweeps", 1);
  const auto valid = Declare().foreignSublist("MueLu", defaults, "Checked by MueLu.").list();
  ParameterList list;
  list.sublist("MueLu")
    .set("max levels", 4)
    .sublist("smoother: params")
    .set("relaxation: sweeps", 3);
  completeAndValidate(list, *valid, "Asperity / TNNMG");
  auto& completed = list.sublist("MueLu");
  EXPECT_EQ(completed.get<int>("max levels"), 4);
  EXPECT_EQ(completed.get<std::string>("smoother: type"), "RELAXATION");
  EXPECT_EQ(completed.sublist("smoother: params").get<int>("relaxation: sweeps"), 3);
}
} // namespace
