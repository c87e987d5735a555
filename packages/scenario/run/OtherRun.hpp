#pragma once

#include "dynamics/control/DyadicTime.hpp"
#include "io/OutputDomain.hpp"
#include "io/checkpoint/Archive.hpp"
#include "scenario/Problem.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace asperity::scenario
{
// What the values of a checkpoint of the problem may belong to.
template <int Dim>
io::NodeSets nodeSets(Problem<Dim> const& problem,
                      std::map<std::string, io::OutputDomain> const& domains);

// The state of another run for a new one, as StateFormat reads it from "state": `run` is the
// directory of a run of this program, or a checkpoint in it. The other run's mesh and fields may
// differ: displacement since the start and the rates are interpolated linearly in the other run's
// cells, the state variable and the change of the normal stress along its fault. What the body
// bears at the start (gravity) is the new deck's own. The time is the other run's, as `clock` has
// it.
//
// InputError, on every rank, if the dimension, the components of the displacement, the laws or the
// kind of fault differ, if a fault lies inside one of the bodies, if a point of the new mesh is
// farther from the other one than a tenth of the element there, or if the time of the state is not
// before `end` [s]. Collective.
template <int Dim>
io::Archive stateOfOtherRun(std::filesystem::path const& run, Problem<Dim> const& problem,
                            std::map<std::string, io::OutputDomain> const& domains,
                            ParameterList const& deck, dynamics::DyadicTime const& clock,
                            double end);
} // namespace asperity::scenario
