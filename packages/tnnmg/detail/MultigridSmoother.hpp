#pragma once

#include "tnnmg/detail/MultigridNodes.hpp"

#include <memory>

namespace asperity::tnnmg::detail
{
// Linear block Gauss-Seidel for Z + H on the nonlinear nodes alone, where coefficients differ by
// orders of magnitude from node to node and from solve to solve. A sweep goes colour by colour, so
// its result is the same on any number of ranks.
class MultigridSmoother
{
public:
  MultigridSmoother(CrsMatrix const& Z, std::shared_ptr<const MultigridNodes> nodes);

  // Inverts the diagonal blocks; has to be called after the blocks of the nodes have changed.
  void setup();

  enum class Order
  {
    forward,
    backward
  };

  // One sweep for (Z + H) z = r, from the given z. Forward and backward sweeps are each other's
  // adjoints.
  void sweep(Order order, MultiVector const& r, MultiVector& z) const;

private:
  void relax(IndexView const& colour, MultiVector const& r, MultiVector& z) const;

  std::shared_ptr<const MultigridNodes> nodes_;
  RCP<const CrsMatrix> rows_;   // of Z, T successive ones per node
  RCP<const Import> columns_;   // to the columns of these rows
  RCP<MultiVector> neighbours_; // z at these columns
  NodeBlockView inverse_;       // (num_nodes, T, T) of diagonal + Hessian, zero where removed
};
} // namespace asperity::tnnmg::detail
