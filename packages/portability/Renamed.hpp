#pragma once

#include <Kokkos_Core.hpp>
#include <Kokkos_MathematicalFunctions.hpp>

#include <cstddef>
#include <utility>

// Functions whose names differ between Kokkos 3.4 and Trilinos 13.2 on one side, and Kokkos 3.7 and
// 4 and Trilinos 14 to 16 on the other. The test style.renamed refuses these names anywhere else.
// Nothing of Tpetra is included: the templates take any object that has the function by its new or
// its old name.
namespace asperity
{
// Functions of <cmath> on host and device: math::sqrt, math::log, ...
#if KOKKOS_VERSION >= 30700
namespace math = Kokkos;
#else
namespace math = Kokkos::Experimental;
#endif

namespace detail
{
// The first argument decides: int binds to the new name where there is one, long to the old one.
#define ASPERITY_RENAMED(FUNCTION, NEW_NAME, OLD_NAME)                                             \
  template <class Object>                                                                          \
  auto FUNCTION(Object const& object, int)->decltype(std::size_t(object.NEW_NAME()))               \
  {                                                                                                \
    return object.NEW_NAME();                                                                      \
  }                                                                                                \
  template <class Object>                                                                          \
  auto FUNCTION(Object const& object, long)->decltype(std::size_t(object.OLD_NAME()))              \
  {                                                                                                \
    return object.OLD_NAME();                                                                      \
  }

ASPERITY_RENAMED(numLocalRows, getLocalNumRows, getNodeNumRows)
ASPERITY_RENAMED(numLocalColumns, getLocalNumCols, getNodeNumCols)
ASPERITY_RENAMED(numLocalEntries, getLocalNumEntries, getNodeNumEntries)
ASPERITY_RENAMED(numLocalElements, getLocalNumElements, getNodeNumElements)
ASPERITY_RENAMED(maxLocalRowEntries, getLocalMaxNumRowEntries, getNodeMaxNumRowEntries)
#undef ASPERITY_RENAMED
} // namespace detail

// Sizes of a graph or a matrix on this rank: rows, columns, stored entries, the most entries in a
// row.
template <class Matrix>
std::size_t numLocalRows(Matrix const& matrix)
{
  return detail::numLocalRows(matrix, 0);
}

template <class Matrix>
std::size_t numLocalColumns(Matrix const& matrix)
{
  return detail::numLocalColumns(matrix, 0);
}

template <class Matrix>
std::size_t numLocalEntries(Matrix const& matrix)
{
  return detail::numLocalEntries(matrix, 0);
}

template <class Matrix>
std::size_t maxLocalRowEntries(Matrix const& matrix)
{
  return detail::maxLocalRowEntries(matrix, 0);
}

// The number of elements of a map on this rank.
template <class RowMap>
std::size_t numLocalElements(RowMap const& map)
{
  return detail::numLocalElements(map, 0);
}
} // namespace asperity
