#include "dynamics/processes/DiffusionStep.hpp"

#include "base/Errors.hpp"
#include "base/Views.hpp"
#include "dynamics/State.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
const double gamma_of_stages = 1 - std::sqrt(0.5);
constexpr double tolerance = 1e-12;     // of the residual over the right side
constexpr int max_iterations = 1000;    // a matrix that needs more is too badly conditioned
constexpr std::size_t most_systems = 8; // a control goes back and forth between fewer step sizes

void setHost(std::vector<double> const& values, Vector& x)
{
  auto const host = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i, 0) = values[i];
  }
}

// x(num_nodes) = 0 where the flag is set
void clear(ConstFlagView const& flags, Vector& x)
{
  auto const values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::dynamics::clearFixed", RangePolicy(0, flags.extent(0)),
    KOKKOS_LAMBDA(int node) { values(node, 0) = flags(node) == 1 ? 0 : values(node, 0); });
}

RCP<Vector> vectorOf(CrsMatrix const& K) { return rcp(new Vector(K.getRowMap())); }
} // namespace

// S + gamma tau K without the rows and columns of fixed nodes, whose diagonal is 1.
struct DiffusionStep::System
{
  System(double gamma_times_tau, CrsMatrix const& K, std::vector<double> const& S,
         std::vector<bool> const& is_fixed)
      : gamma_tau(gamma_times_tau)
      , storage(vectorOf(K))
      , z(vectorOf(K))
      , d(vectorOf(K))
      , product(vectorOf(K))
      , r(vectorOf(K))
  {
    setHost(S, *storage);
    fixed = toDevice(std::vector<int>(is_fixed.begin(), is_fixed.end()),
                     "asperity::dynamics::fixedPressure");
    factorise(K, S, is_fixed);
  }

  void factorise(CrsMatrix const& K, std::vector<double> const& S,
                 std::vector<bool> const& is_fixed)
  {
    auto const local = K.getLocalMatrixHost();
    const auto size = static_cast<int>(S.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < size; ++row) {
      entries.emplace_back(row, row, is_fixed[row] ? 1 : S[row]);
      for (auto e = local.graph.row_map(row); e < local.graph.row_map(row + 1); ++e) {
        const int column = local.graph.entries(e);
        if (column < size && !is_fixed[row] && !is_fixed[column]) {
          entries.emplace_back(row, column, gamma_tau * local.values(e));
        }
      }
    }
    Eigen::SparseMatrix<double> block(size, size);
    block.setFromTriplets(entries.begin(), entries.end());
    if (size > 0) {
      factors.compute(block);
      is_definite = factors.info() == Eigen::Success;
    }
  }

  void clearFixed(Vector& x) const { clear(fixed, x); }

  // product = (S + gamma tau K) d, for d that is zero at fixed nodes.
  void multiply(CrsMatrix const& K)
  {
    K.apply(*d, *product, Teuchos::NO_TRANS, gamma_tau, 0);
    product->elementWiseMultiply(1, *storage, *d, 1);
    clearFixed(*product);
  }

  // z = r preconditioned, on the host; without factors nan, which ends the iteration on all ranks
  void precondition()
  {
    if (!is_definite) {
      z->putScalar(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    auto const from = r->getLocalViewHost(Tpetra::Access::ReadOnly);
    auto const to = z->getLocalViewHost(Tpetra::Access::OverwriteAll);
    const auto size = static_cast<Eigen::Index>(from.extent(0));
    if (size > 0) {
      Eigen::Map<Eigen::VectorXd>(&to(0, 0), size) =
        factors.solve(Eigen::Map<const Eigen::VectorXd>(&from(0, 0), size));
    }
  }

  // Whether x has become the solution for the right side b, which is zero at fixed nodes. Conjugate
  // gradients of its own: Belos makes a solver with new vectors for each solve, and there are two
  // in each step, which need one or two iterations each on one rank, where the factor is exact.
  // multigrid::FloatConjugateGradients are in single precision, which is too coarse for
  // `tolerance`, and need a V-cycle.
  bool solve(CrsMatrix const& K, Vector const& b, Vector& x)
  {
    x.putScalar(0);
    r->assign(b);
    const double bound = tolerance * b.norm2();
    double rho = 0;
    for (int i = 0; i < max_iterations; ++i) {
      const double norm = r->norm2();
      if (norm <= bound || !std::isfinite(norm)) {
        return norm <= bound;
      }
      precondition();
      const double rho_before = rho;
      rho = r->dot(*z);
      if (i == 0) {
        d->assign(*z);
      } else {
        d->update(1, *z, rho / rho_before);
      }
      multiply(K);
      const double step = rho / d->dot(*product);
      x.update(step, *d, 1);
      r->update(-step, *product, 1);
    }
    return false;
  }

  double gamma_tau; // [s]
  ConstFlagView fixed;
  RCP<Vector> storage, z, d, product, r;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors; // of this rank's block
  bool is_definite = true;
};

DiffusionStep::DiffusionStep(RCP<const CrsMatrix> const& K, std::vector<double> const& S,
                             std::vector<bool> const& is_fixed)
    : K_(K)
    , S_(S)
    , is_fixed_(is_fixed)
    , p_(vectorOf(*K))
    , q_(vectorOf(*K))
    , first_(vectorOf(*K))
    , second_(vectorOf(*K))
    , right_side_(vectorOf(*K))
{
}

DiffusionStep::~DiffusionStep() = default;

double DiffusionStep::timeIn(int k) { return 0.5 + (k == 0 ? -1 : 1) / std::sqrt(12.); }

// Keeps the factors of the last sizes of steps.
DiffusionStep::System& DiffusionStep::systemOf(double gamma_tau)
{
  auto const found = std::find_if(systems_.begin(), systems_.end(), [&](auto const& system) {
    return system->gamma_tau == gamma_tau;
  });
  if (found == systems_.end()) {
    if (systems_.size() == most_systems) {
      systems_.pop_back();
    }
    systems_.insert(systems_.begin(), std::make_unique<System>(gamma_tau, *K_, S_, is_fixed_));
  } else {
    std::rotate(systems_.begin(), found, found + 1);
  }
  return *systems_.front();
}

// rate := (S + gamma tau K)^-1 (q - K p), zero at fixed nodes.
void DiffusionStep::rateOfStage(System& system, Vector const& p, Vector& rate)
{
  right_side_->assign(*q_);
  K_->apply(p, *right_side_, Teuchos::NO_TRANS, -1, 1);
  system.clearFixed(*right_side_);
  if (!system.solve(*K_, *right_side_, rate)) {
    throw SolveError("The diffusion of the pore pressure on the fault could not be solved for a "
                     "step of " +
                     std::to_string(system.gamma_tau / gamma_of_stages) +
                     " s. Check the fields of Friction / Pore Pressure: permeability, storage and "
                     "width may differ by too many powers of ten.");
  }
}

void DiffusionStep::advance(double tau, ConstNodeView const& p0, Sources const& q,
                            NodeView const& p1)
{
  auto& system = systemOf(gamma_of_stages * tau);
  std::vector<double> at_stage(S_.size());
  const auto setSource = [&](double time) {
    const double share = (time - timeIn(0)) / (timeIn(1) - timeIn(0));
    for (std::size_t i = 0; i < at_stage.size(); ++i) {
      at_stage[i] = q[0][i] + share * (q[1][i] - q[0][i]);
    }
    setHost(at_stage, *q_);
  };
  Kokkos::deep_copy(overwritten(p_), p0);
  setSource(gamma_of_stages);
  rateOfStage(system, *p_, *first_);
  p_->update((1 - gamma_of_stages) * tau, *first_, 1);
  setSource(1);
  rateOfStage(system, *p_, *second_);
  p_->update(gamma_of_stages * tau, *second_, 1);
  Kokkos::deep_copy(p1, valuesOf(p_));
}
} // namespace asperity::dynamics
