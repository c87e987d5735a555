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

// A sum over the steps of a run, dynamics::SolveCount or Energy, member by member.
template <class Sum>
void saveSum(io::Archive& archive, std::string const& path, Sum const& sum)
{
  for (auto const& [name, member] : Sum::members()) {
    archive.set(path + "/" + name, sum.*member);
  }
}
template <class Sum>
Sum loadSum(io::Archive const& archive, std::string const& path)
{
  Sum sum;
  for (auto const& [name, member] : Sum::members()) {
    sum.*member = archive.get<std::decay_t<decltype(sum.*member)>>(path + "/" + name);
  }
  return sum;
}
} // namespace asperity::scenario
