#pragma once

#include "friction/Types.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>

namespace asperity::friction::detail
{
// Calls body(std::integral_constant<int, T>) for T = num_components.
template <class Body>
auto withComponents(std::size_t num_components, Body const& body)
{
  if (num_components == 1) {
    return body(std::integral_constant<int, 1>());
  }
  if (num_components == 2) {
    return body(std::integral_constant<int, 2>());
  }
  throw std::invalid_argument("asperity::friction: vectors of " + std::to_string(num_components) +
                              " components; a fault has 1 or 2 tangential ones.");
}
} // namespace asperity::friction::detail
