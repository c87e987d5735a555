#pragma once

#include "base/Views.hpp"
#include "fem/bulk/InelasticStrain.hpp"
#include "fem/bulk/TensorKernels.hpp"
#include "portability/Renamed.hpp"

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

// The cells of one law in a step; all views but `cells` and `parameters` are of all cells that may
// yield.
struct YieldingCells
{
  IndexView cells;            // (num of the law) among those that may yield
  ConstTensorView parameters; // (num of the law, parameters)

  ConstNodeView shear_modulus, bulk_modulus; // [Pa]; bulk_modulus is 0 antiplane
  ConstTensorView initial_stress;            // [Pa], of which the deviatoric part counts
  ConstNodeView initial_mean;                // [Pa]
  ConstTensorView strain;                    // at the end of the step
  ConstTensorView inelastic_before;
  ConstTensorView shear_before; // (num_cells, 1)
  double step;                  // [s]

  TensorView inelastic;  // e1
  TensorView shear;      // gamma1 (num_cells, 1)
  NodeView shear_stress; // t [Pa]
};

// The trial stress of a cell.
struct TrialStress
{
  static constexpr int most = 6;
  double deviator[most] = {};
  double mean = 0, shear_stress = 0;

  KOKKOS_INLINE_FUNCTION TrialStress(YieldingCells const& of, int cell)
  {
    const int size = of.strain.extent_int(1);
    double trace = 0;
    mean = of.initial_mean(cell);
    for (int k = 0; k < size; ++k) {
      const double elastic = of.strain(cell, k) - of.inelastic_before(cell, k);
      deviator[k] = of.initial_stress(cell, k) + 2 * of.shear_modulus(cell) * elastic;
      trace += isOnDiagonal(size, k) ? deviator[k] : 0;
      mean += isOnDiagonal(size, k) ? of.bulk_modulus(cell) * elastic : 0;
    }
    double square = 0;
    for (int k = 0; k < size; ++k) {
      deviator[k] -= isOnDiagonal(size, k) ? trace / 3 : 0;
      square += multiplicity(size, k) * deviator[k] * deviator[k] / 2;
    }
    shear_stress = math::sqrt(square);
  }
};

template <class Law, class = void>
struct Dilates : std::false_type
{
};
template <class Law>
struct Dilates<Law, std::void_t<decltype(&Law::meanStress)>> : std::true_type
{
};

// Law::shearStress(parameters, Trial) is t1, and Law::meanStress, where there is one, p1.
template <class Law>
struct ReturnMapping
{
  YieldingCells of;

  KOKKOS_FUNCTION void operator()(int i) const
  {
    const int cell = of.cells(i);
    const double G = of.shear_modulus(cell);
    const TrialStress trial(of, cell);
    const double K = of.bulk_modulus(cell);
    const double t = trial.shear_stress;
    const Trial of_cell = {t, trial.mean, of.shear_before(cell, 0), G, K, of.step};
    const double t1 = Law::shearStress(&of.parameters(i, 0), of_cell);
    const double lost = t > 0 ? (t - t1) / t : 0;
    double opened = 0;
    if constexpr (Dilates<Law>::value) {
      opened = K > 0 ? (trial.mean - Law::meanStress(&of.parameters(i, 0), of_cell)) / (3 * K) : 0;
    }
    const int size = of.inelastic.extent_int(1);
    for (int k = 0; k < size; ++k) {
      of.inelastic(cell, k) = of.inelastic_before(cell, k) + lost * trial.deviator[k] / (2 * G) +
                              (isOnDiagonal(size, k) ? opened : 0);
    }
    of.shear(cell, 0) = of.shear_before(cell, 0) + (t - t1) / G;
    of.shear_stress(cell) = t;
  }

  void run() const
  {
    Kokkos::parallel_for("asperity::fem::returnMapping", RangePolicy(0, of.cells.extent_int(0)),
                         *this);
  }
};
} // namespace asperity::fem
