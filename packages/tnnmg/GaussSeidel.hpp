#pragma once

#include "tnnmg/FaultColumns.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::tnnmg
{
// The curvature of the model I^m (Pipping 2014, ch. 4), (num_nodes): the largest eigenvalue of each
// node's diagonal block of Z in its free components, or for T = 3 Gershgorin's bound of it.
NodeView nodalCurvature(CrsMatrix const& Z, NonlinearNodes const& nodes);

// This rank's rows of Z on the device. A sweep gets them from Tpetra only once, because that costs
// as much as using them.
using LocalMatrix = CrsMatrix::local_matrix_device_type;

// residual(node, k) = b - sum_j Z_kj v_j + curvature v at the rows of the given nodes. This is the
// linear term of the model at v = 0; it is zero in the components that are held. v lives on Z's
// column map. Runs on the device.
void modelResidual(LocalMatrix const& matrix, NonlinearNodes const& nodes, IndexView const& which,
                   ConstNodeView const& curvature, Vector const& b, Vector const& v_columns,
                   BlockView const& residual);

// r -= Z d for a d that is zero except at the nonlinear nodes, d(num_nodes, T). Z is symmetric, so
// that the rows of these nodes serve as their columns: much less work than a product with Z, unless
// most nodes are nonlinear. columns is work space on Z's column map. Collective.
void subtractColumns(CrsMatrix const& Z, NonlinearNodes const& nodes, FaultColumns const& exchange,
                     ConstBlockView const& d, Vector& columns, Vector& r);

// One sweep of nonlinear block Gauss-Seidel over the nonlinear nodes: the model is minimised node
// by node (a colour at a time, over all ranks), so that J does not rise. Updates v_columns (v on
// Z's column map, with the ghosts that the nodes' rows touch) and blocks(num_nodes, T), the values
// of v at the nonlinear nodes. r = b - Z v is read and updated if the nodes are coupled, and not
// touched otherwise. residual(num_nodes, T) is work space. Returns the number of nodes whose
// minimisation failed on this rank.
template <class NodalProblem>
int gaussSeidel(CrsMatrix const& Z, NonlinearNodes const& nodes, FaultColumns const& exchange,
                ConstNodeView const& curvature, NodalProblem const& problem, Vector const& b,
                Vector& v_columns, Vector& r, BlockView const& blocks, BlockView const& residual);

// The system of coupled nodes with a full Z, whose entries must be stored row by row: views of the
// memory of Z and r, which must outlive the result.
CoupledSystem coupledSystem(CrsMatrix const& Z, NonlinearNodes const& nodes,
                            ConstNodeView const& curvature, Vector& r);

// Copy v(dofs) to blocks and back; v may live on the domain or on the column map (owned rows come
// first in both).
void gather(NonlinearNodes const& nodes, Vector const& v, BlockView const& blocks);
void scatter(NonlinearNodes const& nodes, IndexView const& which, ConstBlockView const& blocks,
             Vector& v);

template <class NodalProblem>
int gaussSeidel(CrsMatrix const& Z, NonlinearNodes const& nodes, FaultColumns const& exchange,
                ConstNodeView const& curvature, NodalProblem const& problem, Vector const& b,
                Vector& v_columns, Vector& r, BlockView const& blocks, BlockView const& residual)
{
  if (nodes.are_coupled) {
    auto const& all = nodes.colours.front();
    const int failures = problem.sweep(all, coupledSystem(Z, nodes, curvature, r), blocks);
    scatter(nodes, all, blocks, v_columns);
    return failures;
  }
  auto const matrix = Z.getLocalMatrixDevice();
  int failures = 0;
  for (std::size_t k = 0; k < nodes.colours.size(); ++k) {
    auto const& colour = nodes.colours[k];
    if (colour.extent(0) > 0) {
      modelResidual(matrix, nodes, colour, curvature, b, v_columns, residual);
      failures += problem.minimise(colour, curvature, residual, blocks);
      scatter(nodes, colour, blocks, v_columns);
    }
    exchange.shareColour(k, v_columns);
  }
  return failures;
}
} // namespace asperity::tnnmg
