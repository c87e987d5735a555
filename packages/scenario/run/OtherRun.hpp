#pragma once

#include "base/Archive.hpp"
#include "dynamics/DyadicTime.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/problem/Problem.hpp"

#include <filesystem>
#include <string>

namespace asperity::scenario
{
// The state of another run for a new one, as WholeBodyArchive reads it from "state", and its
// warnings, for RunRecord::inherit. `run` is the directory of a run of this program, or a
// checkpoint in it. The other run's mesh and fields may differ: displacement since the start and
// the rates are interpolated linearly in the other run's cells, the state variable and the change
// of the normal stress along its fault; the inelastic strain and the internal variables of rock are
// those of the cell at the centroid of each new one. The initial displacement and normal stress
// (gravity) are those of the new deck. The time is the other run's, in ticks of `clock`.
//
// InputError, on every rank, if the dimension, the components of the displacement, the laws, the
// relaxation times, the internal variables of the rock or the kind of fault differ, if rock has
// yielded where it cannot yield now, if a point of the new mesh is farther from the
// other one than a tenth of the element there, or if the time of the state is not before `end` [s].
// Collective.
template <int Dim>
Archive stateOfOtherRun(std::filesystem::path const& run, Problem<Dim> const& problem,
                        Domains const& domains, dynamics::DyadicTime const& clock, double end);
} // namespace asperity::scenario
