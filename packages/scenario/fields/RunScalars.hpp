#pragma once

#include "io/FieldRegistry.hpp"
#include "scenario/fields/RunView.hpp"

namespace asperity::scenario
{
// Registers numbers of the whole model: the effort of the solvers and the energies. The view must
// outlive the registry. dimension: of space.
void registerScalars(io::FieldRegistry& registry, RunView const& view, int dimension,
                     bool has_yielding_rock, bool may_open);
} // namespace asperity::scenario
