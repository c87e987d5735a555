#pragma once

#include "fem/BoundaryLoad.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/constraints/Constraints.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/conditions/PlateRate.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Boundary Conditions`: one sublist, of any name, for each condition.
RCP<const ParameterList> boundaryParameters();

struct BoundaryCondition;

template <int Dim>
struct BoundaryConditions
{
  // The faults: none, one, or several if they lie between two bodies. Several faults form one
  // surface.
  fem::Boundaries faults;
  fem::Boundaries given_slip; // those of them whose slip is prescribed; all others have friction
  // The other side of all faults.
  fem::OtherSide other_side;
  std::vector<PlateRate> plate_rates; // of the faults that have one
  std::string surface;                // the first free surface, or else the first boundary with a
                                      // traction; empty if there is none
  fem::Boundaries free_surfaces;      // all
  std::vector<fem::BoundaryResistance> resistances; // dashpots and springs
  std::vector<fem::VelocityCondition<Dim>> velocities;
  std::vector<fem::BoundaryTraction> tractions;
  double ramp_end = 0; // end of the last loading ramp [s]
};

// Whether a condition in the list, which need not be complete, is of a fault with friction: of a
// Type that is a kind of fault, without a slip rate.
bool haveFriction(ParameterList const& conditions);

// A deck without a Type that is a kind of fault may have conditions of the Type Prescribed Slip
// Rate: these are its faults, between two bodies.
//
// components: of the displacement, Dim or, in antiplane models, 1. Throws InputError on
// contradictions that can be found without the mesh.
template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(std::vector<BoundaryCondition> const& conditions,
                                               int components);
} // namespace asperity::scenario
