#include "friction/Table.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::friction
{
namespace
{
// A slope between or beside chords: 0 where they change their sign, at most three times the flatter
// one.
double limited(double slope, double left, double right)
{
  if (left * right <= 0 || slope * left <= 0) {
    return 0;
  }
  const double most = 3 * std::min(std::abs(left), std::abs(right));
  return std::copysign(std::min(std::abs(slope), most), left);
}

void requireIncreasing(std::vector<double> const& x, std::vector<double> const& f)
{
  bool fine = x.size() >= 2 && f.size() == x.size();
  for (std::size_t i = 0; fine && i < x.size(); ++i) {
    fine = std::isfinite(x[i]) && std::isfinite(f[i]) && (i == 0 || x[i - 1] < x[i]);
  }
  if (!fine) {
    throw std::invalid_argument("asperity::friction: a table needs two points or more of finite "
                                "numbers, the first of which increase.");
  }
}
} // namespace

TableView makeTable(std::vector<double> const& x, std::vector<double> const& f)
{
  requireIncreasing(x, f);
  const std::size_t last = x.size() - 1;
  std::vector<double> h(last), chord(last), slope(last + 1);
  for (std::size_t i = 0; i < last; ++i) {
    h[i] = x[i + 1] - x[i];
    chord[i] = (f[i + 1] - f[i]) / h[i];
  }
  // of the parabola through three points
  for (std::size_t i = 1; i < last; ++i) {
    slope[i] = limited((h[i] * chord[i - 1] + h[i - 1] * chord[i]) / (h[i - 1] + h[i]),
                       chord[i - 1], chord[i]);
  }
  const auto atEnd = [&](std::size_t end, std::size_t next) {
    const double parabola = chord[end] + (chord[end] - chord[next]) * h[end] / (h[end] + h[next]);
    return limited(parabola, chord[end], chord[end]);
  };
  slope[0] = last == 1 ? chord[0] : atEnd(0, 1);
  slope[last] = last == 1 ? chord[0] : atEnd(last - 1, last - 2);

  const Kokkos::View<double* [3], Kokkos::LayoutRight, MemorySpace> table(
    "asperity::friction::table", x.size());
  auto const host = Kokkos::create_mirror_view(table);
  for (std::size_t i = 0; i <= last; ++i) {
    host(i, 0) = x[i];
    host(i, 1) = f[i];
    host(i, 2) = slope[i];
  }
  Kokkos::deep_copy(table, host);
  return table;
}
} // namespace asperity::friction
