#pragma once

#include "dynamics/Body.hpp"
#include "fem/FaultSurface.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <vector>

namespace asperity::dynamics
{
// The unknowns of the fault's nodes.
tnnmg::NonlinearNodes nodesOf(fem::FaultSurface const& surface);
// What multigrid needs to know about a Z of the body.
tnnmg::MultigridProblem multigridProblem(RCP<const CrsMatrix> const& Z, Body const& body,
                                         tnnmg::NonlinearNodes const& nodes);

// What multigrid solvers of all Z of a body share, which are sums of its matrices.
class SharedMultigrid
{
public:
  // parameters: of MultigridCorrection, completed. Throws SolveError if MueLu's set-up fails.
  // Collective.
  SharedMultigrid(Body const& body, fem::FaultSurface const& surface,
                  Teuchos::ParameterList const& parameters);

  tnnmg::MultigridTerms const& terms() const { return terms_; }
  std::vector<double> weights(fem::Weights const& Z) const; // of the terms

private:
  bool has_mass_ = false, has_viscosity_ = false;
  // The stiffness of the elastic body, mass and viscosity unless they are zero, and each branch.
  tnnmg::MultigridTerms terms_;
};
} // namespace asperity::dynamics
