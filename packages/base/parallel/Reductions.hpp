#pragma once

#include "base/Types.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <type_traits>

namespace asperity
{
// Sum, maximum and minimum over the ranks of one number per rank (int, double, std::int64_t), or,
// entry by entry, of equally many numbers per rank (std::vector, std::array, Eigen's matrices). The
// result is the same on every rank. Collective.
namespace detail
{
template <class Numbers>
Numbers reduced(Numbers const& mine, Teuchos::EReductionType operation,
                Communicator const& communicator)
{
  Numbers all = mine;
  if (communicator.getSize() > 1) {
    if constexpr (std::is_arithmetic_v<Numbers>) {
      Teuchos::reduceAll(communicator, operation, mine, Teuchos::outArg(all));
    } else {
      Teuchos::reduceAll(communicator, operation, static_cast<int>(mine.size()), mine.data(),
                         all.data());
    }
  }
  return all;
}
} // namespace detail

template <class Numbers>
Numbers sumOverRanks(Numbers const& mine, Communicator const& communicator)
{
  return detail::reduced(mine, Teuchos::REDUCE_SUM, communicator);
}

template <class Numbers>
Numbers maxOverRanks(Numbers const& mine, Communicator const& communicator)
{
  return detail::reduced(mine, Teuchos::REDUCE_MAX, communicator);
}

template <class Numbers>
Numbers minOverRanks(Numbers const& mine, Communicator const& communicator)
{
  return detail::reduced(mine, Teuchos::REDUCE_MIN, communicator);
}
} // namespace asperity
