#pragma once

#include "dynamics/EnergyBalance.hpp"
#include "dynamics/control/StepControl.hpp"
#include "io/checkpoint/Archive.hpp"

namespace asperity::scenario
{
// Save the parts of a run in a checkpoint and load them. `like` gives the shapes of the state that
// is loaded.
void save(io::Archive& archive, std::string const& path, dynamics::State const& state);
dynamics::State loadState(io::Archive const& archive, std::string const& path,
                          dynamics::State const& like);

void save(io::Archive& archive, std::string const& path, dynamics::ControlMemory const& memory);
dynamics::ControlMemory loadControl(io::Archive const& archive, std::string const& path,
                                    dynamics::State const& like);

void save(io::Archive& archive, std::string const& path, dynamics::SolveCount const& count);
dynamics::SolveCount loadCount(io::Archive const& archive, std::string const& path);

void save(io::Archive& archive, std::string const& path, dynamics::Energy const& energy);
dynamics::Energy loadEnergy(io::Archive const& archive, std::string const& path);
} // namespace asperity::scenario
