#include "dynamics/coupling/InelasticUpdate.hpp"

#include "fem/inelastic/InelasticCells.hpp"
#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
InelasticUpdate::InelasticUpdate(fem::InelasticCells const& cells, int depth)
    : cells_(cells)
    , acceleration_(cells.weights(), cells.sharing().communicator(), depth)
    , image_(cells.none())
{
}

void InelasticUpdate::begin(Vector const& b)
{
  acceleration_.reset();
  last_change_ = ratio_ = 0;
  if (b_.is_null()) {
    b_ = rcp(new Vector(b.getMap()));
  }
  Tpetra::deep_copy(*b_, b);
}

void InelasticUpdate::rightSide(State const& to, Vector& b) const
{
  Tpetra::deep_copy(b, *b_);
  cells_.addForces(to.inelastic->strain, b);
}

void InelasticUpdate::respond(Vector const& u, double tau, State const& from)
{
  cells_.respond(u, tau, *from.inelastic, image_);
}

double InelasticUpdate::change(State const& to, Norm norm)
{
  const double now = cells_.distance(image_.strain, to.inelastic->strain, norm == Norm::maximum);
  if (now > last_change_) {
    acceleration_.reset();
  }
  ratio_ = last_change_ > 0 ? now / last_change_ : 0;
  last_change_ = now;
  return now;
}

double InelasticUpdate::distance(State const& a, State const& b, Norm norm) const
{
  return cells_.distance(a.inelastic->strain, b.inelastic->strain, norm == Norm::maximum);
}

void InelasticUpdate::advance(State& to)
{
  acceleration_.advance(overwritten(to.inelastic->strain), valuesOf(image_.strain));
}

void InelasticUpdate::copyImage(State& to) const
{
  Kokkos::deep_copy(to.inelastic->strain, image_.strain);
  Kokkos::deep_copy(to.inelastic->shear, image_.shear);
  Kokkos::deep_copy(to.inelastic->history, image_.history);
}
} // namespace asperity::dynamics
