#include "dynamics/coupling/InelasticUpdate.hpp"

#include "fem/inelastic/InelasticCells.hpp"

namespace asperity::dynamics
{
namespace
{
// Rows of a list, (num_cells, components).
template <class Tensors, class List>
Tensors rowsOf(List const& list, int num_cells)
{
  return Tensors(list.data(), num_cells, num_cells > 0 ? list.extent(0) / num_cells : 0);
}
} // namespace

ConstNodeView YieldingCells::weights() const { return cells_.weights(); }

RCP<const Communicator> YieldingCells::communicator() const
{
  return cells_.sharing().communicator();
}

double YieldingCells::distance(ConstNodeView const& values, ConstNodeView const& exact,
                               Norm norm) const
{
  return cells_.distance(rowsOf<fem::ConstTensorView>(values, cells_.numCells()),
                         rowsOf<fem::ConstTensorView>(exact, cells_.numCells()),
                         norm == Norm::maximum);
}

InelasticUpdate::InelasticUpdate(fem::InelasticCells const& cells)
    : cells_(cells)
    , space_(cells)
    , image_(cells.none())
{
}

void InelasticUpdate::addForces(State const& to, Vector& b) const
{
  cells_.addForces(to.inelastic->strain, b);
}

int InelasticUpdate::respond(StepIterate const& step, NodeView const& image)
{
  const auto strain = rowsOf<fem::TensorView>(image, cells_.numCells());
  cells_.respond(*step.u_in_body, step.tau, *step.from.inelastic,
                 {strain, image_.shear, image_.history});
  return 0;
}

void InelasticUpdate::finish(ConstNodeView const& image, State const& to) const
{
  Kokkos::deep_copy(valuesIn(to), image);
  Kokkos::deep_copy(to.inelastic->shear, image_.shear);
  Kokkos::deep_copy(to.inelastic->history, image_.history);
}
} // namespace asperity::dynamics
