#include "scenario/DeckReader.hpp"
#include "scenario/DeckRemarks.hpp"

#include "SampleDeck.hpp"
#include "dynamics/FaultProcess.hpp"
#include "dynamics/control/StepControlKind.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "friction/Registration.hpp"
#include "friction/Registry.hpp"
#include "friction/laws/AgeingLaw.hpp"
#include "io/Output.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/deck/DeckAssembly.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <Teuchos_DefaultComm.hpp>

namespace asperity::scenario
{
using namespace test;
using asperity::test::TemporaryDirectory;

namespace
{
// Somebody else's laws. They do what the ageing law does.
struct AgeingLike
{
  double slip_distance, reference_rate;

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return (reference_rate * math::exp(-alpha) - V) / slip_distance;
  }
  KOKKOS_INLINE_FUNCTION double flow(double, double, double alpha0) const { return alpha0; }
  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    return -math::log(V / reference_rate);
  }
};

constexpr friction::Parameter slip_distance = {"L", "m", friction::no_default, Range::positive(),
                                               "Slip distance."};

// With a parameter that no other law has; it does not say what its theta is.
struct SlowAgeingLaw : AgeingLike
{
  static constexpr char const* name = "Slow Ageing";
  double delay;
  static constexpr ParameterOf<SlowAgeingLaw> parameters[] = {
    {&SlowAgeingLaw::slip_distance, scenario::slip_distance},
    {&SlowAgeingLaw::reference_rate, friction::parameter::reference_slip_rate},
    {&SlowAgeingLaw::delay, {"Delay", "s", 7, Range::closedOpen(0, 100), "How late it is."}}};
};

// Its reference rate has a narrower range than that of the friction laws.
struct NarrowAgeingLaw : AgeingLike
{
  static constexpr char const* name = "Narrow Ageing";
  static constexpr ParameterOf<AgeingLike> parameters[] = {
    {&AgeingLike::slip_distance, scenario::slip_distance},
    {&AgeingLike::reference_rate,
     {"Reference Slip Rate", "m/s", 1e-6, Range::closed(1e-7, 1e-5), "Slip rate of reference."}}};
};

// Contradicts the friction laws.
struct ForeignAgeingLaw : AgeingLike
{
  static constexpr char const* name = "Foreign Ageing";
  static constexpr ParameterOf<AgeingLike> parameters[] = {
    {&AgeingLike::slip_distance, scenario::slip_distance},
    {&AgeingLike::reference_rate,
     {"Reference Slip Rate", "m/s", -1, Range::closedOpen(-2, 0), "Slip rate of reference."}}};
};
} // namespace
} // namespace asperity::scenario

ASPERITY_REGISTER_STATE_LAW(asperity::scenario::SlowAgeingLaw)
ASPERITY_REGISTER_STATE_LAW(asperity::scenario::NarrowAgeingLaw)
ASPERITY_REGISTER_STATE_LAW(asperity::scenario::ForeignAgeingLaw)

namespace asperity::scenario
{
using Names = std::vector<std::string>;

TEST(Registries, HoldWhatThePackagesBring)
{
  EXPECT_EQ(friction::frictionLaws().names(),
            (Names{"Cut-Off", "None", "Regularised", "Slip Weakening", "Truncated"}));
  EXPECT_EQ(friction::stateLaws().names(),
            (Names{"Ageing", "Flash Heating", "Foreign Ageing", "Narrow Ageing", "None", "Slip",
                   "Slip Weakening", "Slow Ageing", "Strong Rate Weakening", "Tabulated"}));
  EXPECT_EQ(dynamics::FaultProcessRegistry::instance().names(),
            (Names{"Forced Rupture", "Pore Pressure", "Thermal Pressurisation"}));
  EXPECT_EQ(fem::bulkLaws().names(), (Names{"Burgers", "Drucker-Prager", "Kelvin-Voigt", "Maxwell",
                                            "Power Law", "Von Mises"}));
  EXPECT_EQ(dynamics::StepControlRegistry::instance().names(),
            (Names{"Prescribed", "Richardson", "Step Doubling"}));
  EXPECT_EQ(io::OutputRegistry::instance().names(),
            (Names{"Event Catalogue", "Fault History", "Global", "Receivers", "Rupture",
                   "Step Table", "Surface History", "Volume Snapshots"}));
}

TEST(DeckReader, CompletesADeckWithItsDefaults)
{
  const auto deck = completeDeck();
  EXPECT_EQ(deck.sublist("Friction").get<std::string>("Law"), "Regularised");
  EXPECT_EQ(deck.sublist("Friction").get<std::string>("State Evolution"), "Ageing");
  EXPECT_EQ(deck.sublist("Friction").get<double>("Reference Slip Rate"), 1e-6);
  EXPECT_EQ(deck.sublist("Friction").get<double>("Reference Friction Coefficient"), 0.6);
  EXPECT_EQ(deck.sublist("Friction").get<double>("Normal Stress Factor"), 1);
  EXPECT_FALSE(deck.sublist("Friction").isParameter("Normal Stress"));
  EXPECT_EQ(deck.sublist("Bulk").get<std::string>("Model"), "Plane Strain");
  EXPECT_EQ(deck.sublist("Bulk").get<std::string>("Law"), "Kelvin-Voigt");
  EXPECT_EQ(deck.sublist("Bulk").get<double>("Shear Viscosity"), 0);
  EXPECT_EQ(deck.sublist("Initial State").get<std::string>("Acceleration"), "Balanced");
  EXPECT_EQ(deck.sublist("Initial State").get<double>("alpha"), 0);
  auto const& time = deck.sublist("Time Stepping");
  EXPECT_EQ(time.get<std::string>("Scheme"), "Newmark");
  EXPECT_EQ(time.sublist("Newmark").get<double>("beta"), 0.25);
  EXPECT_EQ(time.sublist("Step Doubling").get<double>("Tolerance"), 1e-5);
  EXPECT_EQ(deck.sublist("Coupling").get<int>("Maximum Iterations"), 100);
  EXPECT_EQ(deck.sublist("TNNMG").get<std::string>("Linear Correction"), "Auto");
  EXPECT_GT(deck.sublist("Output").get<int>("Checkpoint Every n Steps"), 0);
  for (auto const& name : io::OutputRegistry::instance().names()) {
    EXPECT_TRUE(deck.sublist("Output").sublist(name).isParameter("Enabled")) << name;
  }
}

TEST(DeckReader, TakesTheParametersOfTheChosenLaws)
{
  const auto slow = completeDeck(
    [](auto& deck) { deck.sublist("Friction").set("State Evolution", "Slow Ageing"); });
  EXPECT_EQ(slow.sublist("Friction").get<double>("Delay"), 7);
  EXPECT_FALSE(completeDeck().sublist("Friction").isParameter("Delay"));
  expectParts(
    refusal([] { completeDeck([](auto& deck) { deck.sublist("Friction").set("Delay", 1.); }); }),
    {"Asperity / Friction / Delay", "unknown"});
  expectRefusal(
    [] {
      completeDeck([](auto& deck) {
        deck.sublist("Friction").set("State Evolution", "Slow Ageing").set("Delay", 100.);
      });
    },
    {"Asperity / Friction / Delay = 100", "[0, 100)"});
}

TEST(DeckReader, LawsThatShareAParameterShareItsRange)
{
  const auto withRate = [](std::string const& state_law, double rate) {
    return [=] {
      completeDeck([&](auto& deck) {
        deck.sublist("Friction").set("State Evolution", state_law).set("Reference Slip Rate", rate);
      });
    };
  };
  withRate("Ageing", 1e-4)();
  withRate("Narrow Ageing", 1e-5)();
  expectRefusal(withRate("Narrow Ageing", 1e-4),
                {"Asperity / Friction / Reference Slip Rate = 1e-04", "[1e-07, 1e-05] m/s"});
  EXPECT_THROW(withRate("Foreign Ageing", 1e-6)(), std::logic_error);
}

// All pairs of our own laws go together.
TEST(DeckReader, OurLawsAgreeOnTheParametersTheyShare)
{
  for (std::string const law : {"Regularised", "Truncated"}) {
    for (std::string const state_law : {"Ageing", "Slip"}) {
      EXPECT_NO_THROW(completeDeck([&](auto& deck) {
        deck.sublist("Friction").set("Law", law).set("State Evolution", state_law);
      }))
        << law << " with " << state_law;
    }
  }
}

TEST(DeckReader, RequiresWhatALawRequires)
{
  for (char const* name : {"a", "b", "L"}) {
    expectRefusal(
      [name] { completeDeck([name](auto& deck) { deck.sublist("Friction").remove(name); }); },
      {std::string("Asperity / Friction / ") + name});
  }
  expectParts(
    refusal([] { completeDeck([](auto& deck) { deck.sublist("Friction").set("a", -0.01); }); }),
    {"Asperity / Friction / a = -0.01 is outside (0, inf)", "Check the sign"});
}

namespace
{
// The short deck in a file of its own, read as a command line would have it.
class DeckFile
{
public:
  DeckFile()
  {
    line_.deck = directory_.file("deck.xml");
    writeParameters(shortDeck(), line_.deck);
  }

  RCP<ParameterList> read(std::vector<std::string> const& overrides,
                          std::string const& overlay = "")
  {
    line_.overrides = overrides;
    line_.overlays.clear();
    if (!overlay.empty()) {
      line_.overlays.push_back(directory_.write("overlay.xml", overlay));
    }
    return readCompleteDeck(line_);
  }

  std::string remark(std::vector<std::string> const& overrides, std::string const& message = "")
  {
    line_.overrides = overrides;
    return remarkOnLargeValues(line_, message);
  }

private:
  TemporaryDirectory directory_;
  CommandLine line_;
};
} // namespace

TEST(DeckReader, AppliesOverlaysThenOverrides)
{
  DeckFile file;
  const std::string overlay = R"(<ParameterList name="Asperity">
    <ParameterList name="Friction">
      <Parameter name="a" type="double" value="0.02"/>
      <Parameter name="b" type="double" value="0.03"/>
    </ParameterList>
  </ParameterList>)";
  const auto deck = file.read(
    {"Friction/State Evolution=Slow Ageing", "Friction/Delay=3", "Friction/b=0.04"}, overlay);
  auto const& friction = deck->sublist("Friction");
  EXPECT_EQ(friction.get<double>("a"), 0.02);
  EXPECT_EQ(friction.get<double>("b"), 0.04);
  EXPECT_EQ(friction.get<double>("Delay"), 3);
  EXPECT_EQ(friction.get<double>("L"), 1e-5);
}

// Whatever their names are: in a list, in an open list, and with a word of a choice.
TEST(DeckReader, FindsTheFilesThatEntriesAreDeclaredToNameBesideTheDeck)
{
  const auto file = Declare().fileName("Table File", required, "The table.").list();
  const auto valid =
    Declare()
      .sublist("Own", file, "A list.")
      .openSublist("Open", Declare().sublist("<each>", file, "One.").list(), "Some.")
      .choice("Law", "Plain", {"Plain", "Tabulated"}, "The law.")
      .entriesWith("Law", "Tabulated", file)
      .text("Title", "", "No file.")
      .list();
  const TemporaryDirectory directory;
  const auto table = directory.write("table.txt", "");
  CommandLine line;
  line.deck = directory.write("deck.xml", R"(<ParameterList name="Asperity">
    <ParameterList name="Own">
      <Parameter name="Table File" type="string" value="table.txt"/>
    </ParameterList>
    <ParameterList name="Open">
      <ParameterList name="Mine">
        <Parameter name="Table File" type="string" value="table.txt"/>
      </ParameterList>
    </ParameterList>
    <Parameter name="Law" type="string" value="Tabulated"/>
    <Parameter name="Table File" type="string" value="table.txt"/>
    <Parameter name="Title" type="string" value="table.txt"/>
    <Parameter name="File Name" type="string" value="table.txt"/>
  </ParameterList>)");
  const auto deck = deckAsGiven(line, *valid).list;
  EXPECT_EQ(deck->sublist("Own").get<std::string>("Table File"), table);
  EXPECT_EQ(deck->sublist("Open").sublist("Mine").get<std::string>("Table File"), table);
  EXPECT_EQ(deck->get<std::string>("Table File"), table);
  EXPECT_EQ(deck->get<std::string>("Title"), "table.txt");
  EXPECT_EQ(deck->get<std::string>("File Name"), "table.txt") << "not declared";
}

TEST(DeckReader, ChoosesASchemeThatNeedsNoInertia)
{
  DeckFile file;
  const auto scheme = [&](std::vector<std::string> const& overrides) {
    return file.read(overrides)->sublist("Time Stepping").get<std::string>("Scheme");
  };
  const std::string massless = "Bulk/Dynamics=Quasi-dynamic";
  EXPECT_EQ(scheme({}), "Newmark");
  EXPECT_EQ(scheme({massless}), "Generalised Alpha");
  const auto deck = file.read({massless});
  auto const& parameters = deck->sublist("Time Stepping").sublist("Generalised Alpha");
  EXPECT_EQ(parameters.get<double>("Spectral Radius"), 0.5);
  for (std::string const named : {"Backward Euler", "Newmark"}) {
    EXPECT_EQ(scheme({massless, "Time Stepping/Scheme=" + named}), named);
  }
}

TEST(DeckReader, RefusesAnUnknownLawWithTheNearestName)
{
  DeckFile file;
  expectRefusal([&] { file.read({"Friction/Law=Regularized"}); },
                {"Asperity / Friction / Law", "Regularized", "Did you mean 'Regularised'?"});
  expectRefusal([&] { file.read({"Friction/State Evolution=Aging"}); },
                {"Asperity / Friction / State Evolution", "Did you mean 'Ageing'?"});
}

TEST(DeckReader, RemarksOnNumbersThatAreRarelyMeant)
{
  DeckFile file;
  EXPECT_EQ(file.remark({}), "");
  EXPECT_EQ(file.remark({"Bulk/Density=1e100", "Mesh/Rectangle/Width=inf"}), "");
  EXPECT_EQ(file.remark({"Mesh/Rectangle/Width=1e308"}),
            "\nThe deck has numbers beyond 1e100: Mesh / Rectangle / Width = 1e+308.");
  const std::vector<std::string> in_texts = {"Bulk/Density=x < 2e101 ? 1 : b1e308"};
  EXPECT_EQ(file.remark(in_texts), "\nThe deck has numbers beyond 1e100: "
                                   "Bulk / Density = x < 2e101 ? 1 : b1e308.");
  EXPECT_EQ(file.remark(in_texts, "Bulk / Density = 7 is no good"), "") << "said already";
  const std::vector<std::string> many = {"Names/p=1e308", "Names/q=-1e200", "Names/r=3e101",
                                         "Names/s=1e+302"};
  expectParts(file.remark(many), {"Names / p = 1e+308, Names / q = -1e+200, Names / r = 3e+101 "
                                  "and 1 more."});
  EXPECT_EQ(file.remark({"No/Such=1e308"}), "") << "the message is about that";
}

TEST(DeckReader, FingerprintsWhatARestartMustNotChange)
{
  DeckFile file;
  const auto world = Teuchos::DefaultComm<int>::getComm();
  const auto of = [&](std::vector<std::string> const& overrides) {
    return fingerprint(*file.read(overrides), Mesh<2>(), *world);
  };
  const auto standard = of({});
  EXPECT_EQ(io::difference(standard, of({"Time Stepping/Final Time=20"})), "");
  EXPECT_EQ(io::difference(standard, of({"Output/Checkpoint Every n Steps=3"})), "");
  EXPECT_EQ(io::difference(standard, of({"Output/Fault History/Enabled=false"})), "");
  EXPECT_EQ(io::difference(standard, of({"TNNMG/Multigrid/Method=V-Cycles"})), "");
  EXPECT_EQ(io::difference(standard, of({"Coupling/Tolerance=1e-6"})), "");
  EXPECT_EQ(io::difference(standard, of({"Friction/Law=Regularised"})), "")
    << "a default, said aloud";
  EXPECT_EQ(io::difference(standard, of({"Time Stepping/Most Forced Steps=7"})), "");
  for (std::string const control : {"Step Doubling", "Richardson"}) {
    const auto chosen = "Time Stepping/Control=" + control;
    const auto tolerance = "Time Stepping/" + control + "/Tolerance=1e-3";
    EXPECT_EQ(io::difference(of({chosen}), of({chosen, tolerance})), "") << control;
  }
  const std::string prescribed = "Time Stepping/Control=Prescribed";
  EXPECT_NE(
    io::difference(of({prescribed}), of({prescribed, "Time Stepping/Prescribed/Levels={1}"})), "");
  for (char const* change : {"Friction/a=0.010000000000000002", "Friction/State Evolution=Slip",
                             "Mesh/Rectangle/Width=3", "Bulk/Density=1000*(1+0*x)",
                             "Boundary Conditions/Left/Type=Fixed", "Initial State/alpha=1",
                             "Time Stepping/Largest Step=2"}) {
    EXPECT_NE(io::difference(standard, of({change})), "") << change;
  }
}
} // namespace asperity::scenario
