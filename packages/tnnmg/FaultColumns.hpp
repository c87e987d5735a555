#pragma once

#include "base/parallel/GhostExchange.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <vector>

namespace asperity::tnnmg
{
// Exchanges between ranks what products with Z and smoothing of the nonlinear nodes need of vectors
// on Z's column map. It does nothing on one rank.
class FaultColumns
{
public:
  FaultColumns(CrsMatrix const& Z, NonlinearNodes const& nodes); // collective

  // Sends owned values to ghosts: all of them, those that the nonlinear nodes' rows touch, or those
  // of the nodes of one colour.
  void shareBody(Vector& columns) const;
  void share(Vector& columns) const;
  void shareColour(std::size_t colour, Vector& columns) const;
  // Subtracts the values of the ghosts that the nonlinear nodes' rows touch from r on the ranks
  // that own them.
  void subtractGhosts(Vector const& columns, Vector& r) const;

private:
  GhostExchange body_, touched_;
  std::vector<GhostExchange> colours_; // none on one rank
};
} // namespace asperity::tnnmg
