#pragma once

#include "fem/stress/CoulombPlane.hpp"
#include "io/FieldRegistry.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/fields/RunView.hpp"

#include <map>
#include <string>

namespace asperity::scenario
{
// For all functions of this file, problem, view and domain must outlive the registry.

// Registers displacement, velocity and acceleration, along the axes, at the vertices of a domain.
template <int Dim>
void registerMotion(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    io::OutputDomain const& domain);

// Registers stress, strain and the Coulomb stress changes on these planes, in the volume and on the
// surface.
template <int Dim>
void registerStress(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    Domains const& domains, std::map<std::string, fem::CoulombPlane> const& planes);
} // namespace asperity::scenario
