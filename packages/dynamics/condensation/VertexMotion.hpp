#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/condensation/StaticCondensation.hpp"
#include "fem/constraints/NodalFrames.hpp"

#include <map>
#include <memory>
#include <vector>

namespace asperity::dynamics
{
// What the rows cost, in products for each field.
struct RecoveryCost
{
  std::size_t num_rows = 0, row_length = 0; // the motion by rows: num_rows row_length products
  std::size_t of_body = 0;                  // products of the motion of the whole body
  bool are_refused = false; // whether add() has made no rows since there would be too many
};

// Rows of StaticCondensation::expand by the dof of the whole body, each made once.
class RecoveryRows
{
public:
  explicit RecoveryRows(StaticCondensation const& condensation) : condensation_(condensation) {}

  // Makes the rows that are missing. If all these rows have at least as many numbers as expand()
  // reads, makes none and returns false.
  bool add(std::vector<int> const& dofs);
  // The entry of expand(x) at a dof that has a row; x(length()).
  double value(int dof, double const* x) const;
  std::size_t size() const { return rows_.size(); }
  std::size_t length() const; // of a row
  RecoveryCost cost() const
  {
    return {size(), length(), condensation_.factorEntries(), are_refused_};
  }

private:
  StaticCondensation const& condensation_;
  bool are_refused_ = false;
  std::map<int, std::vector<double>> rows_;
};

// Vectors of displacement, velocity or acceleration at chosen vertices, along the axes, from those
// of a model's state. Refers to the arguments of its constructor, which must outlive it.
class VertexMotion
{
public:
  // `whole` is the body of the mesh. condensation: that of the model whose states are given, or
  // null if they are states of `whole`. rows: to compute the motion of few vertices without that of
  // the whole body, or null.
  // vertices: local ones, ghosts among them only if with_ghosts, which is the same on all ranks.
  VertexMotion(Body const& whole, fem::NodalFrames const& frames, std::vector<int> vertices,
               bool with_ghosts, StaticCondensation const* condensation = nullptr,
               std::shared_ptr<RecoveryRows> rows = nullptr);

  // (vertices, components). Collective if there are ghosts.
  std::vector<double> operator()(Vector const& of_state) const;

private:
  void addRows();
  RCP<const Vector> withGhosts(RCP<const Vector> const& owned) const;

  Body const& whole_;
  fem::NodalFrames const& frames_;
  std::vector<int> vertices_;
  bool with_ghosts_;
  StaticCondensation const* condensation_;
  std::shared_ptr<RecoveryRows> rows_; // null: the whole body is recovered
  std::vector<int> dofs_;              // that have rows
};
} // namespace asperity::dynamics
