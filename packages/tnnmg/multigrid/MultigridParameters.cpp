#include "tnnmg/multigrid/MultigridParameters.hpp"

#include "parameters/Parameters.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <string>

namespace asperity::tnnmg::detail
{
namespace
{
bool isAboutSmoothers(std::string const& name) { return name.rfind("smoother:", 0) == 0; }

// MueLu's complete list.
ParameterList completeMueLu(ParameterList const& given, int components, std::string const& path)
{
  for (auto const& entry : given) {
    auto const& name = entry.first;
    ASPERITY_REQUIRE(
      !isAboutSmoothers(name) && name != "coarse: type" && name != "repartition: enable" &&
        name != "reuse: type" && name != "number of equations",
      path << " / " << name
           << " cannot be chosen: of MueLu only the prolongators are used, and the V-cycle has "
           << "smoothers and a coarse solver of its own. Remove it.");
  }
  auto list = MultigridHierarchy::defaults(components);
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
    .choice("Hierarchy", "Rebuild", {"Keep", "Rebuild"},
            "Selects whether the Hessians of friction are brought into the coarse levels when they "
            "change.")
    .real("Outdated Share", 0.1, "-", Range::closedOpen(0, 1),
          "The coarse levels are brought up to date when more than this share of the fault's nodes "
          "has become truncated, is no longer truncated, or has a Hessian that changed by more "
          "than a factor of three.")
    .hint("A larger share costs more iterations, a smaller one more updates.")
    .integer("Rows per Rank", 1000, Range::atLeast(0),
             "A coarse level with fewer rows per rank on average moves to fewer ranks, so that the "
             "coarsest level does not grow with the number of ranks. With 0 all levels stay on all "
             "ranks.")
    .choice("Row Order", "Default", {"Default", "Chunks", "Colours"},
            "Selects the order of the rows in sweeps. Chunks: each thread of the host takes rows "
            "that follow one another. Colours: rows that are not coupled are taken at the same "
            "time. Default: Colours on a device, else Chunks.")
    .foreignSublist("MueLu", ParameterList("MueLu"),
                    "MueLu reads these entries, in its own spelling, when it makes the "
                    "prolongators. Each replaces one default.")
    .foreignSublist(
      "Belos", ParameterList("Belos"),
      "Belos reads these entries, in its own spelling, for its pseudo-block conjugate gradients, "
      "which solve corrections to a relative residual below 1e-3; looser ones do not use Belos.")
    .list();
}

MultigridParameters::MultigridParameters(ParameterList const& given, int components)
{
  ParameterList list(given);
  completeAndValidate(list, *valid(), given.name());
  method = list.get<std::string>("Method") == "CG" ? Method::conjugate_gradients : Method::v_cycles;
  max_iterations = list.get<int>("Maximum Iterations");
  v_cycles = list.get<int>("V-Cycles");
  rebuilds = list.get<std::string>("Hierarchy") == "Rebuild";
  outdated_share = list.get<double>("Outdated Share");
  aggregation.muelu =
    completeMueLu(list.sublist("MueLu"), components, "Asperity / TNNMG / MueLu Correction / MueLu");
  aggregation.rows_per_rank = list.get<int>("Rows per Rank");
  if (auto const order = list.get<std::string>("Row Order"); order != "Default") {
    aggregation.row_order =
      order == "Chunks" ? multigrid::RowOrder::chunks : multigrid::RowOrder::colours;
  }
  belos = list.sublist("Belos");
}
} // namespace asperity::tnnmg::detail
