#include "tnnmg/detail/MultigridParameters.hpp"

#include "base/parameters/Parameters.hpp"
#include "tnnmg/detail/MultigridHierarchy.hpp"

#include <string>

namespace asperity::tnnmg::detail
{
namespace
{
bool isAboutSmoothers(std::string const& name) { return name.rfind("smoother:", 0) == 0; }

// MueLu's complete list. If the user gives any entry about smoothers, all our entries about
// smoothers are left out, because MueLu refuses parameters of one smoother for another.
ParameterList completeMueLu(ParameterList const& given, int components, std::string const& path)
{
  for (char const* ours :
       {"coarse: type", "repartition: enable", "reuse: type", "number of equations"}) {
    ASPERITY_REQUIRE(!given.isParameter(ours),
                     path << " / " << ours
                          << " cannot be chosen: rank 0 solves on the coarsest level by a Cholesky "
                          << "factorisation, and the hierarchy is rebuilt in place. Remove it.");
  }
  auto list = MultigridHierarchy::defaults(components);
  bool chooses_smoothers = false;
  for (auto const& entry : given) {
    chooses_smoothers = chooses_smoothers || isAboutSmoothers(entry.first);
  }
  if (chooses_smoothers) {
    list.remove("smoother: type");
    list.remove("smoother: params");
  }
  list.setParameters(given);
  return list;
}
} // namespace

Teuchos::RCP<const ParameterList> MultigridParameters::valid()
{
  return Declare()
    .choice("Method", "CG", {"CG", "V-Cycles"},
            "Selects how the correction is solved. CG: conjugate gradients use a V-cycle as "
            "preconditioner. V-Cycles: a few V-cycles are made, each with an optimal step length.")
    .integer("Maximum Iterations", 200, Range::atLeast(1),
             "Conjugate gradients make at most this number of iterations in one correction.")
    .integer("V-Cycles", 1, Range::atLeast(1),
             "With Method = V-Cycles one correction makes at most this number of cycles.")
    .choice("Hierarchy", "Automatic", {"Automatic", "Keep", "Rebuild"},
            "Selects whether the Galerkin products are repeated when truncated nodes change. "
            "Automatic decides by a trial for each step size: in large steps they pay off.")
    .real(
      "Outdated Share", 0.1, "-", Range::closedOpen(0, 1),
      "The hierarchy is rebuilt when more than this share of the fault's nodes has become "
      "truncated, is no longer truncated, or has a Hessian that changed by an order of magnitude.")
    .hint("A share of 0.1 costs one or two more iterations; a rebuild costs as much as four "
          "V-cycles in 2D and fifteen in 3D.")
    .foreignSublist("MueLu", ParameterList("MueLu"),
                    "MueLu reads these entries, in its own spelling. Each replaces one default; an "
                    "entry about smoothers replaces all defaults of smoothers.")
    .foreignSublist(
      "Belos", ParameterList("Belos"),
      "Belos reads these entries, in its own spelling, for its pseudo-block conjugate gradients.")
    .list();
}

MultigridParameters::MultigridParameters(ParameterList const& given, int components)
{
  ParameterList list(given);
  completeAndValidate(list, *valid(), given.name());
  method = list.get<std::string>("Method") == "CG" ? Method::conjugate_gradients : Method::v_cycles;
  max_iterations = list.get<int>("Maximum Iterations");
  v_cycles = list.get<int>("V-Cycles");
  const auto choice = list.get<std::string>("Hierarchy");
  hierarchy = choice == "Keep"      ? Hierarchy::keep
              : choice == "Rebuild" ? Hierarchy::rebuild
                                    : Hierarchy::automatic;
  outdated_share = list.get<double>("Outdated Share");
  muelu =
    completeMueLu(list.sublist("MueLu"), components, "Asperity / TNNMG / MueLu Correction / MueLu");
  belos = list.sublist("Belos");
}
} // namespace asperity::tnnmg::detail
