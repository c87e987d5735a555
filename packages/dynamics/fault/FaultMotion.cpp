#include "dynamics/fault/FaultMotion.hpp"

#include "base/parallel/Reductions.hpp"
#include "friction/Length.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/RateMatrix.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
// blocks += Vp time / slip factor, the motion of the plates in a time [s].
void addPlates(fem::FaultSurface const& surface, double time, BlockView const& blocks)
{
  if (!surface.hasPlateRate()) {
    return;
  }
  auto const rates = surface.plateRates();
  const double factor = surface.slipFactor();
  const int size = surface.numTangents();
  Kokkos::parallel_for(
    "asperity::dynamics::addPlates", RangePolicy(0, surface.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        blocks(node, k) += rates(node * size + k) * time / factor;
      }
    });
}

// w = 0 at nodes where nothing but rounding is left of the sum of v_t and the motion of the plates.
void dropRounding(fem::FaultSurface const& surface, BlockView const& w)
{
  if (!surface.hasPlateRate()) {
    return;
  }
  constexpr double lost = 8 * std::numeric_limits<double>::epsilon();
  auto const rates = surface.plateRates();
  const double factor = surface.slipFactor();
  const int size = surface.numTangents();
  Kokkos::parallel_for(
    "asperity::dynamics::dropRounding", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node) {
      const double of_plates = motionOfPlates(rates, node, size, factor);
      double left = 0;
      for (int k = 0; k < size; ++k) {
        left = math::fabs(w(node, k)) > left ? math::fabs(w(node, k)) : left;
      }
      for (int k = 0; k < size && left <= lost * of_plates; ++k) {
        w(node, k) = 0;
      }
    });
}
} // namespace

bool gatherPrescribedPart(fem::FaultSurface const& surface, Vector const& prescribed_velocity,
                          BlockView const& blocks)
{
  // By rounding, a plate rate along a wall has components across the wall of up to this share.
  constexpr double rounding = 1e-9;
  auto const values = prescribed_velocity.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const dofs = surface.dofs();
  auto const held = surface.heldDofs();
  auto const slides = surface.slidingNodes();
  auto const rates = surface.plateRates();
  const double factor = surface.slipFactor();
  const bool plates = surface.hasPlateRate();
  const int size = surface.numTangents();
  int num_found = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::gatherPrescribedPart", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node, int& count) {
      const double of_plates = plates ? motionOfPlates(rates, node, size, factor) : 0;
      for (int k = 0; k < size; ++k) {
        const int dof = dofs(node, k);
        const double of_plate = plates ? rates(node * size + k) / factor : 0;
        const double w = slides(node) && held(dof) ? values(dof, 0) + of_plate : 0;
        blocks(node, k) = math::fabs(w) > rounding * of_plates ? w : 0;
        count += blocks(node, k) != 0 ? 1 : 0;
      }
    },
    num_found);
  return num_found > 0;
}

void gather(fem::FaultSurface const& surface, Vector const& v, BlockView const& blocks)
{
  tnnmg::gather(surface.dofs(), v, blocks);
}

void gatherSlip(fem::FaultSurface const& surface, Vector const& v, BlockView const& blocks)
{
  gather(surface, v, blocks);
  addPlates(surface, 1, blocks);
  dropRounding(surface, blocks);
}

void gatherSlipSince(fem::FaultSurface const& surface, ConstBlockView const& start, Vector const& u,
                     double time, BlockView const& blocks)
{
  gather(surface, u, blocks);
  const int size = surface.numTangents();
  Kokkos::parallel_for(
    "asperity::dynamics::sinceStart", RangePolicy(0, surface.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        blocks(node, k) -= start(node, k);
      }
    });
  addPlates(surface, time, blocks);
}

void setSlipRate(fem::FaultSurface const& surface, std::vector<double> const& rates, Vector& v)
{
  auto const values = v.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = surface.dofs();
  auto const held = surface.heldDofs();
  auto const slip = toDevice(rates, "asperity::dynamics::slipRates");
  auto const of_plates = surface.plateRates();
  const bool plates_move = surface.hasPlateRate();
  const double factor = surface.slipFactor();
  Kokkos::parallel_for(
    "asperity::dynamics::setSlipRate", RangePolicy(0, dofs.extent_int(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < dofs.extent_int(1); ++k) {
        const int i = node * dofs.extent_int(1) + k;
        if (!held(dofs(node, k))) {
          values(dofs(node, k), 0) = (slip(i) - (plates_move ? of_plates(i) : 0)) / factor;
        }
      }
    });
}

void setZeroSlipRate(fem::FaultSurface const& surface, Vector& v)
{
  if (!surface.hasPlateRate()) {
    return;
  }
  auto const values = v.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = surface.dofs();
  auto const held = surface.heldDofs();
  auto const rates = surface.plateRates();
  const double factor = surface.slipFactor();
  Kokkos::parallel_for(
    "asperity::dynamics::setZeroSlipRate", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < dofs.extent_int(1); ++k) {
        if (!held(dofs(node, k))) {
          values(dofs(node, k), 0) = -rates(node * dofs.extent_int(1) + k) / factor;
        }
      }
    });
}

void slipRate(fem::FaultSurface const& surface, ConstBlockView const& v, NodeView const& V)
{
  const bool is_plane = surface.numTangents() == 1;
  const double factor = surface.slipFactor();
  Kokkos::parallel_for(
    "asperity::dynamics::slipRate", RangePolicy(0, surface.numNodes()), KOKKOS_LAMBDA(int node) {
      V(node) = factor * (is_plane ? friction::length({v(node, 0)})
                                   : friction::length({v(node, 0), v(node, 1)}));
    });
}

double largestOf(ConstNodeView const& values)
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::largest", RangePolicy(0, values.extent(0)),
    KOKKOS_LAMBDA(int node, double& largest) {
      largest = values(node) > largest ? values(node) : largest;
    },
    Kokkos::Max<double>(result));
  return std::max(result, 0.); // a rank may have no nodes
}

double largestWhere(ConstFlagView const& flags, ConstNodeView const& values)
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::largestWhere", RangePolicy(0, values.extent(0)),
    KOKKOS_LAMBDA(int node, double& largest) {
      largest = flags(node) && values(node) > largest ? values(node) : largest;
    },
    Kokkos::Max<double>(result));
  return std::max(result, 0.); // a rank may have no nodes
}

double peakSlipRate(fem::FaultSurface const& surface, ConstNodeView const& V)
{
  return maxOverRanks(largestWhere(surface.countedNodes(), V), *surface.communicator());
}

namespace
{
// The largest |a - b| on this rank. A nan counts as an infinite difference; a plain maximum would
// ignore it.
double largestDifference(ConstNodeView const& a, ConstNodeView const& b)
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::largestDifference", RangePolicy(0, a.extent(0)),
    KOKKOS_LAMBDA(int node, double& largest) {
      const double difference = a(node) < b(node) ? b(node) - a(node) : a(node) - b(node);
      largest = difference <= largest ? largest : difference >= 0 ? difference : INFINITY;
    },
    Kokkos::Max<double>(result));
  return std::max(result, 0.); // a rank may have no nodes
}

// The sum of weight (a - b)^2 on this rank.
double sumOfSquares(ConstNodeView const& weight, ConstNodeView const& a, ConstNodeView const& b)
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::sumOfSquares", RangePolicy(0, weight.extent(0)),
    KOKKOS_LAMBDA(int node, double& sum) {
      const double difference = a(node) - b(node);
      sum += weight(node) * difference * difference;
    },
    result);
  return result;
}
} // namespace

double distance(fem::FaultSurface const& surface, ConstNodeView const& a, ConstNodeView const& b,
                Norm norm)
{
  auto const& communicator = *surface.communicator();
  if (norm == Norm::maximum) {
    return maxOverRanks(largestDifference(a, b), communicator);
  }
  const double sum = sumOverRanks(sumOfSquares(surface.weights(), a, b), communicator);
  return surface.numGlobalNodes() == 0 ? 0 : std::sqrt(sum / surface.totalWeight());
}
} // namespace asperity::dynamics
