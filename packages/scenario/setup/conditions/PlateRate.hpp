#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "mesh/Mesh.hpp"
#include "parameters/fields/Field.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
struct BoundaryCondition;

// Back slip: the plates slide past each other along the fault at the rate Vp [m/s], which adds to
// the motion of the bodies: slip rate = slip factor v_t + Vp. Vp is the entry `Plate Rate` of the
// fault's boundary condition and constant in time. It points along the tangent of the fault's
// frame, in three dimensions along the projection of `Direction` onto the fault.
struct PlateRate
{
  std::string name;                  // of the condition, for messages
  std::string boundary;              // name of the fault in the mesh
  std::shared_ptr<const Field> rate; // Vp(x) [m/s]; null if the plates do not move
  std::vector<double> direction;     // along the axes; empty in two dimensions

  explicit operator bool() const { return static_cast<bool>(rate); }
};

// The plate rate of a condition on a fault; `rate` is null if the deck gives none. components: of
// the displacement. Throws InputError if the rate depends on time or is a dataset, or if
// `Direction` is zero or has no effect.
PlateRate plateRateOf(BoundaryCondition const& condition, int components);

// The rates (num_nodes, T) along the tangents of a fault's nodes, as for
// fem::FaultSurface::withPlateRate. A node that lies on several of the plates' boundaries has the
// rate of the first, a node on none of them has the rate zero. Throws InputError on all ranks where
// Direction is at right angles to the fault. Collective.
template <int Dim>
std::vector<double> nodalPlateRates(std::vector<PlateRate> const& plates, Mesh<Dim> const& mesh,
                                    fem::FaultSurface const& surface,
                                    fem::NodalFrames const& frames);

// The direction of the projection of `towards` (three numbers) onto the fault at a node: a unit
// vector in components along the tangents there, (T). Throws InputError, with a message that begins
// with `entry`, if `towards` is at right angles to the fault; where nothing can slip it is zero
// there, as at a common tip of two faults, whose normal is that of neither of them.
std::vector<double> directionAlongFault(std::vector<double> const& towards,
                                        fem::NodalFrames const& frames,
                                        fem::FaultSurface const& surface, int node,
                                        std::string const& entry);
} // namespace asperity::scenario
