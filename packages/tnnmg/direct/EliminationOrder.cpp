#include "tnnmg/direct/EliminationOrder.hpp"

#include <Eigen/MetisSupport>
#include <Eigen/SparseCore>

namespace asperity::tnnmg
{
namespace
{
using Pattern = EliminationOrder::Pattern;

// Numbers the rows that are not last, in ascending order; the number of the others is -1.
std::vector<int> numbersOfFirst(int size, std::vector<int> const& last)
{
  std::vector<int> numbers(size, 0);
  for (int row : last) {
    numbers[row] = -1;
  }
  int num_first = 0;
  for (int& number : numbers) {
    number = number == 0 ? num_first++ : -1;
  }
  return numbers;
}

std::vector<int> dissect(Pattern const& pattern, std::vector<int> const& last)
{
  const int size = static_cast<int>(pattern.starts.size()) - 1;
  const auto numbers = numbersOfFirst(size, last);
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < size; ++column) {
    for (int k = pattern.starts[column]; k < pattern.starts[column + 1]; ++k) {
      const int row = pattern.rows[k];
      if (numbers[row] >= 0 && numbers[column] >= 0) {
        entries.emplace_back(numbers[row], numbers[column], 1.);
      }
    }
  }
  const int num_first = size - static_cast<int>(last.size());
  Eigen::SparseMatrix<double> first(num_first, num_first);
  first.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(num_first);
  if (num_first > 0) {
    Eigen::MetisOrdering<int>()(first, order); // the row eliminated as number k is indices()(k)
  }
  std::vector<int> place(num_first);
  for (int k = 0; k < num_first; ++k) {
    place[order.indices()(k)] = k;
  }
  std::vector<int> positions(size);
  for (int row = 0; row < size; ++row) {
    positions[row] = numbers[row] >= 0 ? place[numbers[row]] : 0;
  }
  for (std::size_t i = 0; i < last.size(); ++i) {
    positions[last[i]] = num_first + static_cast<int>(i);
  }
  return positions;
}
} // namespace

std::vector<int> const& EliminationOrder::positions(Pattern const& pattern,
                                                    std::vector<int> const& last)
{
  if (pattern.starts != pattern_.starts || pattern.rows != pattern_.rows || last != last_) {
    positions_ = dissect(pattern, last);
    pattern_ = pattern;
    last_ = last;
  }
  return positions_;
}
} // namespace asperity::tnnmg
