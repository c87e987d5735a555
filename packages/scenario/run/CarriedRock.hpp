#pragma once

#include "base/Archive.hpp"
#include "dynamics/State.hpp"
#include "io/OutputDomain.hpp"
#include "scenario/problem/Problem.hpp"

#include <filesystem>
#include <string>

namespace asperity::scenario
{
// The internal variables of a body's rock, for messages: "inelastic_strain, inelastic_shear,
// back_stress (3)", or "none" if no cell yields.
std::string internalVariables(dynamics::Body const& body);

// Sets the inelastic strain and the internal variables in the archive as WholeBodyArchive reads
// them: each cell has those of the other run's cell in which its centroid lies, each variable by
// its name. Both bodies have the same internalVariables(), and at least one. `from`: the other
// run's volume.
//
// InputError, on every rank, if rock has yielded in the other run where it is elastic now: its
// stress would be another one. Collective.
template <int Dim>
void carryRock(Problem<Dim> const& other, dynamics::State const& state,
               io::OutputDomain const& from, Problem<Dim> const& problem,
               std::filesystem::path const& run, Archive& archive);
} // namespace asperity::scenario
