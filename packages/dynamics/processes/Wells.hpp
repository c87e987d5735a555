#pragma once

#include "fem/FaultMesh.hpp"
#include "parameters/Parameters.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
class Field;
}

namespace asperity::dynamics
{
// Points of a fault where fluid is pumped in or out: each a sublist of any name with a place and a
// rate in time, which the nodes of its facet share as linear elements do.
class Wells
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters(); // for Declare::openSublist

  // list: completed, with a sublist for each well; `path` is where it stands. Throws InputError,
  // which names the well, if one is further from the fault than the size of the cell there.
  // Collective.
  Wells(Teuchos::ParameterList const& list, std::string const& path, fem::FaultMesh const& mesh);
  ~Wells();

  bool dependOnTime() const;
  // A line for each well, the same on all ranks: its place, and how many nodes share its rate.
  std::vector<std::string> const& remarks() const { return remarks_; }
  // rates(num_nodes) += what flows into this rank's nodes at the time t [s]: volume per time in
  // three dimensions [m^3/s], per metre of thickness in two [m^2/s].
  void add(double t, std::vector<double>& rates) const;

private:
  struct Well;
  std::vector<std::unique_ptr<Well>> wells_;
  std::vector<std::string> remarks_;
};
} // namespace asperity::dynamics
