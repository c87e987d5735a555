#pragma once

#include "io/FieldRegistry.hpp"
#include "scenario/fields/RunView.hpp"

namespace asperity::scenario
{
// Registers the numbers of a whole run: effort of the solvers and energies. The view must outlive
// the registry. dimension: of space.
void registerScalars(io::FieldRegistry& registry, RunView const& view, int dimension,
                     bool has_yielding_rock);
} // namespace asperity::scenario
