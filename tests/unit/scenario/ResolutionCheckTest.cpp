#include "scenario/checks/ResolutionCheck.hpp"

#include "SampleDeck.hpp"
#include "scenario/report/RunReport.hpp"

#include <algorithm>

namespace asperity::scenario
{
using namespace test;

namespace
{
const fem::Material crust = {2670, 50e9, 30e9, 0, 0}; // Poisson's ratio 1/4

// A strip with d_c = 0.9 m, mu_s = 0.7 and mu_d = 0.5 after the change.
ParameterList slipWeakening(std::function<void(ParameterList&)> const& change)
{
  return strip([&](ParameterList& given) {
    auto& friction = given.sublist("Friction");
    for (auto const* unused :
         {"a", "b", "L", "Reference Slip Rate", "Reference Friction Coefficient"}) {
      friction.remove(unused, false);
    }
    friction.set("Law", "Slip Weakening").set("State Evolution", "Slip Weakening");
    friction.set("Static Friction Coefficient", 0.7).set("Dynamic Friction Coefficient", 0.5);
    friction.set("Slip-Weakening Distance", 0.9);
    given.sublist("Initial State").set("State", "Given");
    change(friction);
  });
}

bool warns(Description const& description, std::string const& topic = "cohesive zone")
{
  auto const& warnings = description.warnings;
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](Warning const& warning) { return warning.topic == topic; });
}

// This state law with a friction law for it.
LawChoice lawsWith(std::string const& state)
{
  return {state == "Slip Weakening" ? state : "Regularised", state};
}
} // namespace

TEST(ResolutionCheck, KnowsTheModulusOfEachFault)
{
  EXPECT_NEAR(dynamics::slipModulus(crust, 1, fem::OtherSide::mirror_image), 30e9, 1);
  EXPECT_NEAR(dynamics::slipModulus(crust, 1, fem::OtherSide::rigid_foundation), 60e9, 1);
  EXPECT_NEAR(dynamics::slipModulus(crust, 2, fem::OtherSide::mirror_image), 40e9, 1);
  EXPECT_NEAR(dynamics::slipModulus(crust, 2, fem::OtherSide::rigid_foundation), 90e9, 1);
}

TEST(ResolutionCheck, HasTheLengthsOfTheBenchmark)
{
  // SEAS BP1: "process zone" of about 340 m, nucleation length of 1.96 km.
  const double G = 2670. * 3464 * 3464;
  EXPECT_NEAR(dynamics::cohesiveZone(G, 0.015, 0.008, 50e6), 341.7, 0.1);
  EXPECT_NEAR(dynamics::nucleationLength(G, 0.010, 0.015, 0.008, 50e6), 1958, 1);
  // Strongly weakening: 2 x 1.3774 Lambda0, and no jump where the formulas meet.
  EXPECT_NEAR(dynamics::nucleationLength(G, 0.003, 0.015, 0.008, 50e6), 2 * 1.3774 * 341.74, 0.1);
  double previous = dynamics::nucleationLength(G, 0.4 * 0.015, 0.015, 0.008, 50e6);
  for (double ratio = 0.401; ratio < 0.7; ratio += 0.001) {
    const double length = dynamics::nucleationLength(G, ratio * 0.015, 0.015, 0.008, 50e6);
    EXPECT_GE(length, previous);
    EXPECT_LE(length, 1.01 * previous);
    previous = length;
  }
}

TEST(ResolutionCheck, LooksAtThePartThatWeakens)
{
  // Cells of 1 m; Lambda0 = 1e6 * 1e-5 * ... at the nodes x = 0 and 1, not at x = 2.
  const auto deck = strip([](ParameterList& given) {
    auto& friction = given.sublist("Friction");
    friction.set("a", "x < 1.5 ? 0.01 : 0.02").set("L", "x < 1.5 ? 0.6 + x : 1e-3");
  });
  auto const problem = makeProblem<2>(deck, world());
  const auto resolution = problem.scales.resolution;
  ASSERT_TRUE(resolution);
  EXPECT_NEAR(resolution->smallest_cell, 1, 1e-12);
  EXPECT_NEAR(resolution->largest_cell, 1, 1e-12);
  const double zone = 1e6 * 0.6 / (0.015 * 1e4);
  EXPECT_NEAR(resolution->cohesive_zone, zone, 1e-9 * zone);
  EXPECT_NEAR(resolution->cells_per_zone, zone, 1e-9 * zone);
  EXPECT_NEAR(resolution->nucleation_length, 2 / M_PI * 9 * zone, 1e-6 * zone);
  EXPECT_NEAR(resolution->cell_height, 1, 1e-12);
  EXPECT_FALSE(warns(describe(problem)));
}

TEST(ResolutionCheck, SaysTheNucleationLengthOfTheAgeingLawAlone)
{
  // a spring of stiffness pi G' / lambda per slip is critical at (b - a) sigma_n / L
  const double wavelength = dynamics::unstableWavelength(40e9, 0.010, 0.015, 0.008, 50e6);
  EXPECT_NEAR(M_PI * 40e9 / wavelength, (0.015 - 0.010) * 50e6 / 0.008, 1e-3);
  dynamics::FaultResolution resolution{1, 1, 10, 47, wavelength, 10, 1};
  const auto text = [&](std::string const& law) {
    std::string all;
    for (auto const& line : describe(resolution, lawsWith(law), "Box")) {
      all += line;
    }
    return all;
  };
  expectParts(text("Ageing"), {"10 cells", "Nucleation length >= 47 m (ageing law"});
  expectParts(text("Slip"), {"10 cells", "longer than 4020 m", "'Slip'"});
  EXPECT_EQ(text("Slip").find("47"), std::string::npos);
  expectParts(text("Slip Weakening"), {"(mu_s - mu_d) sigma_n", "Nucleation length >= 47 m (slip"});
}

TEST(ResolutionCheck, WarnsOfCellsThatAreTooLarge)
{
  const auto lines = [](double L) {
    const auto deck = strip([L](ParameterList& given) { given.sublist("Friction").set("L", L); });
    return describe(makeProblem<2>(deck, world()));
  };
  // Lambda0 = L 1e6 / 150 m against cells of 1 m.
  EXPECT_TRUE(warns(lines(2.9 * 150 / 1e6)));
  EXPECT_FALSE(warns(lines(3.1 * 150 / 1e6)));
}

TEST(ResolutionCheck, WarnsOfAPartTooShortToNucleate)
{
  dynamics::FaultResolution r{1, 1, 10, 47, 30, 10, 1};
  r.weakening_length = 23; // the estimate holds within a factor of 2 or so
  ASSERT_EQ(warnOfResolution(r, lawsWith("Ageing")).size(), 1u);
  expectParts(warnOfResolution(r, lawsWith("Ageing"))[0].text,
              {"nucleation length, 47 m", "weakens, 23 m"});
  EXPECT_TRUE(warnOfResolution(r, lawsWith("Slip")).empty()); // 30 m
  EXPECT_EQ(warnOfResolution(r, lawsWith("Slip Weakening")).size(), 1u);
  r.unstable_wavelength = 1e5; // of slow slip: it says nothing of what weakens at high slip rates
  EXPECT_EQ(warnOfResolution(r, lawsWith("Slip")).size(), 1u);
  EXPECT_TRUE(warnOfResolution(r, lawsWith("Strong Rate Weakening")).empty());
  r.weakening_length = 24;
  EXPECT_TRUE(warnOfResolution(r, lawsWith("Ageing")).empty());
  // A block whose ends are free slides as a whole, however short it is.
  r.weakening_length = 1;
  r.weakens_everywhere = true;
  EXPECT_TRUE(warnOfResolution(r, lawsWith("Ageing")).empty());
}

// mu_s - mu_d = 0.2 where x < 1.5, sigma_n = 1e4 Pa and G' = 1e6 Pa.
TEST(ResolutionCheck, KnowsTheLengthsOfSlipWeakening)
{
  const auto deck = slipWeakening([](ParameterList& friction) {
    friction.set("Dynamic Friction Coefficient", "x < 1.5 ? 0.5 : 0.7");
  });
  auto const problem = makeProblem<2>(deck, world());
  const auto resolution = problem.scales.resolution;
  ASSERT_TRUE(resolution);
  EXPECT_NEAR(resolution->cohesive_zone, 9 * M_PI / 32 * 450, 1e-9);
  EXPECT_NEAR(resolution->nucleation_length, 1.158 * 450, 1e-9);
  EXPECT_EQ(resolution->slip_distance, 0.9);
  EXPECT_NEAR(resolution->weakening_length, 1.5, 1e-12);
}

// SCEC's barrier, mu_s = 10,000, and one by cohesion, where x > 1.5.
TEST(ResolutionCheck, LeavesOutWhatCannotSlip)
{
  for (auto const* barrier : {"Static Friction Coefficient", "Cohesion"}) {
    const auto deck = slipWeakening([&](ParameterList& friction) {
      friction.set("Dynamic Friction Coefficient", 0.5);
      friction.set(barrier, std::string(barrier) == "Cohesion" ? "x < 1.5 ? 0 : 1e9"
                                                               : "x < 1.5 ? 0.7 : 1e4");
    });
    auto const problem = makeProblem<2>(deck, world());
    ASSERT_TRUE(problem.scales.resolution) << barrier;
    EXPECT_NEAR(problem.scales.resolution->cohesive_zone, 9 * M_PI / 32 * 450, 1e-9) << barrier;
    EXPECT_NEAR(problem.scales.resolution->weakening_length, 1.5, 1e-12) << barrier;
    EXPECT_NEAR(problem.scales.barrier, 0.25, 1e-12) << barrier;
    EXPECT_FALSE(warns(describe(problem))) << barrier;
  }
  // The same stress is in reach where loads bring it.
  const auto loaded = slipWeakening([](ParameterList& friction) {
    friction.set("Static Friction Coefficient", "x < 1.5 ? 0.7 : 1e4");
    friction.set("Shear Traction", "1e7 * t");
  });
  EXPECT_EQ(makeProblem<2>(loaded, world()).scales.barrier, 0);
}

// Steady friction of strong rate weakening falls at high slip rates where a > b: from about 0.57 to
// f_w = 0.2, d(mu_ss) / d(ln V) is largest near V_w, as the closed form says.
TEST(ResolutionCheck, TakesTheLawsOwnSteadyFriction)
{
  const auto scales = [](char const* law, double weakened) {
    const auto deck = strip([&](ParameterList& given) {
      auto& friction = given.sublist("Friction");
      friction.set("a", 0.02).set("b", 0.014).set("State Evolution", law);
      if (weakened > 0) {
        friction.set("Weakened Friction Coefficient", weakened).set("Weakening Slip Rate", 0.1);
      }
    });
    return makeProblem<2>(deck, world()).scales;
  };
  EXPECT_FALSE(scales("Slip", 0).resolution);
  EXPECT_FALSE(scales("Strong Rate Weakening", 5).resolution); // friction rises
  auto const found = scales("Strong Rate Weakening", 0.2);
  ASSERT_TRUE(found.resolution);
  double fall = 0; // of f_w + (f_LV - f_w) / (1 + (V / V_w)^8)^(1/8)
  const auto steady = [](double log_V) {
    const double slow = 0.6 + 0.006 * (log_V - std::log(1e-6));
    return 0.2 + (slow - 0.2) / std::pow(1 + std::exp(8 * (log_V - std::log(0.1))), 0.125);
  };
  for (double x = std::log(1e-3); x < std::log(10.); x += 1e-3) {
    fall = std::max(fall, (steady(x) - steady(x + 1e-3)) / 1e-3);
  }
  // Over steps of a sixteenth of a decade.
  EXPECT_NEAR(found.resolution->unstable_wavelength, M_PI * 1e6 * 1e-5 / (fall * 1e4),
              0.05 * M_PI * 1e6 * 1e-5 / (fall * 1e4));
  EXPECT_EQ(found.weakening, std::vector<double>(3, 1e-5));
}

// A fault that strengthens, a > b, at V = 1e-9 m/s with the traction of 0.66 sigma_n: alpha =
// (0.66 - 0.6 - 0.02 ln(1e-3)) / 0.01. At 1e-6 m/s, the reference, ln(V theta / L) = alpha.
TEST(ResolutionCheck, KnowsTheZoneBehindAFrontWhereFrictionStrengthens)
{
  const auto deckOf = [](char const* law, double L) {
    return strip([&](ParameterList& given) {
      auto& friction = given.sublist("Friction");
      friction.set("a", 0.02).set("b", 0.01).set("State Evolution", law).set("L", L);
      friction.set("Shear Traction", 6600.);
      given.sublist("Initial State").set("Slip Rate", 1e-9).set("State", "Stress Balance");
    });
  };
  const double omega = (0.06 - 0.02 * std::log(1e-3)) / 0.01; // 19.8
  const auto zone = [](double L) { return 1e6 * L / (0.01 * 1e4); };
  for (const double L : {1e-3, 4.2e-3}) { // of 10 and 42 cells of 1 m under the ageing law
    const auto of_ageing = deckOf("Ageing", L), of_slip = deckOf("Slip", L);
    auto const ageing = makeProblem<2>(of_ageing, world()), slip = makeProblem<2>(of_slip, world());
    EXPECT_FALSE(slip.scales.resolution);
    ASSERT_TRUE(ageing.scales.front && slip.scales.front);
    EXPECT_NEAR(ageing.scales.front->cells, zone(L), 1e-3 * zone(L));
    EXPECT_NEAR(slip.scales.front->cells, zone(L) / omega, 1e-3 * zone(L));
    EXPECT_NEAR(slip.scales.front->length, zone(L) / omega, 1e-3 * zone(L));
    EXPECT_FALSE(warns(describe(ageing), "front of slip"));
    EXPECT_EQ(warns(describe(slip), "front of slip"), zone(L) < 2 * omega);
  }
}

TEST(ResolutionCheck, MeasuresThePartThatWeakens)
{
  // Nodes at x = 0, 1, 2 of a strip; the last one does not weaken.
  const auto resolution = [](char const* a) {
    const auto deck = strip([&](ParameterList& given) { given.sublist("Friction").set("a", a); });
    return makeProblem<2>(deck, world()).scales.resolution;
  };
  EXPECT_NEAR(resolution("x < 1.5 ? 0.01 : 0.02")->weakening_length, 1.5, 1e-12);
  EXPECT_FALSE(resolution("x < 1.5 ? 0.01 : 0.02")->weakens_everywhere);
  EXPECT_TRUE(resolution("x < 9 ? 0.01 : 0.02")->weakens_everywhere);
}

TEST(ResolutionCheck, AdvisesLowCellsWhereThereAreFew)
{
  const auto advice = [](double cells_per_zone, double height, std::string const& type,
                         std::vector<std::string> const& flat_beside = {}) {
    MeshSettings mesh;
    mesh.type = type;
    if (!flat_beside.empty()) {
      mesh.flat_cells = flat_beside;
    }
    for (auto const& line :
         describe({1, 1, 10, 47, 40, cells_per_zone, height, {0.035, 0.012}}, lawsWith("Ageing"),
                  adviceOnLowerCells(mesh, {"main", "splay"}))) {
      if (line.find("times as high as they are long") != std::string::npos) {
        return line;
      }
    }
    return std::string();
  };
  expectParts(advice(4, 1, "Box"), {"3.5 % for slip along and 1.2 % for slip across waves",
                                    "'Flat Cells at' makes them in a Box"});
  expectParts(advice(4, 1, "Rectangle"), {"The first cells of a Rectangle give"});
  const auto of_file = advice(4, 1, "File");
  expectParts(of_file, {"'Mesh / Flat Cells Beside' makes them"});
  EXPECT_EQ(of_file.find("first cells"), std::string::npos) << of_file;
  EXPECT_EQ(advice(4, 1, "File", {"main"}), of_file); // the splay has high cells
  const auto of_flat = advice(4, 1, "File", {"splay", "main", "ground"});
  expectParts(of_flat, {"times as high as they are long. Such bricks"});
  EXPECT_EQ(of_flat.find("Lower cells"), std::string::npos) << of_flat;
  EXPECT_EQ(of_flat.find("Flat Cells"), std::string::npos) << of_flat;
  EXPECT_EQ(advice(4, 0.577, "Box"), "");
  EXPECT_EQ(advice(20, 1, "Box"), "");
}

// Cubes, and bricks 0.577 and 0.3 times as high, cut to and fro, with 12 cells for a wave, by an
// independent computation: 9.9, 3.4 and 1.4 % along, 2.0, -0.2 and -0.9 % across.
TEST(ResolutionCheck, WarnsOfCellsFarHigherThanLong)
{
  const auto warned = [](int columns, double width) {
    const auto problem = makeProblem<2>(completeDeck([&](ParameterList& deck) {
                                          auto& size = deck.sublist("Mesh").sublist("Rectangle");
                                          size.set("Width", width).set("Height", 2.);
                                          size.set("Cells X", columns).set("Cells Y", 2);
                                        }),
                                        world());
    return warnOfCellShape(problem).has_value();
  };
  EXPECT_FALSE(warned(8, 2));   // 1 m high, 0.25 m long
  EXPECT_TRUE(warned(10, 2));   // 0.2 m long
  EXPECT_FALSE(warned(4, 0.4)); // 0.1 m long, and so is a quarter of the fault
}

TEST(ResolutionCheck, KnowsHowStiffBricksAre)
{
  const auto expect = [](double height, double along, double across) {
    auto const error = dynamics::stiffnessError(3, height, 12);
    EXPECT_NEAR(error.along.value(), along, 0.2 * along) << height;
    EXPECT_NEAR(error.across.value(), across, 0.003) << height;
  };
  expect(1, 0.099, 0.020);
  expect(0.577, 0.034, -0.002);
  expect(0.3, 0.014, -0.009);
  EXPECT_FALSE(dynamics::stiffnessError(1, 1, 24).along);
  // Squares in plane strain, 24 cells for a wave: 3.9 %.
  EXPECT_NEAR(dynamics::stiffnessError(2, 1, 24).along.value(), 0.039, 0.2 * 0.039);
  EXPECT_FALSE(dynamics::stiffnessError(2, 1, 24).across);
}

TEST(RunReport, WarnsOfALooseTolerance)
{
  const auto warned = [](double tolerance) {
    const auto deck = strip([&](ParameterList& given) {
      auto& time = given.sublist("Time Stepping");
      time.set("Control", "Richardson");
      time.sublist("Richardson").set("Tolerance", tolerance);
    });
    auto const warnings = describe(makeProblem<2>(deck, world())).warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [](Warning const& each) { return each.topic == "loose tolerance"; });
  };
  EXPECT_FALSE(warned(0.02));
  EXPECT_TRUE(warned(0.03));
}

TEST(ResolutionCheck, SaysNothingWhereFrictionDoesNotWeaken)
{
  const auto deck = strip([](ParameterList& given) { given.sublist("Friction").set("b", 0.01); });
  auto const problem = makeProblem<2>(deck, world());
  EXPECT_FALSE(problem.scales.resolution);
  for (auto const& line : describe(problem).lines) {
    EXPECT_EQ(line.find("Resolution"), std::string::npos) << line;
  }
}
} // namespace asperity::scenario
