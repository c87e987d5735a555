#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity::tnnmg
{
// Where the rows of a symmetric matrix stand in an order of elimination that keeps its Cholesky
// factor sparse (nested dissection, METIS), with given rows last. It is found once for all matrices
// with the same entries, such as those of all step sizes.
class EliminationOrder
{
public:
  // The entries of a square matrix by columns: those of column c are rows[starts[c]] to
  // rows[starts[c + 1] - 1].
  struct Pattern
  {
    std::vector<int> starts, rows;
  };

  // The position of each row; `last` come last, in their order. Valid until the next call.
  std::vector<int> const& positions(Pattern const& pattern, std::vector<int> const& last);

private:
  Pattern pattern_;
  std::vector<int> last_, positions_;
};
} // namespace asperity::tnnmg
