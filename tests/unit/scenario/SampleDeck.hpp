#pragma once

#include "base/Parameters.hpp"
#include "base/Types.hpp"
#include "mesh/Mesh.hpp"

#include <functional>
#include <string>

namespace asperity::scenario::test
{
RCP<const Communicator> world();

// Two by two squares of a metre on a fault, under gravity; only what has no default.
ParameterList shortDeck();

// The short deck after the change, completed for its laws.
ParameterList completeDeck(std::function<void(ParameterList&)> const& change = [](auto&) {});

// A rectangle of two regions, "left" (x < 1) and "right", on this rank.
Mesh<2> twoRegions();
} // namespace asperity::scenario::test
