#include "io/checkpoint/NodeOrder.hpp"

#include "base/Hashes.hpp"
#include "base/parallel/Directory.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>

namespace asperity::io::detail
{
NodeOrder orderOf(std::vector<std::int64_t> const& numbers, Communicator const& comm)
{
  std::uint64_t sum = 0;
  std::int64_t end = 0;
  for (const std::int64_t number : numbers) {
    sum += splitMix(static_cast<std::uint64_t>(number));
    end = std::max(end, number + 1);
  }
  const std::vector<GlobalOrdinal> ids(numbers.begin(), numbers.end());
  const Directory directory(static_cast<GlobalOrdinal>(maxOverRanks(end, comm)), comm);
  const auto places = directory.sumsBefore(ids, ids, std::vector<GlobalOrdinal>(ids.size(), 1));
  const auto total = sumOverRanks(static_cast<std::int64_t>(ids.size()), comm);
  const auto checksum = sumOverRanks(static_cast<std::int64_t>(sum), comm);
  return {NodeBlocks(places, static_cast<GlobalOrdinal>(total), comm), checksum};
}
} // namespace asperity::io::detail
