#pragma once

#include <Kokkos_Core.hpp>

// Symmetric tensors in kernels, their components in the order of tensorComponents().
namespace asperity::fem
{
KOKKOS_INLINE_FUNCTION constexpr int numTensorComponents(int displacement_components)
{
  return displacement_components == 1 ? 2 : displacement_components == 2 ? 4 : 6;
}

// The place of entry (i, k), i <= k, of a tensor in the plane or in space.
template <int Dim>
KOKKOS_FUNCTION constexpr int placeOf(int i, int k)
{
  return i == 0 ? k : (i == 1 ? Dim - 1 + k : 5);
}

// Whether component k of `size` is on the diagonal; antiplane tensors have 0 there.
KOKKOS_INLINE_FUNCTION constexpr bool isOnDiagonal(int size, int k)
{
  return size == 4 ? k != 1 : size == 6 && (k == 0 || k == 3 || k == 5);
}

// Its part in s : s.
KOKKOS_INLINE_FUNCTION constexpr double multiplicity(int size, int k)
{
  return isOnDiagonal(size, k) ? 1 : 2;
}

// The trace of the tensor in a row; 0 antiplane.
template <class Tensors>
KOKKOS_INLINE_FUNCTION double traceOf(Tensors const& tensors, int row)
{
  double trace = 0;
  const int size = tensors.extent_int(1);
  for (int k = 0; k < size; ++k) {
    trace += isOnDiagonal(size, k) ? tensors(row, k) : 0;
  }
  return trace;
}

// Whether the tensors in a row of both are equal; nan is not.
template <class Tensors, class OtherTensors>
KOKKOS_INLINE_FUNCTION bool areEqual(Tensors const& tensors, OtherTensors const& others, int row)
{
  bool are_equal = true;
  const int size = tensors.extent_int(1);
  for (int k = 0; k < size; ++k) {
    are_equal = are_equal && tensors(row, k) == others(row, k);
  }
  return are_equal;
}

// Whether the tensor in a row is zero.
template <class Tensors>
KOKKOS_INLINE_FUNCTION bool isZero(Tensors const& tensors, int row)
{
  bool is_zero = true;
  const int size = tensors.extent_int(1);
  for (int k = 0; k < size; ++k) {
    is_zero = is_zero && tensors(row, k) == 0;
  }
  return is_zero;
}

// The gradient of a displacement or velocity with `Components` components. strain() and add() add
// to `tensor` the strain, and the stress with the Lame constants first and second.
template <int Dim, int Components>
struct Gradient
{
  static constexpr int size = numTensorComponents(Components);

  double entry[Components][Dim] = {}; // d u_i / d x_k

  KOKKOS_FUNCTION void strain(double* tensor) const { add(0, 0.5, tensor); }

  KOKKOS_FUNCTION void add(double first, double second, double* tensor) const
  {
    if constexpr (Components == 1) {
      for (int k = 0; k < Dim; ++k) {
        tensor[k] += second * entry[0][k];
      }
    } else {
      double trace = 0;
      for (int i = 0; i < Dim; ++i) {
        trace += entry[i][i];
        for (int k = i; k < Dim; ++k) {
          tensor[placeOf<Dim>(i, k)] += second * (entry[i][k] + entry[k][i]);
        }
      }
      for (int i = 0; i < Dim; ++i) {
        tensor[placeOf<Dim>(i, i)] += first * trace;
      }
      if constexpr (Dim == 2) {
        tensor[3] += first * trace; // zz, where the strain is zero
      }
    }
  }
};
} // namespace asperity::fem
