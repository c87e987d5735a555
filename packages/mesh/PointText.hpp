#pragma once

#include <array>
#include <cstddef>
#include <sstream>
#include <string>

namespace asperity::mesh
{
// "(0.5, -1)", for messages.
template <std::size_t Dim>
std::string text(std::array<double, Dim> const& point)
{
  std::ostringstream out;
  out.precision(10);
  for (std::size_t d = 0; d < Dim; ++d) {
    out << (d == 0 ? "(" : ", ") << point[d];
  }
  out << ')';
  return out.str();
}

// "(0, 0), (0.5, -1)"
template <std::size_t Dim, std::size_t N>
std::string text(std::array<std::array<double, Dim>, N> const& points)
{
  std::string list;
  for (auto const& point : points) {
    list += (list.empty() ? "" : ", ") + text(point);
  }
  return list;
}
} // namespace asperity::mesh
