#include "multigrid/Schedule.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace asperity::multigrid
{
int Schedule::numThreads() { return Kokkos::DefaultHostExecutionSpace().concurrency(); }

Schedule Schedule::inChunks(std::vector<int> const& first, int most)
{
  const int num_rows = static_cast<int>(first.size()) - 1;
  const int count = std::max(1, std::min(most, num_rows / least_rows));
  Schedule result;
  result.begins_ = {0};
  for (int chunk = 1; chunk < count; ++chunk) {
    const auto share = static_cast<int>(static_cast<std::int64_t>(first.back()) * chunk / count);
    const auto row = std::lower_bound(first.begin(), first.end(), share) - first.begin();
    result.begins_.push_back(std::max(result.begins_.back(), static_cast<int>(row)));
  }
  result.begins_.push_back(num_rows);
  return result;
}

Schedule Schedule::inColours(std::vector<int> begins)
{
  Schedule result;
  result.begins_ = std::move(begins);
  result.is_coloured_ = true;
  return result;
}
} // namespace asperity::multigrid
