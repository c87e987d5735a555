#include "fem/BodyMatrices.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "unit/fem/Constrained.hpp"
#include "verification/fault_stiffness/ForcesOfGiven.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

// What slip e^(ikx) between two half planes does to shear traction and compression, by the
// stiffness matrix of two bodies: one wavelength of them, whose sides are made one here, since
// meshes with faults are not periodic.
namespace asperity::verification
{
namespace
{
constexpr double off = 1e-9;
constexpr double wavenumber = 2 * M_PI; // of a wave as long as the box is wide, 1 m
constexpr double tolerance = 1e-2;

struct HalfPlane
{
  double shear_modulus; // Pa
  double poissons_ratio;

  fem::Material material() const
  {
    const double bulk_modulus =
      2 * shear_modulus * (1 + poissons_ratio) / (3 * (1 - 2 * poissons_ratio));
    return {1, bulk_modulus, shear_modulus, 0, 0};
  }
};

// Per unit slip of the upper past the lower half plane, in Pa/m: the shear traction falls by the
// first, and the compression rises by i times the second for e^(ikx), k > 0 (half_planes.py).
struct PerSlip
{
  double shear;
  double compression;
};

PerSlip exact(HalfPlane const& upper, HalfPlane const& lower)
{
  const double A = (1 - upper.poissons_ratio) / upper.shear_modulus +
                   (1 - lower.poissons_ratio) / lower.shear_modulus;
  const double B = ((1 - 2 * upper.poissons_ratio) / upper.shear_modulus -
                    (1 - 2 * lower.poissons_ratio) / lower.shear_modulus) /
                   2;
  return {wavenumber * A / (A * A - B * B), wavenumber * B / (A * A - B * B)};
}

// [0, 1] x [-1, 1] with the fault at y = 0, along which there are 64 cells. Both sides are alike.
GlobalMesh<2> box()
{
  auto mesh = mesh::bisect<2>(
    mesh::rectangleMesh({1, 2, 8, 16, {0, -1}}),
    mesh::largestDiameter<2>([](Point<2> const& x) { return 1. / 64 + 0.06 * std::abs(x[1]); }));
  mesh::addFaults<2>(mesh, {{"fault", [](Point<2> const& x) { return std::abs(x[1]) < off; }}});
  mesh::splitFaults(mesh, "test");
  return mesh;
}

class Wavelength
{
public:
  Wavelength(HalfPlane const& upper, HalfPlane const& lower)
      : body_(box(), {{"Fault", "fault", fem::ContactAcrossFault{{"fault"}}}})
  {
    std::vector<fem::Material> materials;
    for (auto const& cell : body_.mesh.cells) {
      double y = 0;
      for (int vertex : cell) {
        y += body_.mesh.vertices[vertex][1];
      }
      materials.push_back((y > 0 ? upper : lower).material());
    }
    matrices_ = fem::assembleBody<2>(body_.mesh, body_.dofs, body_.constraints.frames(), materials);
    number();
  }

  // For slip cos(kx), from the forces that hold it: the fall of the shear traction, its part of
  // cos(kx), and the rise of the compression, its part of -sin(kx).
  PerSlip measure() const
  {
    auto const forces = forcesOfSlip();
    PerSlip found{};
    double weight = 0;
    for (auto const& split : body_.mesh.splits) {
      const double x = body_.mesh.vertices[split.plus][0];
      if (x > 1 - off) {
        continue; // the node at x = 0
      }
      const fem::test::Constrained<2>::Value along =
        body_.row(split.plus, 0) * forces[number_[body_.dofs.dof(split.plus, 0)]] +
        body_.row(split.plus, 1) * forces[number_[body_.dofs.dof(split.plus, 1)]];
      const double spacing = 1 / static_cast<double>(body_.mesh.splits.size() - 1);
      found.shear += along[0] / spacing * std::cos(wavenumber * x);
      found.compression -= along[1] / spacing * std::sin(wavenumber * x);
      weight += std::pow(std::cos(wavenumber * x), 2);
    }
    return {found.shear / weight, found.compression / weight};
  }

private:
  // Unknowns get a number each, those on the right side that of the left one; prescribed ones are
  // those of jumps and of top and bottom.
  void number()
  {
    auto const& mesh = body_.mesh;
    std::map<std::pair<long long, bool>, int> on_the_left; // by height, and whether it is a jump
    std::vector<bool> is_plus(mesh.vertices.size(), false);
    for (auto const& split : mesh.splits) {
      is_plus[split.plus] = true;
    }
    const auto place = [&](int node) {
      return std::make_pair(std::llround(mesh.vertices[node][1] * 1e9), bool(is_plus[node]));
    };
    const int num_nodes = static_cast<int>(mesh.vertices.size());
    for (int node = 0; node < num_nodes; ++node) {
      if (mesh.vertices[node][0] < off) {
        on_the_left[place(node)] = node;
      }
    }
    std::vector<int> of_node(num_nodes, -1);
    for (int node = 0; node < num_nodes; ++node) {
      if (mesh.vertices[node][0] < 1 - off) {
        of_node[node] = num_unknowns_ / 2;
        num_unknowns_ += 2;
        const bool prescribed = is_plus[node] || std::abs(mesh.vertices[node][1]) > 1 - off;
        prescribed_.insert(prescribed_.end(), 2, prescribed);
      }
    }
    number_.resize(2 * num_nodes);
    for (int node = 0; node < num_nodes; ++node) {
      const int same = of_node[node] < 0 ? on_the_left.at(place(node)) : node;
      for (int c = 0; c < 2; ++c) {
        number_[body_.dofs.dof(node, c)] = 2 * of_node[same] + c;
      }
    }
  }

  // The stiffness with one number for both sides.
  Eigen::SparseMatrix<double> stiffness() const
  {
    auto const& A = *matrices_.stiffness;
    auto const local = A.getLocalMatrixHost();
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < local.numRows(); ++row) {
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
        const int column =
          A.getRowMap()->getLocalElement(A.getColMap()->getGlobalElement(local.graph.entries(k)));
        entries.emplace_back(number_[row], number_[column], local.values(k));
      }
    }
    Eigen::SparseMatrix<double> K(num_unknowns_, num_unknowns_);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
  }

  // At all unknowns, where the jump is (cos(kx), 0) and what is not prescribed is in balance.
  Eigen::VectorXd forcesOfSlip() const
  {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(num_unknowns_);
    for (auto const& split : body_.mesh.splits) {
      const double slip = std::cos(wavenumber * body_.mesh.vertices[split.plus][0]);
      for (int c = 0; c < 2; ++c) {
        u[number_[body_.dofs.dof(split.plus, c)]] = body_.row(split.plus, c)[0] * slip;
      }
    }
    return forcesOfGiven(stiffness(), prescribed_, u);
  }

  fem::test::Constrained<2> body_;
  fem::BodyMatrices matrices_;
  int num_unknowns_ = 0;
  std::vector<int> number_;      // of each dof
  std::vector<bool> prescribed_; // of each number
};

void expectExact(HalfPlane const& upper, HalfPlane const& lower)
{
  SCOPED_TRACE(::testing::Message()
               << upper.shear_modulus << " Pa, " << upper.poissons_ratio << " above "
               << lower.shear_modulus << " Pa, " << lower.poissons_ratio);
  auto const expected = exact(upper, lower);
  auto const found = Wavelength(upper, lower).measure();
  EXPECT_NEAR(found.shear, expected.shear, tolerance * expected.shear);
  if (expected.compression == 0) {
    EXPECT_NEAR(found.compression, 0, 1e-9 * expected.shear);
  } else {
    EXPECT_NEAR(found.compression / expected.compression, 1, tolerance);
  }
}
} // namespace

// Equal bodies: K = G k / (2 (1 - nu)), and the compression does not change.
TEST(PeriodicSlip, OfEqualBodies)
{
  const HalfPlane rock{3, 0.25};
  EXPECT_NEAR(exact(rock, rock).shear, 3 * wavenumber / (2 * 0.75), 1e-12);
  expectExact(rock, rock);
}

TEST(PeriodicSlip, OfDifferentBodies)
{
  expectExact({1, 0.25}, {4, 0.25});
  expectExact({4, 0.25}, {1, 0.25});
  expectExact({2, 0.3}, {1, 0.1});
  expectExact({1, 0.1}, {1, 0.4});
}
} // namespace asperity::verification
