#pragma once

#include "dynamics/condensation/VertexMotion.hpp"
#include "dynamics/control/StepControl.hpp"
#include "dynamics/observables/FaultSample.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"
#include "scenario/FloorCount.hpp"
#include "scenario/Problem.hpp"

#include <map>
#include <memory>
#include <string>

namespace asperity::scenario
{
// The present state of a run, from which outputs read; the simulation keeps it up to date.
struct RunView
{
  dynamics::State const* state = nullptr;
  dynamics::FaultSample const* fault = nullptr; // of that state
  // Computes the state of the whole body from that of a condensed model; null without condensation.
  dynamics::StaticCondensation const* condensation = nullptr;
  std::shared_ptr<dynamics::RecoveryRows> recovery_rows; // of the condensation, for receivers
  dynamics::EnergyBalance const* balance = nullptr;
  FloorCount const* floor_count = nullptr;
  dynamics::AcceptedStep step;
  dynamics::SolveCount count; // of the last step alone
};

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
