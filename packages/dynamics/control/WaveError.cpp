#include "dynamics/control/WaveError.hpp"

#include "base/program/WorkTimers.hpp"

#include <Tpetra_Vector.hpp>

#include <cmath>

namespace asperity::dynamics
{
WaveError::WaveError(Body const& body, fem::FaultSurface const& surface, RateUpdate const& update,
                     WaveScale const& scale)
    : body_(body)
    , surface_(surface)
    , order_(update.order)
    , constant_(update.velocity_error)
    , scale_(scale)
{
  if (!body.matrices.is_massless && constant_ * scale.slip_rate * scale.weight > 0) {
    e_ = body.vector();
    w_ = BlockView("asperity::dynamics::w", surface.numNodes(), surface.numTangents());
    V_ = NodeView("asperity::dynamics::V", surface.numNodes());
  }
}

double WaveError::errorBetween(State const& from, State const& to, double tau) const
{
  if (e_.is_null()) {
    return 0;
  }
  ASPERITY_TIME_WORK("errors of waves");
  const double factor = constant_ * std::pow(tau, order_);
  auto const& end = order_ == 1 ? *to.a : *to.jerk;
  auto const& begin = order_ == 1 ? *from.a : *from.jerk;
  e_->update(factor, end, -factor, begin, 0);
  body_.clearHeld(*e_);
  gatherSlip(surface_, *to.v, w_);
  slipRate(surface_, w_, V_);
  const double rate = scale_.slip_rate + peakSlipRate(surface_, V_);
  return scale_.weight * surface_.slipFactor() * e_->normInf() / rate;
}
} // namespace asperity::dynamics
