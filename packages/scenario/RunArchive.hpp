#pragma once

#include "dynamics/condensation/StaticCondensation.hpp"
#include "dynamics/control/StepControl.hpp"
#include "dynamics/observables/EnergyBalance.hpp"
#include "io/Archive.hpp"

namespace asperity::scenario
{
// The sets of nodes at which states have values: the owned vertices, and the nodes of the fault.
constexpr char const* nodes_of_body = "vertices";
constexpr char const* nodes_of_friction = "friction";

// Writes states to a checkpoint and reads them. They are stored as states of the whole body even
// where the run is condensed to its fault: only runs on one rank condense, and a restart may have
// more ranks. A condensed run gets its state back bit for bit.
class StateFormat
{
public:
  // like: a state of the whole body. condensation may be null. Both must outlive this.
  StateFormat(dynamics::State const& like, dynamics::StaticCondensation const* condensation,
              dynamics::DyadicTime const& clock)
      : like_(like)
      , condensation_(condensation)
      , clock_(clock)
  {
  }

  void save(io::Archive& archive, std::string const& path, dynamics::State const& state) const;
  dynamics::State load(io::Archive const& archive, std::string const& path) const;

  void save(io::Archive& archive, std::string const& path,
            dynamics::ControlMemory const& memory) const;
  dynamics::ControlMemory loadControl(io::Archive const& archive, std::string const& path) const;

private:
  dynamics::State const& like_;
  dynamics::StaticCondensation const* condensation_;
  dynamics::DyadicTime clock_;
};

void save(io::Archive& archive, std::string const& path, dynamics::SolveCount const& count);
dynamics::SolveCount loadCount(io::Archive const& archive, std::string const& path);

void save(io::Archive& archive, std::string const& path, dynamics::Energy const& energy);
dynamics::Energy loadEnergy(io::Archive const& archive, std::string const& path);
} // namespace asperity::scenario
