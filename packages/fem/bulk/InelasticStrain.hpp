#pragma once

#include "portability/Views.hpp"

namespace asperity::fem
{
// A tensor in each cell, (num_cells, tensor components), in the order of tensorComponents().
using TensorView = Kokkos::View<double**, Kokkos::LayoutRight, MemorySpace>;
using ConstTensorView = Kokkos::View<const double**, Kokkos::LayoutRight, MemorySpace>;

// The inelastic strain of a state, a row for each of a body's InelasticCells.
struct InelasticStrain
{
  TensorView strain;  // (num_cells, tensor components); deviatoric but where rock dilates
  TensorView shear;   // (num_cells, 1), accumulated
  TensorView history; // (num_cells, columns), what else laws remember (bulk/History.hpp)
};
} // namespace asperity::fem
