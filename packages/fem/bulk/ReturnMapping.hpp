#pragma once

#include "base/Views.hpp"
#include "fem/bulk/History.hpp"
#include "fem/bulk/InelasticStrain.hpp"
#include "fem/bulk/TensorKernels.hpp"
#include "portability/Renamed.hpp"
#include "registry/LawParameters.hpp"

#include <cstddef>
#include <type_traits>

// How rock yields within a step. Let s be the deviatoric stress of a cell at the end of the step if
// its strain were elastic (the trial), t = sqrt(s : s / 2), and p the mean stress. Then
//   s1 = t1 / t s,   e1 = e0 + (s - s1) / 2G + (p - p1) / 3K I,   gamma1 = gamma0 + (t - t1) / G
// with the inelastic strain e and its accumulated shear gamma. A law gives t1, 0 <= t1 <= t, and,
// where rock dilates, p1 <= p; else p1 = p and the flow is isochoric. The stress is the gradient of
// a convex potential of the strain, whose second derivative nowhere exceeds that of elastic rock,
// where t1 is a function of t with a slope from 0 to 1, and in associated flow.
namespace asperity::fem
{
// What a law knows of a cell in a step.
struct Trial
{
  double shear_stress;  // t [Pa]
  double mean_stress;   // a third of the trace [Pa], positive in tension; 0 antiplane
  double shear;         // gamma0 [-]
  double shear_modulus; // G [Pa]
  double bulk_modulus;  // K [Pa]; 0 antiplane
  double step;          // its length [s]; infinity: t1 is what the rock bears at the start
};

// The cells of one law in a step; all views but `cells` are of all cells that may yield.
struct YieldingCells
{
  IndexView cells; // (num of the law) among those that may yield

  ConstNodeView shear_modulus, bulk_modulus; // [Pa]; bulk_modulus is 0 antiplane
  ConstTensorView initial_stress;            // [Pa], of which the deviatoric part counts
  ConstNodeView initial_mean;                // [Pa]
  ConstTensorView strain;                    // at the end of the step
  ConstTensorView inelastic_before;
  ConstTensorView shear_before; // (num_cells, 1)
  ConstTensorView history_before;
  int column;  // of the law's history, the first one
  double step; // [s]

  TensorView inelastic;  // e1
  TensorView shear;      // gamma1 (num_cells, 1)
  TensorView history;    // at the end
  NodeView shear_stress; // t [Pa]
};

// sqrt(s : s / 2) of a symmetric tensor.
KOKKOS_INLINE_FUNCTION double shearOf(double const* s, int size)
{
  double square = 0;
  for (int k = 0; k < size; ++k) {
    square += multiplicity(size, k) * s[k] * s[k] / 2;
  }
  return math::sqrt(square);
}

// The trial stress of a cell.
struct TrialStress
{
  int size = 0; // num of components
  double deviator[most_tensor_components] = {};
  double mean = 0, shear_stress = 0;

  KOKKOS_INLINE_FUNCTION TrialStress(YieldingCells const& yielding, int cell)
      : size(yielding.strain.extent_int(1))
  {
    double trace = 0;
    mean = yielding.initial_mean(cell);
    for (int k = 0; k < size; ++k) {
      const double elastic = yielding.strain(cell, k) - yielding.inelastic_before(cell, k);
      deviator[k] = yielding.initial_stress(cell, k) + 2 * yielding.shear_modulus(cell) * elastic;
      trace += isOnDiagonal(size, k) ? deviator[k] : 0;
      mean += isOnDiagonal(size, k) ? yielding.bulk_modulus(cell) * elastic : 0;
    }
    for (int k = 0; k < size; ++k) {
      deviator[k] -= isOnDiagonal(size, k) ? trace / 3 : 0;
    }
    shear_stress = shearOf(deviator, size);
  }
};

// What rock with a history of its own does in a step.
struct InelasticChange
{
  double strain[most_tensor_components] = {}; // e1 - e0
  double shear = 0;                           // gamma1 - gamma0
};

// One row of a table on the device.
struct TensorRow
{
  ConstTensorView values;
  int row;

  KOKKOS_INLINE_FUNCTION double operator()(std::size_t column) const { return values(row, column); }
};

template <class Law, class = void>
struct Dilates : std::false_type
{
};
template <class Law>
struct Dilates<Law, std::void_t<decltype(&Law::meanStress)>> : std::true_type
{
};

// The law in each cell, from the rows of values(num_cells, num_parameters).
template <class Law>
Kokkos::View<const Law*, MemorySpace> loadLaws(ConstTensorView const& values)
{
  const Kokkos::View<Law*, MemorySpace> laws(
    Kokkos::view_alloc("asperity::fem::laws", Kokkos::WithoutInitializing), values.extent(0));
  Kokkos::parallel_for(
    "asperity::fem::loadLaws", RangePolicy(0, laws.extent_int(0)), KOKKOS_LAMBDA(int cell) {
      laws(cell) = loadLaw<Law>(TensorRow{values, cell});
    });
  return laws;
}

// Law::shearStress(Trial) is t1, and Law::meanStress, where there is one, p1. A law with a history
// of its own has Law::respond instead, which returns the change and updates the history.
template <class Law>
struct ReturnMapping
{
  Kokkos::View<const Law*, MemorySpace> laws; // (num of the law)
  YieldingCells yielding;

  KOKKOS_FUNCTION void operator()(int i) const
  {
    const int cell = yielding.cells(i);
    const double G = yielding.shear_modulus(cell);
    const TrialStress trial(yielding, cell);
    const double K = yielding.bulk_modulus(cell);
    const double t = trial.shear_stress;
    const Trial of_cell = {t, trial.mean, yielding.shear_before(cell, 0), G, K, yielding.step};
    yielding.shear_stress(cell) = t;
    if constexpr (HasHistory<Law>::value) {
      respond(i, cell, trial, of_cell);
    } else {
      returnTo(i, cell, trial, of_cell);
    }
  }

  KOKKOS_FUNCTION void respond(int i, int cell, TrialStress const& trial,
                               Trial const& of_cell) const
  {
    auto history = loadHistory<Law>(yielding.history_before, cell, yielding.column, trial.size);
    const InelasticChange change = laws(i).respond(trial, of_cell, history);
    storeHistory<Law>(history, yielding.history, cell, yielding.column, trial.size);
    for (int k = 0; k < trial.size; ++k) {
      yielding.inelastic(cell, k) = yielding.inelastic_before(cell, k) + change.strain[k];
    }
    yielding.shear(cell, 0) = yielding.shear_before(cell, 0) + change.shear;
  }

  KOKKOS_FUNCTION void returnTo(int i, int cell, TrialStress const& trial,
                                Trial const& of_cell) const
  {
    const double G = of_cell.shear_modulus, K = of_cell.bulk_modulus, t = of_cell.shear_stress;
    const double t1 = laws(i).shearStress(of_cell);
    const double lost = t > 0 ? (t - t1) / t : 0;
    double opened = 0;
    if constexpr (Dilates<Law>::value) {
      opened = K > 0 ? (trial.mean - laws(i).meanStress(of_cell)) / (3 * K) : 0;
    }
    for (int k = 0; k < trial.size; ++k) {
      yielding.inelastic(cell, k) = yielding.inelastic_before(cell, k) +
                                    lost * trial.deviator[k] / (2 * G) +
                                    (isOnDiagonal(trial.size, k) ? opened : 0);
    }
    yielding.shear(cell, 0) = yielding.shear_before(cell, 0) + (t - t1) / G;
  }

  void run() const
  {
    Kokkos::parallel_for("asperity::fem::returnMapping",
                         RangePolicy(0, yielding.cells.extent_int(0)), *this);
  }
};
} // namespace asperity::fem
