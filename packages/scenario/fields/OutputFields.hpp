#pragma once

#include "fem/stress/CoulombPlane.hpp"
#include "io/FieldRegistry.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/fields/RunView.hpp"

#include <map>
#include <string>

namespace asperity::scenario
{
// Registers all fields and scalars that outputs may write. Problem, view and domains must outlive
// the registry. planes: those of Coulomb stress changes, by name (catalogue::coulombPlanes).
template <int Dim>
void registerFields(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    Domains const& domains, std::map<std::string, fem::CoulombPlane> const& planes);
} // namespace asperity::scenario
