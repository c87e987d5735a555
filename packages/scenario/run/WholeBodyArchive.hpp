#pragma once

#include "dynamics/DyadicTime.hpp"
#include "dynamics/StateArchive.hpp"
#include "dynamics/condensation/StaticCondensation.hpp"

#include <optional>
#include <string>

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
class WholeBodyArchive : public dynamics::StateArchive
{
public:
  // whole: the model of the whole body. condensation may be null. Both must outlive this.
  // stored_level: DyadicTime::finestLevel() of the run that has written the archive to read, if
  // that is not `clock`.
  WholeBodyArchive(dynamics::Model const& whole, dynamics::StaticCondensation const* condensation,
                   dynamics::DyadicTime const& clock, std::optional<int> stored_level = {})
      : whole_(whole)
      , condensation_(condensation)
      , clock_(clock)
      , stored_level_(stored_level)
  {
  }

  void save(Archive& archive, std::string const& path, dynamics::State const& state) const override;
  dynamics::State load(Archive const& archive, std::string const& path) const override;

private:
  dynamics::Model const& whole_;
  dynamics::StaticCondensation const* condensation_;
  dynamics::DyadicTime clock_;
  std::optional<int> stored_level_;
};
} // namespace asperity::scenario
