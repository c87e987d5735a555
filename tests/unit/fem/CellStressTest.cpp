#include "fem/stress/CellStress.hpp"

#include "fem/stress/CoulombPlane.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <numeric>

// Strain and stress in cells against Hooke's law, and the stress on planes against tractions.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
constexpr double bulk = 7e4, shear = 3e4, bulk_viscosity = 50, shear_viscosity = 7;

template <int Dim>
Mesh<Dim> sampleMesh()
{
  auto whole = [] {
    if constexpr (Dim == 2) {
      return uniformRectangle(4, 3, 2, 1);
    } else {
      return uniformCube(2);
    }
  }();
  distort(whole, 0.05);
  return mesh::distribute(whole, *worldCommunicator());
}

// A linear displacement's gradient, (3, 3): antiplane the last row alone, in plane strain the
// leading block.
Eigen::Matrix3d gradientOf(int components, int sequence)
{
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const bool is_there = components == 1 ? i == 2 && k < 2 : components == 3 || (i < 2 && k < 2);
      gradient(i, k) = is_there ? pseudorandom(3 * i + k, sequence) : 0;
    }
  }
  return gradient;
}

template <int Dim>
std::vector<double> motion(Mesh<Dim> const& mesh, std::vector<int> const& vertices, int components,
                           Eigen::Matrix3d const& gradient)
{
  std::vector<double> values;
  for (int vertex : vertices) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    std::copy(mesh.vertices[vertex].begin(), mesh.vertices[vertex].end(), x.data());
    const Eigen::Vector3d u = gradient * x + Eigen::Vector3d(3, 1, 2);
    for (int c = 0; c < components; ++c) {
      values.push_back(components == 1 ? u[2] : u[c]);
    }
  }
  return values;
}

Eigen::Matrix3d strainOf(Eigen::Matrix3d const& gradient)
{
  return (gradient + gradient.transpose()) / 2;
}

Eigen::Matrix3d hooke(Eigen::Matrix3d const& gradient, double K, double G)
{
  auto const strain = strainOf(gradient);
  return (K - 2. / 3 * G) * strain.trace() * Eigen::Matrix3d::Identity() + 2 * G * strain;
}

void expectTensors(std::vector<double> const& found, int components,
                   Eigen::Matrix3d const& expected, std::size_t num_cells)
{
  auto const& names = tensorComponents(components);
  ASSERT_EQ(found.size(), num_cells * names.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    auto const& name = names[i % names.size()];
    EXPECT_NEAR(found[i], expected(name[0] - 'x', name[1] - 'x'), 1e-12 * expected.norm())
      << name << " of cell " << i / names.size();
  }
}

template <int Dim>
void expectHookesLaw(int components)
{
  auto const mesh = sampleMesh<Dim>();
  std::vector<int> cells(mesh.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  const std::vector<Material> materials(cells.size(),
                                        {1000, bulk, shear, bulk_viscosity, shear_viscosity});
  const CellStress<Dim> stress(mesh, components, materials, cells);
  EXPECT_TRUE(stress.isViscous());
  auto const of_u = gradientOf(components, 1), of_v = gradientOf(components, 2);
  auto const u = motion(mesh, stress.vertices(), components, of_u);
  auto const v = motion(mesh, stress.vertices(), components, of_v);
  expectTensors(stress.strain(u), components, strainOf(of_u), cells.size());
  expectTensors(stress.stress(u, v), components,
                hooke(of_u, bulk, shear) + hooke(of_v, bulk_viscosity, shear_viscosity),
                cells.size());
}
} // namespace

TEST(CellStress, IsThatOfHookesLawWhereTheStrainIsUniform)
{
  expectHookesLaw<2>(1);
  expectHookesLaw<2>(2);
  expectHookesLaw<3>(3);
}

// The branch strains by another displacement than the rest.
TEST(CellStress, HasTheStressOfMaxwellBranches)
{
  auto const mesh = sampleMesh<3>();
  const std::vector<Material> materials(mesh.cells.size(), {1000, bulk, shear, 0, 0});
  const std::vector<MaxwellBranch> branches = {
    {5, std::vector<double>(mesh.cells.size(), 0.4 * shear)}};
  const CellStress<3> stress(mesh, 3, materials, {2, 0}, branches);
  auto const of_u = gradientOf(3, 1), of_d = gradientOf(3, 2);
  auto const u = motion(mesh, stress.vertices(), 3, of_u);
  auto const d = motion(mesh, stress.vertices(), 3, of_d);
  expectTensors(stress.stress(u, {}, {d}), 3,
                hooke(of_u, bulk, 0.6 * shear) + hooke(of_d, 0, 0.4 * shear), 2);
}

TEST(CellStress, NeedsNoVelocityWithoutViscosity)
{
  auto const mesh = sampleMesh<2>();
  std::vector<Material> materials(mesh.cells.size(), {1000, bulk, shear, 0, 0});
  materials[1].bulk_modulus = 2 * bulk;
  const CellStress<2> stress(mesh, 2, materials, {1}); // one cell alone, of another material
  EXPECT_FALSE(stress.isViscous());
  EXPECT_EQ(stress.vertices().size(), 3u);
  auto const gradient = gradientOf(2, 1);
  expectTensors(stress.stress(motion(mesh, stress.vertices(), 2, gradient), {}), 2,
                hooke(gradient, 2 * bulk, shear), 1);
}

namespace
{
using Direction = std::array<double, 3>;

double onPlane(CoulombPlane const& plane, Eigen::Matrix3d const& sigma)
{
  std::vector<double> tensor;
  for (auto const& name : tensorComponents(3)) {
    tensor.push_back(sigma(name[0] - 'x', name[1] - 'x'));
  }
  return plane.stress(tensor, 3).at(0);
}

// Of this stress alone on both axes: the axes' numbers.
Eigen::Matrix3d shearing(int i, int k, double value)
{
  Eigen::Matrix3d sigma = Eigen::Matrix3d::Zero();
  sigma(i, k) = sigma(k, i) = value;
  return sigma;
}
} // namespace

TEST(CoulombPlane, StressIsThatOfTheTractionOnIt)
{
  const double mu = 0.35;
  auto const plane = CoulombPlane::inSpace(25, 50, 70, mu, {0, 1, 0}, {1, 0, 0});
  const Eigen::Vector3d n(plane.normal.data()), s(plane.slip.data());
  EXPECT_NEAR(n.norm(), 1, 1e-15);
  EXPECT_NEAR(s.norm(), 1, 1e-15);
  EXPECT_NEAR(n.dot(s), 0, 1e-15);
  auto const sigma = hooke(gradientOf(3, 5), bulk, shear);
  const Eigen::Vector3d traction = sigma * n;
  EXPECT_NEAR(onPlane(plane, sigma), s.dot(traction) + mu * n.dot(traction), 1e-11 * sigma.norm());
}

// Squeezed from the sides a thrust comes nearer to failure, a normal fault recedes.
TEST(CoulombPlane, CompressionLoadsAThrustAndUnclampingAnyPlane)
{
  const Direction y = {0, 1, 0}, z = {0, 0, 1}, x = {1, 0, 0};
  for (double strike : {0., 90., 200.}) {
    for (auto const& up : {y, z}) {
      const auto thrust = CoulombPlane::inSpace(strike, 30, 90, 0.4, up, x);
      const auto normal = CoulombPlane::inSpace(strike, 60, -90, 0.4, up, x);
      const Eigen::Vector3d n(thrust.normal.data()), vertical(up.data());
      const Eigen::Vector3d across = (n - n.dot(vertical) * vertical).normalized();
      const Eigen::Matrix3d squeeze = -1e6 * across * across.transpose();
      EXPECT_GT(onPlane(thrust, squeeze), 0) << "at strike " << strike;
      EXPECT_LT(onPlane(normal, squeeze), 0) << "at strike " << strike;
      EXPECT_NEAR(onPlane(thrust, 5 * Eigen::Matrix3d::Identity()), 0.4 * 5, 1e-14);
    }
  }
}

// With y up and x east north is -z, with z up it is y.
TEST(CoulombPlane, StrikeCountsFromNorthTowardsEast)
{
  auto const expectDirection = [](Direction const& found, Direction const& expected) {
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(found[d], expected[d], 1e-15) << d;
    }
  };
  const auto east = CoulombPlane::inSpace(90, 45, 0, 0, {0, 0, 2}, {3, 0, 1});
  expectDirection(east.slip, {1, 0, 0});
  const double half = std::sqrt(0.5);
  expectDirection(east.normal, {0, -half, half}); // it dips to the south
  const auto north = CoulombPlane::inSpace(0, 90, 0, 0, {0, 1, 0}, {1, 0, 0});
  expectDirection(north.slip, {0, 0, -1});
  expectDirection(north.normal, {1, 0, 0});
}

// sigma_xy > 0 drags what lies above along +x: a left lateral plane along x is unloaded.
TEST(CoulombPlane, KnowsWhereNoStressActs)
{
  for (double angle : {0., 30., 90.}) {
    EXPECT_FALSE(CoulombPlane::inPlane(angle, 180, 0.4).isLoaded(1)) << "antiplane";
    EXPECT_TRUE(CoulombPlane::inPlane(angle, -90, 0.4).isLoaded(1));
    EXPECT_TRUE(CoulombPlane::inPlane(angle, 0, 0).isLoaded(2)) << "plane strain";
    EXPECT_TRUE(CoulombPlane::inPlane(angle, 90, 0.4).isLoaded(2));
    EXPECT_FALSE(CoulombPlane::inPlane(angle, 90, 0).isLoaded(2));
  }
}

TEST(CoulombPlane, OfTwoDimensionsSlipsOnItsRight)
{
  const double tau = 3e5;
  auto const level = [&](double angle, double rake) {
    return onPlane(CoulombPlane::inPlane(angle, rake, 0), shearing(0, 1, tau));
  };
  EXPECT_NEAR(level(0, 0), -tau, 1e-9);
  EXPECT_NEAR(level(0, 180), tau, 1e-9);
  EXPECT_NEAR(level(180, 180), tau, 1e-9) << "the other side of the same plane";
  EXPECT_NEAR(level(90, 180), -tau, 1e-9);

  auto const upright = CoulombPlane::inPlane(90, 90, 0.6); // the side +x slips along +z
  EXPECT_NEAR(upright.stress({tau, 0}, 1).at(0), tau, 1e-9) << "antiplane: xz, yz";

  // A thrust that dips to +x at 30 degrees, y up: up the dip is at 150 degrees.
  auto const thrust = CoulombPlane::inPlane(150, 0, 0.4);
  EXPECT_GT(thrust.stress({-1e6, 0, 0, -3e5}, 2).at(0), 0) << "xx, xy, yy, zz";
}
} // namespace asperity::fem
