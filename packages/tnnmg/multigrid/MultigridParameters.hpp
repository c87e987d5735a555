#pragma once

#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

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
  enum class CycleBy
  {
    us,
    muelu
  };
  CycleBy cycle_by = CycleBy::us;
  Method method = Method::conjugate_gradients;
  int max_iterations = 0;
  int v_cycles = 0;
  bool rebuilds = true;      // the coarse levels follow the Hessians
  double outdated_share = 0; // of the nonlinear nodes
  Aggregation aggregation;
  Teuchos::ParameterList muelu_cycle; // complete, if the cycle is MueLu's
  Teuchos::ParameterList belos;

  static Teuchos::RCP<const Teuchos::ParameterList> valid();

  // Throws InputError if the list is not valid. `components` is the number of displacement
  // components of a node.
  MultigridParameters(Teuchos::ParameterList const& given, int components);
};
} // namespace asperity::tnnmg::detail
