#pragma once

#include "base/Views.hpp"
#include "fem/bulk/InelasticStrain.hpp"
#include "fem/bulk/TensorKernels.hpp"
#include "portability/Renamed.hpp"

// How rock yields within a step. The flow is isochoric: it leaves the mean stress and shortens the
// deviatoric stress. Let s be that of a cell at the end of the step if its strain were elastic (the
// trial), and t = sqrt(s : s / 2). Then
//   s1 = t1 / t s,   e1 = e0 + (s - s1) / 2G,   gamma1 = gamma0 + (t - t1) / G
// with the inelastic strain e and its accumulated shear gamma. A law gives t1(t), 0 <= t1 <= t,
// with a slope from 0 to 1: then s1 is the gradient of a convex potential of the strain, whose
// second derivative nowhere exceeds that of elastic rock.
namespace asperity::fem
{
// What a law knows of a cell in a step.
struct Trial
{
  double shear_stress;  // t [Pa]
  double mean_stress;   // a third of the trace [Pa], positive in tension; 0 antiplane
  double shear;         // gamma0 [-]
  double shear_modulus; // G [Pa]
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
      deviator[k] =
        of.initial_stress(cell, k) +
        2 * of.shear_modulus(cell) * (of.strain(cell, k) - of.inelastic_before(cell, k));
      trace += isOnDiagonal(size, k) ? deviator[k] : 0;
      mean += isOnDiagonal(size, k) ? of.bulk_modulus(cell) * of.strain(cell, k) : 0;
    }
    double square = 0;
    for (int k = 0; k < size; ++k) {
      deviator[k] -= isOnDiagonal(size, k) ? trace / 3 : 0;
      square += multiplicity(size, k) * deviator[k] * deviator[k] / 2;
    }
    shear_stress = math::sqrt(square);
  }
};

// Law::shearStress(parameters, Trial) is t1.
template <class Law>
struct ReturnMapping
{
  YieldingCells of;

  KOKKOS_FUNCTION void operator()(int i) const
  {
    const int cell = of.cells(i);
    const double G = of.shear_modulus(cell);
    const TrialStress trial(of, cell);
    const double t = trial.shear_stress;
    const double t1 =
      Law::shearStress(&of.parameters(i, 0), {t, trial.mean, of.shear_before(cell, 0), G, of.step});
    const double lost = t > 0 ? (t - t1) / t : 0;
    for (int k = 0; k < of.inelastic.extent_int(1); ++k) {
      of.inelastic(cell, k) = of.inelastic_before(cell, k) + lost * trial.deviator[k] / (2 * G);
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
