#pragma once

#include "base/Types.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace asperity
{
// Sum, maximum and minimum of one number of each rank (int, double, std::int64_t), the same result
// on every rank. Collective. On one rank they cost nothing.
namespace detail
{
template <class Number>
Number reduced(Number mine, Teuchos::EReductionType operation, Communicator const& communicator)
{
  Number all = mine;
  if (communicator.getSize() > 1) {
    Teuchos::reduceAll(communicator, operation, mine, Teuchos::outArg(all));
  }
  return all;
}
} // namespace detail

template <class Number>
Number sumOverRanks(Number mine, Communicator const& communicator)
{
  return detail::reduced(mine, Teuchos::REDUCE_SUM, communicator);
}

template <class Number>
Number maxOverRanks(Number mine, Communicator const& communicator)
{
  return detail::reduced(mine, Teuchos::REDUCE_MAX, communicator);
}

template <class Number>
Number minOverRanks(Number mine, Communicator const& communicator)
{
  return detail::reduced(mine, Teuchos::REDUCE_MIN, communicator);
}
} // namespace asperity
