#pragma once

#include "multigrid/FlushDenormals.hpp"

#include <Kokkos_Core.hpp>

#include <array>
#include <vector>

namespace asperity::multigrid
{
// The rows of a level in chunks of rows that follow one another, one for each thread of the host.
// What threads do depends on the chunks alone, so that runs on equally many threads are equal.
class Chunks
{
public:
  // A chunk of fewer rows costs more to start than it saves.
  static constexpr int least_rows = 256;

  Chunks() = default;
  // first(num_rows + 1): where the couplings of each row begin; chunks have about equally many.
  Chunks(std::vector<int> const& first, int most);
  static int numThreads();

  int count() const { return static_cast<int>(begins_.size()) - 1; }

  // work(chunk, begin, end) for each chunk with its rows, all at the same time.
  template <class Work>
  void forEachChunk(Work const& work) const
  {
    if (count() == 1) {
      work(0, begins_[0], begins_[1]);
      return;
    }
    using Host = Kokkos::DefaultHostExecutionSpace;
    Kokkos::parallel_for("asperity::multigrid::chunks",
                         Kokkos::RangePolicy<Host, Kokkos::Schedule<Kokkos::Static>>(0, count()),
                         [&](int chunk) {
                           const FlushDenormals flushed;
                           work(chunk, begins_[chunk], begins_[chunk + 1]);
                         });
    Host().fence();
  }
  // The same without the number of the chunk.
  template <class Work>
  void forEach(Work const& work) const
  {
    forEachChunk([&](int, int begin, int end) { work(begin, end); });
  }
  // work(row) for each row, in any order.
  template <class Work>
  void forEachRow(Work const& work) const
  {
    forEach([&](int begin, int end) {
      for (int row = begin; row < end; ++row) {
        work(row);
      }
    });
  }

  // The sums to which work(begin, end, sums) adds for each chunk.
  template <int N, class Work>
  std::array<double, N> sum(Work const& work) const
  {
    std::vector<std::array<double, N>> parts(count(), std::array<double, N>{});
    forEachChunk([&](int chunk, int begin, int end) { work(begin, end, parts[chunk]); });
    auto total = parts.front();
    for (int chunk = 1; chunk < count(); ++chunk) {
      for (int i = 0; i < N; ++i) {
        total[i] += parts[chunk][i];
      }
    }
    return total;
  }

private:
  std::vector<int> begins_ = {0, 0};
};
} // namespace asperity::multigrid
