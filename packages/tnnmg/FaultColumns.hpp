#pragma once

#include "tnnmg/Halo.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <vector>

namespace asperity::tnnmg
{
// Exchanges between ranks what smoothing of the nonlinear nodes needs of vectors on Z's column map:
// the ghosts that the rows of these nodes touch, all of them or those of one colour. It does
// nothing on one rank.
class FaultColumns
{
public:
  FaultColumns(CrsMatrix const& Z, NonlinearNodes const& nodes); // collective

  // Sends owned values to the ghosts that the nonlinear nodes' rows touch: all, or those of the
  // nodes of one colour.
  void share(Vector& columns) const;
  void shareColour(std::size_t colour, Vector& columns) const;
  // Subtracts the values of the ghosts from r on the ranks that own them.
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
