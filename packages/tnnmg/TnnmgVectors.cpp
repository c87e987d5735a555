#include "tnnmg/TnnmgVectors.hpp"

#include "base/parallel/Reductions.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_Map.hpp>

#include <array>
#include <cmath>

namespace asperity::tnnmg::detail
{
namespace
{
// The sum of the magnitudes of the terms that nearly cancel in a row of Z v - b = -r: b itself, Z v
// = b - r, and the terms of Z v. The last ones cancel where a node moves with its neighbours;
// together they are about twice as large as the term of the diagonal entry Z_ii.
KOKKOS_INLINE_FUNCTION
double estimatedTerms(double b, double r, double Z_ii, double v)
{
  return math::fabs(b) + math::fabs(b - r) + 2 * math::fabs(Z_ii * v);
}
} // namespace

TnnmgBlocks::TnnmgBlocks(NonlinearNodes const& nodes)
    : v("asperity::tnnmg::v", nodes.numNodes(), nodes.blockSize())
    , before("asperity::tnnmg::before", nodes.numNodes(), nodes.blockSize())
    , d("asperity::tnnmg::d", nodes.numNodes(), nodes.blockSize())
    , scaled("asperity::tnnmg::scaled", nodes.numNodes(), nodes.blockSize())
    , residual("asperity::tnnmg::residual", nodes.numNodes(), nodes.blockSize())
    , gradient("asperity::tnnmg::gradient", nodes.numNodes(), nodes.blockSize())
    , hessian("asperity::tnnmg::hessian", nodes.numNodes(), nodes.blockSize(), nodes.blockSize())
    , truncated("asperity::tnnmg::truncated", nodes.numNodes())
{
}

void TnnmgBlocks::differenceTo(BlockView const& reference, BlockView const& result) const
{
  auto const current = v;
  const int size = static_cast<int>(v.extent(1));
  Kokkos::parallel_for(
    "asperity::tnnmg::difference", RangePolicy(0, v.extent(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        result(node, k) = current(node, k) - reference(node, k);
      }
    });
}

void TnnmgBlocks::truncate(NonlinearNodes const& nodes, ConstNodeView const& curvature,
                           double stiff) const
{
  auto const flags = truncated;
  auto const H = hessian;
  auto const dofs = nodes.dofs;
  auto const held = nodes.held;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    "asperity::tnnmg::truncate", RangePolicy(0, nodes.numNodes()), KOKKOS_LAMBDA(int node) {
      bool all_held = true, soft = true;
      for (int k = 0; k < size; ++k) {
        for (int l = 0; l < size; ++l) {
          H(node, k, l) = held(dofs(node, k)) || held(dofs(node, l)) ? 0 : H(node, k, l);
        }
        all_held = all_held && held(dofs(node, k));
        soft = soft && H(node, k, k) <= stiff * curvature(node);
      }
      flags(node) = flags(node) || all_held || !soft;
    });
}

void TnnmgBlocks::scaleChange(double step) const
{
  auto const from = d;
  auto const to = scaled;
  const int size = static_cast<int>(d.extent(1));
  Kokkos::parallel_for(
    "asperity::tnnmg::scale", RangePolicy(0, d.extent(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        to(node, k) = step * from(node, k);
      }
    });
}

TnnmgVectors::TnnmgVectors(RateMatrix const& Z)
    : v_columns(rcp(new Vector(Z.columns())))
    , v(v_columns->offsetViewNonConst(Z.rows(), 0)->getVectorNonConst(0))
    , b(Z.rows())
    , v_before(Z.rows())
    , r(Z.rows())
    , r_before(Z.rows())
    , newton_residual(Z.rows())
    , c(Z.rows())
    , Zc(Z.rows())
{
}

void TnnmgVectors::begin(Vector const& right_side, Vector const& guess)
{
  Tpetra::deep_copy(b, right_side);
  Tpetra::deep_copy(*v, guess);
}

void TnnmgVectors::beginIteration()
{
  Tpetra::deep_copy(v_before, *v);
  Tpetra::deep_copy(r_before, r);
}

int TnnmgVectors::increasesInSweeps(RateMatrix const& Z, TnnmgBlocks const& blocks,
                                    EnergyChange const& nonlinear) const
{
  // With Z d = r_before - r, <Z v - b + 1/2 Z d, d> = -1/2 <r_before + r, d>; d is zero elsewhere.
  auto const d = blocks.d;
  auto const dofs = Z.nodes().dofs;
  auto const bs = b.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const now = r.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const before = r_before.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const vs = v->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const Z_ii = Z.diagonal().getLocalViewDevice(Tpetra::Access::ReadOnly);
  const int size = Z.nodes().blockSize();
  double linear = 0, terms = 0;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::changeInSweeps", RangePolicy(0, Z.nodes().numNodes()),
    KOKKOS_LAMBDA(int node, double& change, double& sum) {
      for (int k = 0; k < size; ++k) {
        const int i = dofs(node, k);
        change -= 0.5 * (before(i, 0) + now(i, 0)) * d(node, k);
        sum += 0.5 * math::fabs(d(node, k)) *
               (estimatedTerms(bs(i, 0), before(i, 0), Z_ii(i, 0), vs(i, 0)) +
                estimatedTerms(bs(i, 0), now(i, 0), Z_ii(i, 0), vs(i, 0)));
      }
    },
    linear, terms);
  auto const sums =
    sumOverRanks(std::array<double, 3>{linear + nonlinear.change, terms + nonlinear.magnitude,
                                       1. * size * Z.nodes().numNodes()},
                 *Z.rows()->getComm());
  EnergyChange all = {sums[0], sums[1]};
  if (all.countsAsIncrease(sums[2]) == 0) {
    return 0;
  }
  Vector change(*v, Teuchos::Copy);
  change.update(-1, v_before, 1);
  const double rows =
    0.5 * (magnitudeOfTerms(Z, v_before, r_before, change) + magnitudeOfTerms(Z, *v, r, change));
  all.magnitude = sumOverRanks(rows + nonlinear.magnitude, *Z.rows()->getComm());
  return all.countsAsIncrease(sums[2]);
}

double TnnmgVectors::magnitudeOfTerms(RateMatrix const& Z, Vector const& u, Vector const& r_of_u,
                                      Vector const& x) const
{
  Vector of_Zu(Z.rows());
  Z.sumMagnitudes(u, of_Zu);
  auto const terms = of_Zu.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const bs = b.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const rs = r_of_u.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const xs = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::magnitudeOfTerms", RangePolicy(0, bs.extent(0)),
    KOKKOS_LAMBDA(int i, double& sum) {
      sum += math::fabs(xs(i, 0)) *
             (math::fabs(bs(i, 0)) + math::fabs(bs(i, 0) - rs(i, 0)) + terms(i, 0));
    },
    result);
  return result;
}

void TnnmgVectors::newtonResidual(NonlinearNodes const& nodes, ConstBlockView const& gradient)
{
  Tpetra::deep_copy(newton_residual, r);
  auto const values = newton_residual.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = nodes.dofs;
  auto const held = nodes.held;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    "asperity::tnnmg::newtonResidual", RangePolicy(0, nodes.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        auto& value = values(dofs(node, k), 0);
        value = held(dofs(node, k)) ? 0 : value - gradient(node, k);
      }
    });
}

TnnmgVectors::Along TnnmgVectors::derivativeAlongCorrection(RateMatrix const& Z)
{
  Z.apply(c, Zc);
  auto const bs = b.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const rs = r.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const vs = v->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const Z_ii = Z.diagonal().getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const cs = c.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const Zcs = Zc.getLocalViewDevice(Tpetra::Access::ReadOnly);
  Along mine{};
  Kokkos::parallel_reduce(
    "asperity::tnnmg::derivativeAlongCorrection", RangePolicy(0, bs.extent(0)),
    KOKKOS_LAMBDA(int i, double& start, double& curvature, double& magnitude) {
      start -= rs(i, 0) * cs(i, 0);
      curvature += Zcs(i, 0) * cs(i, 0);
      magnitude += estimatedTerms(bs(i, 0), rs(i, 0), Z_ii(i, 0), vs(i, 0)) * math::fabs(cs(i, 0));
    },
    mine.start, mine.curvature, mine.magnitude);
  return mine;
}

void TnnmgVectors::move(double step)
{
  v->update(step, c, 1);
  r.update(-step, Zc, 1);
}

TnnmgVectors::Norms TnnmgVectors::norms(int failed_nodes) const
{
  // Z (v - v_before) = r_before - r.
  auto const bs = b.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const vs = v->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const rs = r.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const vs_before = v_before.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const rs_before = r_before.getLocalViewDevice(Tpetra::Access::ReadOnly);
  std::array<double, 3> mine{0, 0, static_cast<double>(failed_nodes)};
  Kokkos::parallel_reduce(
    "asperity::tnnmg::norms", RangePolicy(0, bs.extent(0)),
    KOKKOS_LAMBDA(int i, double& of_change, double& of_all) {
      of_change += (rs_before(i, 0) - rs(i, 0)) * (vs(i, 0) - vs_before(i, 0));
      of_all += (bs(i, 0) - rs(i, 0)) * vs(i, 0);
    },
    mine[0], mine[1]);
  auto const [change, of_v, failed] = sumOverRanks(mine, *v->getMap()->getComm());
  return {std::isfinite(change) ? std::sqrt(std::max(change, 0.)) : change,
          std::sqrt(std::max(of_v, 0.)), static_cast<int>(failed)};
}
} // namespace asperity::tnnmg::detail
