#pragma once

#include "io/OutputDomain.hpp"

#include <array>
#include <optional>

namespace asperity::catalogue
{
using Direction = std::array<double, 3>;

// The mean plane of a fault that is a surface, and its directions, which are unit vectors. Slip and
// places are measured along strike and down dip, as seismologists do.
struct FaultPlane
{
  Direction normal{}; // out of the body whose boundary the fault is
  Direction strike{}; // level; its largest component is positive
  Direction dip{};    // in the plane, downwards
  Direction down{};   // against `up`
  Direction inward{}; // across strike and down, from the fault into the body
  double top = 0;     // [m] dip · x of the fault's upper end

  double alongStrike(double const* x) const; // [m] strike · x: from the origin of the mesh
  double downDip(double const* x) const;     // [m] from the upper end of the fault
};

// `up` points up and need not have length one. A level fault has no dip: there the strike is the
// axis after that which is nearest to `up` (z for y). `boundary`: of several that the fault is made
// of, the plane is that of this one alone. Collective.
FaultPlane faultPlane(io::OutputDomain const& fault, Direction const& up,
                      std::optional<int> boundary = {});

// The same, or nothing where faultPlane throws: the facets of a closed surface cancel each other.
std::optional<FaultPlane> meanPlane(io::OutputDomain const& fault, Direction const& up,
                                    std::optional<int> boundary = {});
} // namespace asperity::catalogue
