#pragma once

#include "base/Warning.hpp"
#include "io/OutputDomain.hpp"
#include "parameters/Parameters.hpp"

#include <optional>
#include <vector>

namespace asperity::catalogue
{
// A warning of receivers in the body, of the deck's list `Output / Receivers`, that lie on a fault
// inside it, where its two sides move apart: it names them, their faults and the side that each
// records. splits: those of the mesh. Collective.
std::optional<Warning> warnOfReceiversOnFault(ParameterList const& receivers,
                                              io::OutputDomain const& volume,
                                              io::OutputDomain const& fault,
                                              std::vector<SplitVertex> const& splits);
} // namespace asperity::catalogue
