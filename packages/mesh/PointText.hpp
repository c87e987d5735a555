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
} // namespace asperity::mesh
