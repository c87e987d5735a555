#include "dynamics/rate/SharedMultigrid.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <iterator>

namespace asperity::dynamics
{
namespace
{
std::vector<tnnmg::MultigridTerms::MatrixSource> termsOf(Body const& body, bool has_mass,
                                                         bool has_viscosity)
{
  const auto term = [&](fem::Weights const& weights) {
    return [&body, weights]() -> RCP<const CrsMatrix> {
      return fem::combine(body.matrices, weights, body.held);
    };
  };
  std::vector<tnnmg::MultigridTerms::MatrixSource> terms = {
    term(fem::elasticityWeights(body.matrices))};
  if (has_mass) {
    terms.emplace_back(term(fem::massWeights()));
  }
  if (has_viscosity) {
    terms.emplace_back(term(fem::viscosityWeights()));
  }
  for (std::size_t k = 0; k < body.matrices.branches.size(); ++k) {
    terms.emplace_back(term(fem::branchWeights(body.matrices, k)));
  }
  return terms;
}
} // namespace

tnnmg::NonlinearNodes nodesOf(fem::FaultSurface const& surface)
{
  return {surface.unknowns(), surface.heldDofs(), surface.colours()};
}

tnnmg::MultigridProblem multigridProblem(RCP<const CrsMatrix> const& Z, Body const& body,
                                         tnnmg::NonlinearNodes const& nodes)
{
  return {Z, body.dofs->components(), body.near_null_space, body.held.ownedOnDevice(), nodes};
}

SharedMultigrid::SharedMultigrid(Body const& body, fem::FaultSurface const& surface,
                                 Teuchos::ParameterList const& parameters)
    : has_mass_(!body.matrices.is_massless)
    , has_viscosity_(body.matrices.viscosity->getFrobeniusNorm() > 0)
{
  // MultigridTerms reads the nodes of the problem, and not its matrix.
  terms_ =
    tnnmg::MultigridTerms(termsOf(body, has_mass_, has_viscosity_),
                          multigridProblem(Teuchos::null, body, nodesOf(surface)), parameters);
}

std::vector<double> SharedMultigrid::weights(fem::Weights const& Z) const
{
  std::vector<double> result = {Z.stiffness};
  if (has_mass_) {
    result.push_back(Z.mass);
  }
  if (has_viscosity_) {
    result.push_back(Z.viscosity);
  }
  // The first term has the branches, too.
  std::transform(Z.branches.begin(), Z.branches.end(), std::back_inserter(result),
                 [&](double weight) { return weight - Z.stiffness; });
  return result;
}
} // namespace asperity::dynamics
