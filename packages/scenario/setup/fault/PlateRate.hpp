#pragma once

#include "base/fields/Field.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "mesh/Mesh.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
struct BoundaryCondition;

// Back slip: the plates slide past each other at the rate Vp [m/s] along the fault, which friction
// sees beside the motion of the bodies, slip rate = slip factor v_t + Vp. It is the entry
// `Plate Rate` of the fault's boundary condition, constant in time, and points along the tangent
// of the fault's frame, in three dimensions along the projection of `Direction` onto the fault.
struct PlateRate
{
  std::string name;                  // of the condition, for messages
  std::string boundary;              // the fault
  std::shared_ptr<const Field> rate; // in x [m/s]; none if the plates do not move
  std::vector<double> direction;     // along the axes; empty in two dimensions

  explicit operator bool() const { return static_cast<bool>(rate); }
};

// That of a condition on a fault, without a rate where the deck gives none. components: of the
// displacement. InputError if it depends on time, or for a Direction that has no effect.
PlateRate plateRateOf(BoundaryCondition const& condition, int components);

// The rates (num_nodes, T) along the tangents of a fault's nodes, as for
// fem::FaultSurface::withPlateRate. A node of two faults has the rate of the first, one of none of
// them zero. InputError, on all ranks, where Direction is at right angles to the fault. Collective.
template <int Dim>
std::vector<double> nodalPlateRates(std::vector<PlateRate> const& plates, Mesh<Dim> const& mesh,
                                    fem::FaultSurface const& surface,
                                    fem::NodalFrames const& frames);

// `towards` (three numbers) projected onto the fault at a node: a unit vector along the tangents
// there, (T). InputError that begins with `entry` where they are at right angles.
std::vector<double> directionAlongFault(std::vector<double> const& towards,
                                        fem::NodalFrames const& frames, fem::FaultNode const& node,
                                        std::string const& entry);
} // namespace asperity::scenario
