#pragma once

#include "multigrid/Cycle.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>

namespace asperity::tnnmg::detail
{
// The parameters of MultigridCorrection as values.
struct MultigridParameters
{
  enum class Method
  {
    conjugate_gradients,
    v_cycles
  };
  enum class CycleKind
  {
    asperity,
    muelu
  };
  CycleKind cycle = CycleKind::asperity;
  std::string smoother = multigrid::Cycle::usual_smoother; // of our cycle
  Method method = Method::conjugate_gradients;
  int max_iterations = 200;
  int v_cycles = 1;
  bool rebuilds = true;        // the coarse levels follow the Hessians
  double outdated_share = 0.1; // of the nonlinear nodes
  Aggregation aggregation;
  Teuchos::ParameterList muelu_cycle; // complete, if the cycle is MueLu's
  Teuchos::ParameterList belos;

  static Teuchos::RCP<const Teuchos::ParameterList> valid();

  // Throws InputError if the list is not valid. `components` is the number of displacement
  // components of a node.
  static MultigridParameters from(Teuchos::ParameterList const& given, int components);
};
} // namespace asperity::tnnmg::detail
