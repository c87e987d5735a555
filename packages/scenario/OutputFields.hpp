#pragma once

#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"
#include "scenario/RunView.hpp"
#include "scenario/problem/Problem.hpp"

#include <map>
#include <string>

namespace asperity::scenario
{
// The domains of the outputs by name: fault, volume and, if the deck has one, the free surface.
// Collective.
template <int Dim>
std::map<std::string, io::OutputDomain> makeDomains(Problem<Dim> const& problem);

// Registers all fields and scalars. Problem, view and domains must outlive the registry;
// `friction` is the deck's list.
template <int Dim>
void registerFields(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    std::map<std::string, io::OutputDomain> const& domains,
                    ParameterList const& friction);

// Registers stress, strain and the Coulomb stress changes on the planes of `output`, the deck's
// list, in the volume and on the surface, with the same lifetimes.
template <int Dim>
void registerStress(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    std::map<std::string, io::OutputDomain> const& domains,
                    ParameterList const& output);
} // namespace asperity::scenario
