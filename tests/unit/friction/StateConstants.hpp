#pragma once

// What the tests of the flow of the state take for every node.
namespace asperity::friction::test
{
inline constexpr double L = 2e-5;              // m
inline constexpr double reference_rate = 5e-5; // m/s
} // namespace asperity::friction::test
