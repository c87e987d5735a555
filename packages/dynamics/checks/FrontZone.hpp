#pragma once

#include "dynamics/fault/Fault.hpp"

#include <optional>
#include <vector>

namespace asperity::dynamics
{
// How the cells of a fault compare with the zone behind a front of slip in which friction falls.
//
// At constant slip rate friction falls with slip s by W = -sigma_n b d(alpha)/ds. Slip that varies
// over a length x meets a stiffness of about G' / x, so that the zone has the length G' / W
// (Ampuero & Rubin 2008): with Lambda0 = G' L / (b sigma_n)
//
//   ageing law   Lambda0 / (1 - L / (V theta)), which is Lambda0 at a front,
//   slip law     Lambda0 / ln(V theta / L), a tenth or less where the fault has healed before,
//
// whether friction weakens with the slip rate in the end (b > a) or not. Where a cell is longer,
// its own stiffness is less than W, and it slips by itself, in a jump.
class FrontZone
{
public:
  struct Narrowest
  {
    double cells;  // length of the zone over that of the larger cell beside the node
    double length; // G' / W [m]
    int node;      // -1 on ranks that do not have it
  };

  // All (num_nodes): slip_modulus G' [Pa] (FaultResolution.hpp), b, L [m], and the length of the
  // larger cell beside the node [m]. slides: whether friction acts there. Collective.
  FrontZone(std::vector<double> slip_modulus, std::vector<double> const& b,
            std::vector<double> const& L, std::vector<double> const& cell,
            std::vector<bool> const& slides, RCP<const Communicator> communicator);

  // The zone that has the fewest cells, on all ranks, among the nodes that slip at a tenth of the
  // largest slip rate or faster; empty if friction falls at none of them. V(num_nodes) [m/s];
  // given: what friction depends on. Collective.
  std::optional<Narrowest> narrowest(friction::StateKernels const& state, ConstNodeView const& V,
                                     friction::StateAndStress const& given) const;

private:
  NodeView modulus_; // G' / b [Pa]
  NodeView cell_;    // [m]
  FlagView slides_;  // 0 where b is 0 as well
  double shortest_;  // L [m], on all ranks
  RCP<const Communicator> communicator_;
};
} // namespace asperity::dynamics
