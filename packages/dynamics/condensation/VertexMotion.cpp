#include "dynamics/condensation/VertexMotion.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <numeric>

namespace asperity::dynamics
{
std::size_t RecoveryRows::length() const
{
  return static_cast<std::size_t>(condensation_.model().body.numOwnedDofs());
}

bool RecoveryRows::add(std::vector<int> const& dofs)
{
  // Products with the rows would cost more than the motion of the whole body.
  if (dofs.size() * length() >= condensation_.factorEntries()) {
    are_refused_ = true;
    return false;
  }
  for (int dof : dofs) {
    if (rows_.count(dof) == 0) {
      rows_.emplace(dof, condensation_.recoveryRow(dof));
    }
  }
  return true;
}

double RecoveryRows::value(int dof, double const* x) const
{
  auto const& row = rows_.at(dof);
  return std::inner_product(row.begin(), row.end(), x, 0.);
}

VertexMotion::VertexMotion(Body const& whole, fem::NodalFrames const& frames,
                           std::vector<int> vertices, bool with_ghosts,
                           StaticCondensation const* condensation,
                           std::shared_ptr<RecoveryRows> rows)
    : whole_(whole)
    , frames_(frames)
    , vertices_(std::move(vertices))
    , with_ghosts_(with_ghosts)
    , condensation_(condensation)
    , rows_(std::move(rows))
{
  if (rows_) {
    addRows();
  }
}

void VertexMotion::addRows()
{
  for (int vertex : vertices_) {
    for (auto const& term : frames_.terms(vertex)) {
      for (int c = 0; c < whole_.dofs->components(); ++c) {
        dofs_.push_back(whole_.dofs->dof(term.node, c));
      }
    }
  }
  std::sort(dofs_.begin(), dofs_.end());
  dofs_.erase(std::unique(dofs_.begin(), dofs_.end()), dofs_.end());
  if (!rows_->add(dofs_)) {
    rows_ = nullptr;
  }
}

RCP<const Vector> VertexMotion::withGhosts(RCP<const Vector> const& owned) const
{
  if (!with_ghosts_) {
    return owned;
  }
  auto const result = rcp(new Vector(whole_.dofs->overlap()));
  whole_.dofs->shareWithGhosts(*owned, *result);
  return result;
}

std::vector<double> VertexMotion::operator()(Vector const& of_state) const
{
  if (!condensation_) {
    return fem::alongAxes(frames_, *whole_.dofs, *withGhosts(Teuchos::rcpFromRef(of_state)),
                          vertices_);
  }
  auto const recovered = whole_.vector(); // on one rank, without ghosts
  if (rows_) {
    auto const x = of_state.getLocalViewHost(Tpetra::Access::ReadOnly);
    auto const values = recovered->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int dof : dofs_) {
      values(dof, 0) = rows_->value(dof, x.data());
    }
  } else {
    condensation_->expand(of_state, *recovered);
  }
  return fem::alongAxes(frames_, *whole_.dofs, *recovered, vertices_);
}
} // namespace asperity::dynamics
