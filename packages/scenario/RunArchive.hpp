#pragma once

#include "dynamics/condensation/StaticCondensation.hpp"
#include "dynamics/control/StepControl.hpp"
#include "dynamics/observables/EnergyBalance.hpp"
#include "io/Archive.hpp"

namespace asperity::scenario
{
// The sets of nodes at which states have values: the owned vertices, the nodes of the fault, and
// the cells that may yield, of which each rank writes its own.
constexpr char const* nodes_of_body = "vertices";
constexpr char const* nodes_of_friction = "friction";
constexpr char const* yielding_cells = "yielding_cells";

// Writes states to a checkpoint and reads them. They are stored as states of the whole body even
// where the run is condensed to its fault: only runs on one rank condense, and a restart may have
// more ranks. A condensed run gets its state back bit for bit.
class StateFormat
{
public:
  // whole: the model of the whole body. condensation may be null. Both must outlive this.
  StateFormat(dynamics::Model const& whole, dynamics::StaticCondensation const* condensation,
              dynamics::DyadicTime const& clock)
      : whole_(whole)
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
  dynamics::Model const& whole_;
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
    if (archive.has(path + "/" + name)) { // a checkpoint may be older than the member
      sum.*member = archive.get<std::decay_t<decltype(sum.*member)>>(path + "/" + name);
    }
  }
  return sum;
}
} // namespace asperity::scenario
