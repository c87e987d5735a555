#pragma once

#include "tnnmg/RateMatrix.hpp"

#include <vector>

namespace asperity::tnnmg
{
// A full Z on one rank, all of whose rows belong to nonlinear nodes: the fault without the body. A
// sweep visits the nodes one after the other and keeps r up to date.
class DenseRateMatrix final : public RateMatrix
{
public:
  // Z(size, size) is symmetric; the rows of a node's block_size components follow those of the node
  // before. rows: a map of them; held(size).
  DenseRateMatrix(ConstBlockView const& Z, RCP<const Map> const& rows, int block_size,
                  std::vector<int> const& held);

  ConstBlockView const& entries() const { return Z_; }

  void apply(Vector const& x, Vector& y) const override;
  void sumMagnitudes(Vector const& x, Vector& y) const override;
  int sweep(NodalProblem const& problem, Vector const& b, Vector& v_columns, Vector& r,
            BlockView const& blocks, BlockView const& residual) const override;
  void finishSweeps(ConstBlockView const&, Vector const&, Vector const&, Vector&) const override {}

private:
  ConstBlockView Z_;
  decltype(toHost(ConstBlockView())) on_host_; // the same memory, unless nodes live on a device
};
} // namespace asperity::tnnmg
