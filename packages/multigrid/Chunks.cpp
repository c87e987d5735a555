#include "multigrid/Chunks.hpp"

#include <algorithm>
#include <cstdint>

namespace asperity::multigrid
{
int Chunks::numThreads() { return Kokkos::DefaultHostExecutionSpace().concurrency(); }

Chunks::Chunks(std::vector<int> const& first, int most)
{
  const int num_rows = static_cast<int>(first.size()) - 1;
  const int count = std::max(1, std::min(most, num_rows / least_rows));
  begins_ = {0};
  for (int chunk = 1; chunk < count; ++chunk) {
    const auto share = static_cast<int>(static_cast<std::int64_t>(first.back()) * chunk / count);
    const auto row = std::lower_bound(first.begin(), first.end(), share) - first.begin();
    begins_.push_back(std::max(begins_.back(), static_cast<int>(row)));
  }
  begins_.push_back(num_rows);
}
} // namespace asperity::multigrid
