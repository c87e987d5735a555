#include "tnnmg/direct/SupernodalFactor.hpp"

#include <Eigen/Core>

#include <algorithm>

namespace asperity::tnnmg::detail
{
namespace
{
using Block = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Values = Eigen::Map<Eigen::VectorXd>;

constexpr int largest_width = 48;
// Zeros that may be stored to make supernodes wider, as a share of all entries.
constexpr double most_zeros = 0.2;

// The number of entries in a dense block of `width` columns, the last of which has `rows_of_last`
// rows, with the diagonal.
long long entriesOf(int width, long long rows_of_last)
{
  return width * (rows_of_last - 1) + width * (width + 1LL) / 2;
}

int rowsOf(Eigen::SparseMatrix<double> const& L, int column)
{
  return L.outerIndexPtr()[column + 1] - L.outerIndexPtr()[column];
}

// Whether the next column is the first row below the diagonal of this one.
bool leadsToNext(Eigen::SparseMatrix<double> const& L, int column)
{
  return rowsOf(L, column) > 1 && L.innerIndexPtr()[L.outerIndexPtr()[column] + 1] == column + 1;
}
// x(rows) -= block own and own -= block' x(rows) for the narrow supernodes, which are most: a call
// of a general product would cost more than the product.
template <int Width>
void subtract(const double* block, std::size_t stride, const int* rows, std::size_t num_rows,
              const double* own, double* x)
{
  double factors[Width];
  std::copy(own, own + Width, factors);
  for (std::size_t i = 0; i < num_rows; ++i) {
    double sum = 0;
    for (int c = 0; c < Width; ++c) {
      sum += block[stride * c + i] * factors[c];
    }
    x[rows[i]] -= sum;
  }
}

template <int Width>
void subtractTransposed(const double* block, std::size_t stride, const int* rows,
                        std::size_t num_rows, const double* x, double* own)
{
  double sums[Width] = {};
  for (std::size_t i = 0; i < num_rows; ++i) {
    const double value = x[rows[i]];
    for (int c = 0; c < Width; ++c) {
      sums[c] += block[stride * c + i] * value;
    }
  }
  for (int c = 0; c < Width; ++c) {
    own[c] -= sums[c];
  }
}
} // namespace

SupernodalFactor::SupernodalFactor(Eigen::SparseMatrix<double> const& L, int num_columns)
{
  for (int first = 0; first < num_columns;) {
    int width = 1;
    long long entries = rowsOf(L, first);
    while (width < largest_width && first + width < num_columns &&
           leadsToNext(L, first + width - 1)) {
      entries += rowsOf(L, first + width);
      const auto stored = entriesOf(width + 1, rowsOf(L, first + width));
      if (static_cast<double>(stored - entries) > most_zeros * static_cast<double>(stored)) {
        break;
      }
      ++width;
    }
    add(L, first, width);
    first += width;
  }
  std::size_t most_rows = 0;
  for (auto const& node : supernodes_) {
    most_rows = std::max(most_rows, node.num_rows);
  }
  work_.resize(most_rows);
}

void SupernodalFactor::add(Eigen::SparseMatrix<double> const& L, int first, int width)
{
  const int last = first + width - 1;
  const int* starts = L.outerIndexPtr();
  const int* rows = L.innerIndexPtr();
  Supernode node{};
  node.first_column = first;
  node.width = width;
  node.first_row = rows_.size();
  node.num_rows = static_cast<std::size_t>(rowsOf(L, last) - 1);
  node.values = values_.size();
  rows_.insert(rows_.end(), rows + starts[last] + 1, rows + starts[last + 1]);
  const std::size_t height = width + node.num_rows;
  values_.resize(values_.size() + height * width, 0.);
  for (int column = first; column <= last; ++column) {
    double* to = values_.data() + node.values + height * (column - first);
    std::size_t below = 0;
    for (int k = starts[column]; k < starts[column + 1]; ++k) {
      if (rows[k] <= last) {
        to[rows[k] - first] = L.valuePtr()[k];
        continue;
      }
      while (rows_[node.first_row + below] != rows[k]) {
        ++below;
      }
      to[width + below] = L.valuePtr()[k];
    }
  }
  supernodes_.push_back(node);
}

void SupernodalFactor::forward(double* x) const
{
  for (auto const& node : supernodes_) {
    Values own(x + node.first_column, node.width);
    if (own.isZero(0)) {
      continue;
    }
    const std::size_t height = node.width + node.num_rows;
    const double* values = values_.data() + node.values;
    for (int c = 0; c < node.width; ++c) {
      const double* column = values + height * c;
      const double solved = own[c] / column[c];
      own[c] = solved;
      for (int row = c + 1; row < node.width; ++row) {
        own[row] -= column[row] * solved;
      }
    }
    const double* below = values + node.width;
    const int* rows = rows_.data() + node.first_row;
    switch (node.width) {
    case 1: subtract<1>(below, height, rows, node.num_rows, own.data(), x); break;
    case 2: subtract<2>(below, height, rows, node.num_rows, own.data(), x); break;
    case 3: subtract<3>(below, height, rows, node.num_rows, own.data(), x); break;
    case 4: subtract<4>(below, height, rows, node.num_rows, own.data(), x); break;
    case 5: subtract<5>(below, height, rows, node.num_rows, own.data(), x); break;
    case 6: subtract<6>(below, height, rows, node.num_rows, own.data(), x); break;
    default: {
      const auto num_rows = static_cast<Eigen::Index>(node.num_rows);
      const Block block(below, num_rows, node.width,
                        Eigen::OuterStride<>(static_cast<Eigen::Index>(height)));
      Values update(work_.data(), num_rows);
      update.noalias() = block * own;
      for (Eigen::Index i = 0; i < num_rows; ++i) {
        x[rows[i]] -= update[i];
      }
    }
    }
  }
}

void SupernodalFactor::backward(double* x) const
{
  for (auto node = supernodes_.rbegin(); node != supernodes_.rend(); ++node) {
    Values own(x + node->first_column, node->width);
    const std::size_t height = node->width + node->num_rows;
    const double* values = values_.data() + node->values;
    const double* below = values + node->width;
    const int* rows = rows_.data() + node->first_row;
    switch (node->width) {
    case 1: subtractTransposed<1>(below, height, rows, node->num_rows, x, own.data()); break;
    case 2: subtractTransposed<2>(below, height, rows, node->num_rows, x, own.data()); break;
    case 3: subtractTransposed<3>(below, height, rows, node->num_rows, x, own.data()); break;
    case 4: subtractTransposed<4>(below, height, rows, node->num_rows, x, own.data()); break;
    case 5: subtractTransposed<5>(below, height, rows, node->num_rows, x, own.data()); break;
    case 6: subtractTransposed<6>(below, height, rows, node->num_rows, x, own.data()); break;
    default: {
      if (node->num_rows == 0) {
        break; // a root of the elimination tree
      }
      const auto num_rows = static_cast<Eigen::Index>(node->num_rows);
      const Block block(below, num_rows, node->width,
                        Eigen::OuterStride<>(static_cast<Eigen::Index>(height)));
      Values gathered(work_.data(), num_rows);
      for (Eigen::Index i = 0; i < num_rows; ++i) {
        gathered[i] = x[rows[i]];
      }
      own.noalias() -= block.transpose() * gathered;
    }
    }
    for (int c = node->width - 1; c >= 0; --c) {
      const double* column = values + height * c;
      double sum = own[c];
      for (int row = c + 1; row < node->width; ++row) {
        sum -= column[row] * own[row];
      }
      own[c] = sum / column[c];
    }
  }
}

std::size_t SupernodalFactor::bytes() const
{
  return values_.size() * sizeof(double) + rows_.size() * sizeof(int) +
         supernodes_.size() * sizeof(Supernode);
}
} // namespace asperity::tnnmg::detail
