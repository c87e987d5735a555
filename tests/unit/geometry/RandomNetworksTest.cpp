#include "BuiltChecks.hpp"

#include <random>

using namespace asperity::geometry;
using asperity::Point;

namespace
{
// Wavy faults at random places that cross each other, some of them through a hilly ground.
class Random
{
public:
  explicit Random(unsigned seed) : random_(seed) {}
  double between(double low, double high)
  {
    return low + (high - low) * double(random_()) / double(std::mt19937::max());
  }

private:
  std::mt19937 random_;
};

TriangleSurface wavyFault(Random& random)
{
  const double pi = std::acos(-1.);
  const double strike = random.between(0, pi), dip = random.between(40, 90) * pi / 180;
  const double length = random.between(12, 28) * km, width = random.between(10, 18) * km;
  const Point<3> centre = {random.between(-10, 10) * km, random.between(-10, 10) * km,
                           random.between(-3, 2) * km};
  const Point<3> along = {std::sin(strike), std::cos(strike), 0};
  const Point<3> down = {std::cos(strike) * std::cos(dip), -std::sin(strike) * std::cos(dip),
                         -std::sin(dip)};
  const auto normal = asperity::mesh::cross(along, down);
  const double height = random.between(50, 200); // cells follow the waves
  const double phases[] = {random.between(0, 2 * pi), random.between(0, 2 * pi)};
  const double waves[] = {random.between(8, 16) * km, random.between(8, 16) * km};
  return gridSurface(
    [&](double a, double b) {
      const double wave = height * std::sin(2 * pi * a * length / waves[0] + phases[0]) *
                          std::sin(2 * pi * b * width / waves[1] + phases[1]);
      return at(at(centre, (a - 0.5) * length, along, b * width, down), wave, normal, 0, normal);
    },
    static_cast<int>(length / 700), static_cast<int>(width / 700));
}

TriangleSurface hills()
{
  return gridSurface(
    [](double a, double b) {
      const double x = (120 * a - 60) * km, y = (120 * b - 60) * km, turn = 2 * std::acos(-1.);
      return Point<3>{x, y, 300 * std::sin(turn * x / (10 * km)) * std::cos(turn * y / (13 * km))};
    },
    80, 80);
}

class Networks : public testing::TestWithParam<unsigned>
{
};

TEST_P(Networks, AreMeshed)
{
  Random random(GetParam());
  std::vector<NamedSurface> faults;
  for (int i = 0; i < 6; ++i) {
    faults.push_back({"f" + std::to_string(i), wavyFault(random)});
  }
  const Box box = {{-45 * km, -45 * km, -40 * km}, {45 * km, 45 * km, 0}};
  const auto given = settings(faults, box, 1.5 * km, 8 * km, hills());
  const auto arranged = arrangeSurfaces(given);
  const auto mesh = meshOf(arranged, given);
  expectNames(mesh, given.model);
  expectAngles(mesh, arranged, given.model);
  expectEstimate(mesh, arranged, given);
  for (int s = 0; s < 6; ++s) {
    const double area = areaIn(arranged.complex, s);
    EXPECT_NEAR(areaOf(mesh, given.model.name(s)), area, 1e-3 * area) << given.model.name(s);
  }
  const double volume = 90. * 90 * 40 * km * km * km;
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-3 * volume);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Networks, testing::Range(1u, 6u));
// Minutes: only by `ctest -C benchmark -L geometry`.
INSTANTIATE_TEST_SUITE_P(MoreSeeds, Networks, testing::Range(6u, 21u));
} // namespace
