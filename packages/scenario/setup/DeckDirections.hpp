#pragma once

#include "parameters/Parameters.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

// The entries `Output / Up` and `Bulk / Gravity Direction`, which follow from the mesh where the
// deck leaves them out (problem/Upright.hpp).
namespace asperity::scenario
{
inline constexpr char const* gravity_direction_entry = "Gravity Direction";

// Whether the deck leaves out this entry of the list. An entry that completeDirections has set
// counts as left out.
bool isLeftOut(ParameterList const& list, std::string const& name);

// `Up` of the deck's list `Output`, empty if it is left out.
std::optional<std::vector<double>> givenUp(ParameterList const& output);

// Sets each of the two entries that the deck leaves out: up is a unit vector along the axes, and
// gravity points against it. They count as defaults.
void completeDirections(ParameterList& deck, int dimension, std::array<double, 3> const& up);
} // namespace asperity::scenario
