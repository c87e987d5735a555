#include "ForcesInBalance.hpp"

#include <gtest/gtest.h>

#include <cmath>

// How stiff a fault is on a mesh: the traction that slip cos(kx) makes, divided by that of the
// half plane. With cells of size h along the fault the error is a series in even powers of kh, and
// the shape of the cells beside the fault decides on it. In rows of right triangles of height H the
// antiplane traction is, by the difference equation that is their stencil,
//
//   G k sin(kh/2)/(kh/2) sqrt(1 + (H/h)^2 sin(kh/2)^2)
//     = G k (1 + (kh)^2 (H^2/(8 h^2) - 1/24) + ...)
//
// so that the fault is too stiff by (kh)^2/12 beside squares, and by nothing of second order for
// H = h/sqrt(3). Equilateral triangles have the same error, since they are isotropic. In plane
// strain the free motion across the fault adds an error. Rows of triangles, shifted by h/2 to and
// fro, whose heights grow from 0.35 h by 4 % from row to row have next to none: those of
// xml/meshes/bp3.geo.
namespace asperity::verification
{
namespace
{
constexpr double shear_modulus = 3;
constexpr double poissons_ratio = 0.25;

// Beside a fault at y = 0: the first row is `height` h high, each one `growth` times as high as the
// last, up to 3 h, and shifted by `shift` h against it.
struct Rows
{
  double height;
  double shift; // 0, or 0.5 to and fro
  double growth = 1;
};

constexpr Rows squares = {1, 0};
const Rows narrow = {1 / std::sqrt(3.), 0};
const Rows equilateral = {std::sqrt(3.) / 2, 0.5};
constexpr Rows of_bp3 = {0.35, 0.5, 1.04};

constexpr double close = 1e-9;

// The y of the rows, up to 2 m.
std::vector<double> heights(double h, Rows const& rows)
{
  std::vector<double> result = {0};
  for (double height = rows.height * h; result.back() < 2 - close; height *= rows.growth) {
    result.push_back(result.back() + std::min(height, 3 * h));
  }
  return result;
}

// One wavelength, of 1 m, with n cells, and periodic.
GlobalMesh<2> wavelength(int n, Rows const& rows)
{
  const double h = 1. / n;
  auto const ys = heights(h, rows);
  const int num_rows = static_cast<int>(ys.size()) - 1;
  GlobalMesh<2> mesh;
  mesh.period = {1, 0};
  mesh.region_names = {"body"};
  const auto vertex = [n](int column, int row) { return row * n + column % n; };
  for (int row = 0; row <= num_rows; ++row) {
    for (int column = 0; column < n; ++column) {
      mesh.vertices.push_back({(column + (row % 2) * rows.shift) * h, ys[row]});
    }
  }
  for (int row = 0; row < num_rows; ++row) {
    // The vertex above `column` lies to its right by the shift, or to its left.
    const int lean = rows.shift > 0 ? row % 2 : 0;
    for (int column = 0; column < n; ++column) {
      const int a = vertex(column, row), b = vertex(column + 1, row);
      const int c = vertex(column + lean, row + 1), d = vertex(column + lean + 1, row + 1);
      mesh.cells.push_back({a, b, c});
      mesh.cells.push_back({b, d, c});
    }
  }
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  for (int column = 0; column < n; ++column) {
    mesh.boundaries["fault"].push_back({vertex(column, 0), vertex(column + 1, 0)});
    mesh.boundaries["top"].push_back({vertex(column + 1, num_rows), vertex(column, num_rows)});
  }
  return mesh;
}

// The relative error of the traction along the fault, with n cells for a wavelength; what is across
// the fault is free, as it is by symmetry between two bodies that are alike.
double errorOf(Rows const& rows, int components, int n)
{
  auto const mesh = wavelength(n, rows);
  const auto at_fault = [](Point<2> const& x) { return x[1] < close; };
  const double highest = mesh.vertices.back()[1];
  // The first component of the fault moves by cos(kx), and the top rests.
  const auto forces = forcesInBalance<2>(mesh, components, {shear_modulus, poissons_ratio},
                                         [&](Point<2> const& x, int component) {
                                           if (at_fault(x) && component == 0) {
                                             return Motion{true, std::cos(2 * M_PI * x[0])};
                                           }
                                           return Motion{x[1] > highest - close, 0};
                                         });
  double traction = 0;
  for (std::size_t node = 0; node < mesh.vertices.size(); ++node) {
    auto const& x = mesh.vertices[node];
    if (at_fault(x)) {
      traction += 2 * forces[static_cast<int>(node) * components] * std::cos(2 * M_PI * x[0]);
    }
  }
  const double exact = 2 * M_PI * shear_modulus / (components == 1 ? 1 : 1 - poissons_ratio);
  return traction / exact - 1;
}

double square(double x) { return x * x; }
} // namespace

TEST(FaultStiffness, HasAnErrorOfSecondOrderOnSquares)
{
  for (int n : {12, 24, 48}) {
    const double s = std::sin(M_PI / n);
    EXPECT_NEAR(errorOf(squares, 1, n), s / (M_PI / n) * std::sqrt(1 + s * s) - 1, 1e-9) << n;
  }
  EXPECT_NEAR(errorOf(squares, 1, 48) / (square(2 * M_PI / 48) / 12), 1, 0.02);
  for (int components : {1, 2}) {
    EXPECT_NEAR(errorOf(squares, components, 24) / errorOf(squares, components, 48), 4, 0.4);
  }
}

TEST(FaultStiffness, HasAnErrorOfFourthOrderOnNarrowRowsForAntiplaneSlip)
{
  for (int n : {12, 24, 48}) {
    const double s = std::sin(M_PI / n);
    EXPECT_NEAR(errorOf(narrow, 1, n), s / (M_PI / n) * std::sqrt(1 + s * s / 3) - 1, 1e-9) << n;
  }
  EXPECT_GE(errorOf(narrow, 1, 12) / errorOf(narrow, 1, 24), 12);
}

TEST(FaultStiffness, IsThatOfNarrowRowsOnEquilateralTrianglesForAntiplaneSlip)
{
  for (int n : {12, 24, 48}) {
    EXPECT_NEAR(errorOf(equilateral, 1, n), errorOf(narrow, 1, n), 1e-9) << n;
  }
}

// The limits were chosen when 0.012 and 0.024 were known. Antiplane slip is not asked for: it
// wants narrow rows, and has an error of 0.2 % here. A wave of 24 cells: as many as a cohesive zone
// of six cells, a quarter of a wave, asks for.
TEST(FaultStiffness, HasAFiftiethOfTheErrorOnTheRowsOfBp3InPlaneStrain)
{
  EXPECT_LE(std::abs(errorOf(of_bp3, 2, 24)), 0.02 * errorOf(squares, 2, 24));
  EXPECT_LE(std::abs(errorOf(of_bp3, 2, 24)), 0.05 * errorOf(equilateral, 2, 24));
}
} // namespace asperity::verification
