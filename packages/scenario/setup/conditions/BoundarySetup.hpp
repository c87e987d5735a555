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
struct BoundaryCondition;

// What all conditions of a deck contribute to the model.
template <int Dim>
struct BoundaryConditions
{
  // The faults: none, one, or several if they lie between two bodies. Several faults form one
  // surface.
  fem::Boundaries faults;
  fem::Boundaries given_slip; // those of them whose slip is prescribed; all others have friction
  // What lies on the other side, the same for all faults.
  fem::OtherSide other_side;
  std::vector<PlateRate> plate_rates; // of the faults that have one
  std::string surface;                // the first free surface, or else the first boundary with a
                                      // traction; empty if there is none
  fem::Boundaries free_surfaces;      // all
  std::vector<fem::BoundaryResistance> resistances; // dashpots and springs
  std::vector<fem::VelocityCondition<Dim>> velocities;
  std::vector<fem::BoundaryTraction> tractions;
};

// The faults but those whose slip is prescribed.
template <int Dim>
fem::Boundaries faultsWithFriction(BoundaryConditions<Dim> const& conditions);

// Joins all conditions of a deck. Where none is of a kind of fault, conditions of the Type
// Prescribed Slip Rate are its faults, between two bodies.
//
// components: of the displacement, Dim or, in antiplane models, 1. Throws InputError on
// contradictions that can be found without the mesh.
template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(std::vector<BoundaryCondition> const& conditions,
                                               int components);
} // namespace asperity::scenario
