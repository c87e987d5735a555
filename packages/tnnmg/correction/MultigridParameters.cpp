#include "tnnmg/correction/MultigridParameters.hpp"

#include "parameters/Entries.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <string>
#include <utility>
#include <vector>

namespace asperity::tnnmg::detail
{
namespace
{
// Whether the parameter is about the cycle, and so has a meaning only for MueLu's own cycle.
bool isAboutCycle(std::string const& name)
{
  return name.rfind("smoother:", 0) == 0 || name == "coarse: type" || name == "coarse: params";
}

// Throws InputError where an entry would change what is decided elsewhere.
void check(ParameterList const& muelu, bool is_our_cycle)
{
  for (auto const& entry : muelu) {
    auto const& name = entry.first;
    const std::string path = "Asperity / TNNMG / Multigrid / MueLu / " + name;
    ASPERITY_REQUIRE(name != "repartition: enable" && name != "reuse: type" &&
                       name != "number of equations",
                     path << " cannot be chosen: Asperity sets it. Remove it.");
    ASPERITY_REQUIRE(!is_our_cycle || !isAboutCycle(name),
                     path << " cannot be chosen: of MueLu only the prolongators are used, and the "
                          << "V-cycle has smoothers and a coarse solver of its own. Remove it, or "
                          << "set 'Multigrid / Cycle' = MueLu.");
  }
}

// MueLu's complete list for the prolongators.
ParameterList forAggregation(ParameterList const& given, int components)
{
  auto list = MultigridHierarchy::defaults(components);
  for (auto const& entry : given) {
    if (!isAboutCycle(entry.first)) {
      list.setEntry(entry.first, entry.second);
    }
  }
  return list;
}

// MueLu's complete list for its cycle. The coarsest level lies on one rank, which factorises it
// with all fill: KLU2, MueLu's default, is wrong on several ranks in Trilinos 13.2, and a dense
// factor of no rows, on the others, ends the program.
ParameterList forCycle(ParameterList const& given, int components)
{
  auto list = MultigridHierarchy::defaults(components);
  list.remove("reuse: type");
  list.remove("smoother: pre or post");
  constexpr double all_fill = 1e4; // of the entries of the matrix
  list.set("coarse: type", "ILUT");
  list.sublist("coarse: params")
    .set("fact: ilut level-of-fill", all_fill)
    .set("fact: drop tolerance", 0.0);
  list.setParameters(given);
  return list;
}

// The registered smoothers, and what each of them is.
struct Smoothers
{
  std::vector<std::pair<std::string, std::string>> words;
  std::string meaning;
};
Smoothers smoothers()
{
  Smoothers result;
  auto const& registry = multigrid::SmootherRegistry::instance();
  for (auto const& name : registry.names()) {
    result.words.emplace_back(name, name);
    result.meaning += ' ' + name + ": " + registry.at(name).meaning();
  }
  return result;
}

Entries<MultigridParameters> multigridEntries()
{
  using P = MultigridParameters;
  P defaults;
  defaults.aggregation.rows_per_rank = 1000;
  const auto registered = smoothers();
  Entries<P> result(defaults);
  result
    .choice("Method", &P::method,
            {{"CG", P::Method::conjugate_gradients}, {"V-Cycles", P::Method::v_cycles}},
            "Selects how the correction is solved. CG: conjugate gradients use a V-cycle as "
            "preconditioner. V-Cycles: a few V-cycles are made, each with an optimal step length.")
    .choice("Cycle", &P::cycle,
            {{"Asperity", P::CycleKind::asperity}, {"MueLu", P::CycleKind::muelu}},
            "Selects the V-cycle. Asperity: that of Asperity, in single precision. MueLu: that of "
            "Trilinos on the same prolongators, in double precision, with the smoothers and the "
            "coarse solver of the list MueLu; a reference, which costs more.")
    .choice("Smoother", &P::smoother, registered.words,
            "Selects the smoother of the V-cycle, if that is Asperity's own." + registered.meaning)
    .integer("Maximum Iterations", &P::max_iterations, Range::atLeast(1),
             "Conjugate gradients make at most this number of iterations in one correction.")
    .integer("V-Cycles", &P::v_cycles, Range::atLeast(1),
             "With Method = V-Cycles one correction makes at most this number of cycles.")
    .choice("Hierarchy", &P::rebuilds, {{"Keep", false}, {"Rebuild", true}},
            "Selects whether the Hessians of friction are brought into the coarse levels when they "
            "change.")
    .real("Outdated Share", &P::outdated_share, "-", Range::closedOpen(0, 1),
          "The coarse levels are brought up to date when more than this share of the fault's nodes "
          "has become truncated, is no longer truncated, or has a Hessian that changed by more "
          "than a factor of three.")
    .hint("A larger share costs more iterations, a smaller one more updates.")
    .integer(
      "Rows per Rank", [](P & p) -> auto& { return p.aggregation.rows_per_rank; },
      Range::atLeast(0),
      "A coarse level with fewer rows per rank on average moves to fewer ranks, so that the "
      "coarsest level does not grow with the number of ranks. With 0 all levels stay on all "
      "ranks.")
    .choice(
      "Row Order", [](P & p) -> auto& { return p.aggregation.row_order; },
      {{"Default", multigrid::defaultRowOrder()},
       {"Chunks", multigrid::RowOrder::chunks},
       {"Colours", multigrid::RowOrder::colours}},
      "Selects the order of the rows in sweeps. Chunks: each thread of the host takes rows "
      "of nodes that lie together. Colours: rows that are not coupled are taken at the same "
      "time. Default: Colours on a device, else Chunks.");
  result.others()
    .foreignSublist("MueLu", ParameterList("MueLu"),
                    "MueLu reads these entries, in its own spelling, when it makes the "
                    "prolongators, and its cycle. Each replaces one default.")
    .foreignSublist(
      "Belos", ParameterList("Belos"),
      "Belos reads these entries, in its own spelling, for its pseudo-block conjugate gradients, "
      "which solve corrections to a relative residual below 1e-3; looser ones do not use Belos.");
  return result;
}
} // namespace

Teuchos::RCP<const ParameterList> MultigridParameters::valid() { return multigridEntries().list(); }

MultigridParameters MultigridParameters::from(ParameterList const& given, int components)
{
  ParameterList list(given);
  completeAndValidate(list, *valid(), given.name());
  auto result = multigridEntries().read(list, given.name());
  const bool is_ours = result.cycle == CycleKind::asperity;
  ASPERITY_REQUIRE(is_ours || result.smoother == MultigridParameters().smoother,
                   joinPath(given.name(), "Smoother")
                     << " = " << result.smoother
                     << " has no effect with 'Cycle' = MueLu. Remove it, and choose a smoother of "
                        "Trilinos by 'smoother: type' in the list MueLu.");
  auto const& muelu = list.sublist("MueLu");
  check(muelu, is_ours);
  result.aggregation.muelu = forAggregation(muelu, components);
  result.aggregation.keeps_prolongators = !is_ours;
  if (!is_ours) {
    result.muelu_cycle = forCycle(muelu, components);
  }
  result.belos = list.sublist("Belos");
  return result;
}
} // namespace asperity::tnnmg::detail
