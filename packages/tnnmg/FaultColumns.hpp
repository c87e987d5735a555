#pragma once

#include "tnnmg/Halo.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <vector>

namespace asperity::tnnmg
{
// What ranks send each other of vectors on Z's column map while the nonlinear nodes are smoothed:
// the ghosts that the rows of these nodes touch, and of these one colour at a time. Nothing on one
// rank.
class FaultColumns
{
public:
  FaultColumns(CrsMatrix const& Z, NonlinearNodes const& nodes); // collective

  // Owned values to the ghosts that the nonlinear nodes' rows touch: all, or those of the nodes of
  // one colour.
  void share(Vector& columns) const;
  void shareColour(std::size_t colour, Vector& columns) const;
  // r -= what ghosts have, for the owners of the ghosts.
  void subtractGhosts(Vector const& columns, Vector& r) const;

private:
  // A halo with its places on the device and its buffers.
  struct Part
  {
    Part() = default;
    Part(Halo const& of, int num_owned);
    void share(Vector& columns) const;

    Halo halo;
    IndexView sent, received; // places in the column map
    NodeView sent_values, received_values;
  };

  Part all_;
  std::vector<Part> colours_;
};
} // namespace asperity::tnnmg
