#pragma once

#include "multigrid/FlushDenormals.hpp"
#include "portability/Spaces.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace asperity::multigrid
{
// How a sweep takes the rows of a level.
enum class RowOrder
{
  chunks, // for the threads of the host: each takes the rows of a region, in their order
  colours // for devices: rows of one colour, which are not coupled, at the same time
};

// Chunks where kernels run on the host, and colours where they run on a device.
constexpr RowOrder defaultRowOrder()
{
  return kernels_run_on_host ? RowOrder::chunks : RowOrder::colours;
}

namespace detail
{
// Calls row where all num_rows rows are taken in order.
template <class Row>
struct RowOfColour
{
  Row row;
  int num_rows;
  KOKKOS_FUNCTION void operator()(int r) const { row(r, 0, num_rows); }
};

// Work of the host in place of a kernel, which Kokkos's tools see as a region of this name.
struct KernelRegion
{
  KernelRegion()
  {
    static const std::string name = "asperity::multigrid::chunks";
    Kokkos::Profiling::pushRegion(name);
  }
  ~KernelRegion() { Kokkos::Profiling::popRegion(); }
  KernelRegion(KernelRegion const&) = delete;
  KernelRegion& operator=(KernelRegion const&) = delete;
};
} // namespace detail

// In which order, and how many at once, the rows of a level are worked on. With chunks a sweep
// depends on their number, and so on the number of threads; with colours it does not, but sums may
// differ in their last bits.
//
// A row is a function object, to be called on the device, row(r, begin, end): r takes the rows from
// `begin` to `end` in a sweep's order. What it takes from other rows is from before the sweep.
class Schedule
{
public:
  Schedule() = default;
  // begins(num_parts + 1): where each chunk, or colour, begins.
  Schedule(RowOrder order, std::vector<int> begins)
      : begins_(std::move(begins))
      , is_coloured_(order == RowOrder::colours)
  {
  }
  static int numThreads(); // of the host

  int numParts() const { return static_cast<int>(begins_.size()) - 1; } // chunks or colours
  bool isColoured() const { return is_coloured_; }
  // Rows are swept at the same time as others, from which they take the values before the sweep.
  bool sharesSweeps() const { return !is_coloured_ && numParts() > 1; }
  int numRows() const { return begins_.back(); }

  template <class Row>
  void forward(Row const& row) const
  {
    if (is_coloured_) {
      for (int colour = 0; colour < numParts(); ++colour) {
        launch(begins_[colour], begins_[colour + 1], row);
      }
    } else {
      forEachChunk([&](int, int begin, int end) {
        const Row own = row; // whose members a compiler may keep in registers
        for (int r = begin; r < end; ++r) {
          own(r, begin, end);
        }
      });
    }
  }
  template <class Row>
  void backward(Row const& row) const
  {
    if (is_coloured_) {
      for (int colour = numParts() - 1; colour >= 0; --colour) {
        launch(begins_[colour], begins_[colour + 1], row);
      }
    } else {
      forEachChunk([&](int, int begin, int end) {
        const Row own = row;
        for (int r = end - 1; r >= begin; --r) {
          own(r, begin, end);
        }
      });
    }
  }
  // All rows, in any order.
  template <class Row>
  void forEach(Row const& row) const
  {
    if (is_coloured_) {
      launch(0, numRows(), row);
    } else {
      forward(row);
    }
  }

  // work(chunk, begin, end) for each chunk with its rows, all at the same time; on the host.
  template <class Work>
  void forEachChunk(Work const& work) const
  {
    if (numParts() == 1) { // the cost of a kernel would show on coarse levels
      const detail::KernelRegion region;
      work(0, begins_[0], begins_[1]);
      return;
    }
    using Host = Kokkos::DefaultHostExecutionSpace;
    Kokkos::parallel_for("asperity::multigrid::chunks",
                         Kokkos::RangePolicy<Host, Kokkos::Schedule<Kokkos::Static>>(0, numParts()),
                         [&](int chunk) {
                           const FlushDenormals flushed;
                           work(chunk, begins_[chunk], begins_[chunk + 1]);
                         });
    Host().fence();
  }

  // number(i) for the numbers of vectors with `size` of them in each row, in any order.
  template <class Number>
  void forEachNumber(int size, Number const& number) const
  {
    if (is_coloured_) {
      Kokkos::parallel_for("asperity::multigrid::numbers", RangePolicy(0, numRows() * size),
                           number);
      return;
    }
    forEachChunk([&](int, int begin, int end) {
      const Number own = number;
      for (int i = begin * size; i < end * size; ++i) {
        own(i);
      }
    });
  }
  // The N sums to which number(i, sums) adds; number.addRange(begin, end, sums) adds a whole range,
  // on the host. Number::value_type is double[], and its value_count is N, as Kokkos wants it.
  template <int N, class Number>
  std::array<double, N> sum(int size, Number const& number) const
  {
    std::array<double, N> total{};
    if (is_coloured_) {
      const Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> result(total.data(),
                                                                                     N);
      Kokkos::parallel_reduce("asperity::multigrid::sums", RangePolicy(0, numRows() * size), number,
                              result);
      ExecutionSpace().fence();
      return total;
    }
    std::vector<std::array<double, N>> parts(numParts());
    forEachChunk([&](int chunk, int begin, int end) {
      double sums[N] = {};
      number.addRange(begin * size, end * size, sums);
      std::copy_n(sums, N, parts[chunk].begin());
    });
    total = parts.front();
    for (int chunk = 1; chunk < numParts(); ++chunk) {
      for (int i = 0; i < N; ++i) {
        total[i] += parts[chunk][i];
      }
    }
    return total;
  }

private:
  template <class Row>
  void launch(int begin, int end, Row const& row) const
  {
    Kokkos::parallel_for("asperity::multigrid::rows", RangePolicy(begin, end),
                         detail::RowOfColour<Row>{row, numRows()});
  }

  std::vector<int> begins_ = {0, 0}; // of chunks or colours
  bool is_coloured_ = false;
};
} // namespace asperity::multigrid
