#pragma once

#include "base/Warning.hpp"
#include "catalogue/receivers/Ground.hpp"
#include "io/OutputDomain.hpp"
#include "parameters/Parameters.hpp"

#include <optional>
#include <vector>

namespace asperity::catalogue
{
// The parts of a model among which receivers are looked up.
struct ReceiverDomains
{
  io::OutputDomain const& volume;
  io::OutputDomain const& fault;
  Ground const* ground; // null without a free surface
};

// A warning of receivers in the body, of the deck's list `Output / Receivers`, that lie on a fault
// inside it, where its two sides move apart: it names them, their faults and the side that each
// records. splits: those of the mesh. Collective.
std::optional<Warning> warnOfReceiversOnFault(ParameterList const& receivers,
                                              ReceiverDomains const& domains,
                                              std::vector<SplitVertex> const& splits);
} // namespace asperity::catalogue
