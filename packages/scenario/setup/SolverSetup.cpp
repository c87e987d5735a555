#include "scenario/setup/SolverSetup.hpp"

#include "parameters/Entries.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <limits>

namespace asperity::scenario
{
namespace
{
constexpr char const* tnnmg_path = "Asperity / TNNMG";

// Number of unknowns from which on a factor with its fill costs more than a few V-cycles.
long long largestDirect(int dimension) { return dimension == 2 ? 100000 : 10000; }

// The entries of the list that are not those of tnnmg::TnnmgSettings. They join those of `list`.
Entries<SolverSettings> solverEntries(ParameterList& list)
{
  using S = SolverSettings;
  Entries<S> entries({}, list);
  entries
    .choice(
      "Linear Correction", &S::correction,
      {{"Auto", CorrectionChoice::automatic},
       {"Direct", CorrectionChoice::direct},
       {"Multigrid", CorrectionChoice::multigrid}},
      "Selects the solver of the linear correction. Direct: a sparse Cholesky factorisation "
      "of Z is made once for each step size and leaves a Schur complement on the fault; it "
      "works on one rank. Multigrid: algebraic multigrid is used. Auto: this is Direct for small "
      "problems on one rank, and Multigrid otherwise.")
    .choice("Static Condensation", &S::may_condense, {{"Auto", true}, {"Off", false}},
            "Auto: with the direct correction, a quasi-dynamic body without gravity, tractions on "
            "boundaries, viscosity or relaxation, whose boundaries move at constant velocities, is "
            "condensed to its fault once for all steps, unless that may open, which changes only "
            "rounding errors. Off: "
            "every step has all unknowns.")
    .real("Memory Budget", &S::memory, "MB", Range::positive(),
          "Each rank keeps solvers of different step sizes up to this amount of memory. The least "
          "recently used ones are removed first.")
    .others()
    .sublist("Multigrid", tnnmg::MultigridCorrection::validParameters(),
             "This list controls the linear correction by algebraic multigrid.");
  return entries;
}
} // namespace

RCP<const ParameterList> solverParameters()
{
  auto list = tnnmg::TnnmgSettings::entries().list();
  solverEntries(*list);
  return list;
}

SolverSettings SolverSettings::from(ParameterList const& list)
{
  ParameterList declared;
  auto settings = solverEntries(declared).read(list, tnnmg_path);
  settings.tnnmg = tnnmg::TnnmgSettings::entries().read(list, tnnmg_path);
  settings.multigrid = list.sublist("Multigrid");
  return settings;
}

dynamics::RateSolverSettings makeSolverSettings(SolverSettings const& settings, int num_ranks,
                                                int dimension, long long num_unknowns)
{
  auto const choice = settings.correction;
  ASPERITY_REQUIRE(choice != CorrectionChoice::direct || num_ranks == 1,
                   "Asperity / TNNMG / Linear Correction = Direct works on one rank, not on "
                     << num_ranks << ". Choose Multigrid or Auto.");
  tnnmg::MultigridCorrection::requireAccepted(settings.multigrid);
  const bool direct = choice == CorrectionChoice::direct ||
                      (choice == CorrectionChoice::automatic && num_ranks == 1 &&
                       num_unknowns <= largestDirect(dimension));
  dynamics::RateSolverSettings result;
  result.tnnmg = settings.tnnmg;
  result.correction = direct ? dynamics::Correction::direct : dynamics::Correction::multigrid;
  result.multigrid = settings.multigrid;
  return result;
}

std::string hintOnDirect(SolverSettings const& settings, int dimension, long long num_unknowns)
{
  if (settings.correction != CorrectionChoice::direct || num_unknowns <= largestDirect(dimension)) {
    return "";
  }
  return "Linear Correction = Direct factorises a matrix for each step size, which may take most "
         "of the time with " +
         std::to_string(num_unknowns) + " unknowns in " + std::to_string(dimension) +
         " dimensions: see 'set-up of step sizes' in the table at the end. Auto would choose "
         "Multigrid here; compare the two over some steps.";
}

std::size_t SolverSettings::memoryBudget() const
{
  constexpr auto most = std::numeric_limits<std::size_t>::max();
  const double bytes = memory * 1e6;
  return bytes < static_cast<double>(most) ? static_cast<std::size_t>(bytes) : most;
}
} // namespace asperity::scenario
