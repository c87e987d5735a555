#pragma once

#include "tnnmg/NonlinearNodes.hpp"
#include "tnnmg/levels/MultigridFamily.hpp"

namespace asperity::tnnmg::detail
{
// The rows of P at the nonlinear nodes, T successive rows each, with a numbering of their own.
RCP<const CrsMatrix> rowsAtNodes(CrsMatrix const& P, NodeDofView const& fault);

// Q: T rows for each nonlinear node that this rank owns; of_level: the graph of the level's matrix.
// Collective.
CoarseFault makeCoarseFault(RCP<const CrsMatrix> const& Q, int tangents, NodeGraph const& of_level);

// A += Q^T H Q. hessian: (num owned nonlinear nodes, T, T). Collective.
void addHessians(CoarseFault const& fault, std::vector<double> const& hessian, NodeBlocks& A);
} // namespace asperity::tnnmg::detail
