#include "WavesOnPlane.hpp"

#include "base/Errors.hpp"
#include "fem/BodyMatrices.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/problem/Problem.hpp"
#include "tnnmg/direct/EigenMatrix.hpp"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::bench
{
namespace
{
using ProblemInSpace = scenario::Problem<3>;

constexpr double window_of_wave = 3; // w k
constexpr double windows = 3.5;      // from the middle to where slip is cut off, 2e-3 of it

// The plane of a fault around its middle.
struct Plane
{
  fem::FaultNode middle;
  double extent; // from the middle to the nearest end [m]

  // Coordinates of a place in the plane, along the tangents of the middle [m].
  std::array<double, 2> coordinatesOf(std::array<double, 3> const& place) const
  {
    const auto from = mesh::difference<3>(place, middle.place);
    return {mesh::dot<3>(from, middle.tangents[0]), mesh::dot<3>(from, middle.tangents[1])};
  }
};

// The length of cells around the middle [m]: the root of a node's share of the fault, on average,
// since shares differ where cells are cut to and fro.
double cellAt(fem::FaultSurface const& surface, Plane const& plane)
{
  double sum = 0, share = 0;
  for (auto const& node : surface) {
    auto const x = plane.coordinatesOf(node.place);
    const double near =
      std::exp(-4.5 * (x[0] * x[0] + x[1] * x[1]) / (plane.extent * plane.extent));
    sum += near * node.weight;
    share += near;
  }
  return std::sqrt(sum / share);
}

Plane planeOf(fem::FaultSurface const& surface)
{
  ASPERITY_REQUIRE(surface.numNodes() > 0 && !surface.otherSide().is_inside,
                   "asperity-bench stiffness needs, in space, a fault that is a boundary of the "
                   "body.");
  Point<3> centre{};
  for (auto const& node : surface) {
    for (int d = 0; d < 3; ++d) {
      centre[d] += node.weight * node.place[d] / surface.totalWeight();
    }
  }
  auto const& middle =
    *std::min_element(surface.begin(), surface.end(), [&](auto const& a, auto const& b) {
      return mesh::distance<3>(a.place, centre) < mesh::distance<3>(b.place, centre);
    });
  Plane plane = {middle, 0};
  std::array<double, 2> low{}, high{};
  double off_plane = 0;
  for (auto const& node : surface) {
    auto const at = plane.coordinatesOf(node.place);
    for (int t = 0; t < 2; ++t) {
      low[t] = std::min(low[t], at[t]);
      high[t] = std::max(high[t], at[t]);
    }
    off_plane = std::max(
      off_plane,
      std::abs(mesh::dot<3>(mesh::difference<3>(node.place, middle.place), middle.normal)));
  }
  plane.extent = std::min({-low[0], -low[1], high[0], high[1]});
  ASPERITY_REQUIRE(plane.extent > 0, "asperity-bench stiffness: the fault is one cell wide. Use "
                                     "smaller cells.");
  ASPERITY_REQUIRE(off_plane <= 1e-6 * plane.extent,
                   "asperity-bench stiffness needs a plane fault in space; this deck's leaves the "
                   "plane of its middle by "
                     << off_plane << " m.");
  return plane;
}

// Slip along a tangent, with a wave along one.
struct WaveOnPlane
{
  double k;      // [1/m]
  int direction; // of the wave, 0 or 1
  int slip;      // 0 or 1

  double width() const { return window_of_wave / k; }
  double operator()(std::array<double, 2> const& x) const
  {
    const double w = width();
    return std::cos(k * x[direction]) * std::exp(-(x[0] * x[0] + x[1] * x[1]) / (2 * w * w));
  }
};

// The energy of a half space [J] that moves by `wave` (in m) along its surface, by the midpoint
// rule in wavenumbers: the integrand is smooth but at zero, where next to nothing of it lies.
double energyOfHalfSpace(WaveOnPlane const& wave, double shear_modulus, double along)
{
  const double w = wave.width();
  const auto transform = [&](double q_wave, double q_other) {
    const double near = std::exp(-0.5 * w * w * (q_wave - wave.k) * (q_wave - wave.k));
    const double far = std::exp(-0.5 * w * w * (q_wave + wave.k) * (q_wave + wave.k));
    return M_PI * w * w * (near + far) * std::exp(-0.5 * w * w * q_other * q_other);
  };
  constexpr int points = 200;
  const double end = wave.k + 6 / w, step = 2 * end / points;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const double q_wave = -end + (i + 0.5) * step, q_other = -end + (j + 0.5) * step;
      const double s = transform(q_wave, q_other);
      const double q_slip = wave.slip == wave.direction ? q_wave : q_other;
      const double q_across = wave.slip == wave.direction ? q_other : q_wave;
      sum += s * s * (along * q_slip * q_slip + shear_modulus * q_across * q_across) /
             std::hypot(q_wave, q_other);
    }
  }
  return 0.5 * sum * step * step / (4 * M_PI * M_PI);
}

// Bodies in equilibrium under given tangential displacements of their fault.
class Equilibrium
{
public:
  explicit Equilibrium(ProblemInSpace const& problem)
      : surface_(problem.surface())
      , given_(givenDofs(problem))
  {
    auto const& matrices = problem.model.body.matrices;
    auto const elasticity = fem::elasticityWeights(matrices);
    const auto drop = tnnmg::detail::StoredZeros::drop;
    K_ = tnnmg::detail::toEigen(*fem::combine(matrices, elasticity), drop);
    A_ = tnnmg::detail::toEigen(*fem::combine(matrices, elasticity, given_), drop);
    solver_.setTolerance(1e-8);
    solver_.compute(A_);
  }

  // The energy [J] of the body where its fault moves by a wave.
  double energy(Plane const& plane, WaveOnPlane const& wave) const
  {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(K_.rows());
    for (auto const& node : surface_) {
      const double slip = wave(plane.coordinatesOf(node.place));
      for (std::size_t t = 0; t < node.dofs.size(); ++t) {
        u[node.dofs[t]] = slip * mesh::dot<3>(node.tangents[t], plane.middle.tangents[wave.slip]);
      }
    }
    Eigen::VectorXd right_side = -(K_ * u);
    for (int dof : given_.owned()) {
      right_side[dof] = 0;
    }
    u += solver_.solve(right_side);
    ASPERITY_REQUIRE(solver_.info() == Eigen::Success,
                     "asperity-bench stiffness: conjugate gradients failed to solve for the body "
                     "in equilibrium.");
    return 0.5 * u.dot(K_ * u);
  }

private:
  // Dofs that boundary conditions hold, and those of the fault.
  static fem::HeldDofs givenDofs(ProblemInSpace const& problem)
  {
    auto flags = problem.model.body.held.flags();
    for (auto const& node : problem.surface()) {
      for (int dof : node.dofs) {
        flags[dof] = 1;
      }
    }
    return {flags, static_cast<int>(flags.size())}; // one rank owns all
  }

  fem::FaultSurface const& surface_;
  const fem::HeldDofs given_;
  Eigen::SparseMatrix<double> K_, A_;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                           Eigen::IncompleteCholesky<double>>
    solver_;
};
} // namespace

PlaneStiffness stiffnessOfPlane(ParameterList const& deck,
                                RCP<const Communicator> const& communicator)
{
  auto const problem = scenario::makeProblem<3>(deck, communicator);
  auto const& surface = problem.surface();
  auto const plane = planeOf(surface);
  PlaneStiffness result = {cellAt(surface, plane), plane.extent, {}};
  const int middle = surface.nodeAt(plane.middle.copies.front());
  auto const& rock = problem.fault_materials[middle];
  const double G = rock.shear_modulus, nu = rock.poissonsRatio();
  const double along =
    surface.otherSide().is_mirrored ? G / (1 - nu) : 4 * G * (1 - nu) / (3 - 4 * nu);
  const Equilibrium equilibrium(problem);
  for (int cells : {8, 12, 16, 24}) {
    const double k = 2 * M_PI / (cells * result.cell);
    if (windows * window_of_wave / k > plane.extent) {
      break;
    }
    // The mean of both directions of the wave, since cells may differ along them.
    std::array<double, 2> error{};
    for (int direction : {0, 1}) {
      for (int slip : {0, 1}) {
        const WaveOnPlane wave = {k, direction, slip};
        error[slip == direction ? 0 : 1] +=
          0.5 * (equilibrium.energy(plane, wave) / energyOfHalfSpace(wave, G, along) - 1);
      }
    }
    result.waves.push_back({cells, error[0], error[1]});
  }
  return result;
}
} // namespace asperity::bench
