#include "io/TextFormat.hpp"
#include "platforms/parts/Stations.hpp"
#include "unit/platforms/Deck.hpp"

// A platform of its own, as packages/platforms/README.md says: this file is all it takes.
namespace asperity::platforms
{
namespace
{
class Benchmark : public io::TextFormat
{
public:
  Teuchos::RCP<const Teuchos::ParameterList> validParameters() const override
  {
    return RunFacts::declare("B1").list();
  }

  std::vector<std::string> files() const override { return {"benchmark/station_*"}; }

  std::unique_ptr<io::Output> make(Teuchos::ParameterList const& parameters,
                                   io::OutputContext const& context,
                                   io::Offers const& offers) const override
  {
    const auto step_lines = [](StepFacts const& facts) {
      return std::vector<std::string>{countLine(facts.count)};
    };
    const Platform platform{"Benchmark", "benchmark", RunFacts::from(parameters, context),
                            step_lines};
    auto files = std::make_unique<PlatformFiles>();
    auto const* receivers = offers.find<catalogue::Receivers>();
    if (receivers && receivers->onFault()) {
      const Columns columns{{"Slip (m)", "slip", "slip", first_component, unchanged}};
      files->add("on_fault", std::make_unique<Stations>(
                               platform, context, Stations::Kind{"station_", "on fault", columns},
                               *receivers, *receivers->onFault()));
    }
    return files;
  }
};
} // namespace

ASPERITY_REGISTER(io::TextFormatRegistry, "Benchmark", Benchmark)
} // namespace asperity::platforms

using namespace asperity;

TEST(ThirdPlatform, IsAWordOfTheDeckAndWritesItsFiles)
{
  test::TemporaryDirectory directory;
  test::Stage stage(6);
  stage.add("fault", "slip", 1, [&](double const* x, int) { return stage.time * x[0]; });
  auto deck = test::deckWith("Receivers", "Benchmark");
  auto& receivers = deck.sublist("Receivers");
  receivers.sublist("On Fault").set("a", test::position({0.3, 0.}));
  receivers.set("Fault Fields", Teuchos::Array<std::string>(1, "slip"));
  io::OutputSet outputs(deck, stage.context(directory.path()));
  outputs.write(stage.at(0, 2));
  outputs.write(stage.at(1, 2, true));
  outputs.closeSegment();
  test::onRankZero([&] {
    EXPECT_EQ(test::contents(directory / "benchmark/station_a"),
              "# This is the file header:\n"
              "# problem=BP1-QD\n"
              "# author=A. Modeller\n"
              "# date=2024/05/31\n"
              "# code=Asperity\n"
              "# code_version=1.2\n"
              "# element_size=50 m\n"
              "# location=on fault, (0.3, 0) m, 0.3 m from the end of smaller x\n"
              "# num_time_steps=1           \n"
              "# Column #1 = Time (s)\n"
              "# Column #2 = Slip (m)\n"
              "# The line below lists the names of the data fields:\n"
              "t slip\n"
              " 0.00000000000000E+00   0.000000E+00\n"
              " 2.00000000000000E+00   6.000000E-01\n");
  });
}
