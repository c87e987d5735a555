#include "tnnmg/detail/MultigridParameters.hpp"

#include "base/parameters/Parameters.hpp"
#include "tnnmg/detail/MultigridHierarchy.hpp"

#include <string>

namespace asperity::tnnmg::detail
{
namespace
{
bool isAboutSmoothers(std::string const& name) { return name.rfind("smoother:", 0) == 0; }

// What MueLu is told. A user who says anything about smoothers chooses them entirely: MueLu does
// not take parameters of one smoother for another.
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
            "Conjugate gradients with a V-cycle as preconditioner, or cycles with an optimal step "
            "length each.")
    .integer("Maximum Iterations", 200, Range::atLeast(1),
             "Of conjugate gradients, in one correction.")
    .integer("V-Cycles", 1, Range::atLeast(1), "At most, in one correction by V-Cycles.")
    .choice("Hierarchy", "Automatic", {"Automatic", "Keep", "Rebuild"},
            "Whether the Galerkin products are repeated when truncated nodes change. Automatic "
            "finds out by a "
            "trial for each step size: they are worth it in large steps.")
    .real(
      "Outdated Share", 0.1, "-", Range::closedOpen(0, 1),
      "The share of the fault's nodes that may be newly truncated, or no longer, or have another "
      "Hessian by an order of magnitude, before the hierarchy is rebuilt.")
    .hint("A tenth costs one or two iterations; a rebuild as much as four V-cycles in 2D, fifteen "
          "in 3D.")
    .foreignSublist(
      "MueLu", ParameterList("MueLu"),
      "In MueLu's spelling; replaces the defaults one by one, but smoothers as a whole.")
    .foreignSublist("Belos", ParameterList("Belos"),
                    "For Belos's pseudo block CG, in Belos's spelling.")
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
  muelu = completeMueLu(list.sublist("MueLu"), components, given.name() + " / MueLu");
  belos = list.sublist("Belos");
}
} // namespace asperity::tnnmg::detail
