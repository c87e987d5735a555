#pragma once

#include "catalogue/fault_geometry/FaultPlane.hpp"
#include "io/files/RunJournal.hpp"

namespace asperity::catalogue
{
// How the fault lies, for programs that read the results of a run:
//
//   element_size                 of the shortest element [m] (shortestElement)
//   level, thrust_sign           in two dimensions: whether the plane is a map, in which the fault
//                                runs along strike; and in a section the sign of slip along the
//                                tangent in a thrust, where the hanging wall moves up dip
//   strike, dip, down, inward,   in three dimensions: those of FaultPlane, if the fault has a mean
//   top                          plane
//
// Collective.
io::Facts faultFacts(io::OutputDomain const& fault, Direction const& up);
} // namespace asperity::catalogue
