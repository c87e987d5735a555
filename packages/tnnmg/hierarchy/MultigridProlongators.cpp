#include "tnnmg/hierarchy/MultigridProlongators.hpp"

#include "tnnmg/hierarchy/FewerRanks.hpp"
#include "tnnmg/hierarchy/MueLuHierarchy.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

namespace asperity::tnnmg::detail
{
namespace
{
// A level to be aggregated.
struct Level
{
  RCP<const CrsMatrix> A;
  RCP<const MultiVector> near_null_space;
};

// Appends the levels down to the first one that has to move, and returns that level after the move;
// a level without matrix if nothing is left to be aggregated.
Level aggregate(Level const& level, Teuchos::ParameterList const& muelu, int rows_per_rank,
                std::vector<ProjectedLevel>& levels)
{
  const MueLuHierarchy hierarchy(level.A, level.near_null_space, muelu);
  for (int l = 1; l < hierarchy.numLevels(); ++l) {
    const auto P = hierarchy.prolongator(l);
    const auto owners = onFewerRanks(*P->getDomainMap(), rows_per_rank);
    const auto A = hierarchy.matrix(l);
    if (owners.is_null()) {
      levels.push_back({P, A});
      continue;
    }
    levels.push_back({withColumnsOn(owners, *P), movedTo(owners, A)});
    if (l + 1 < hierarchy.numLevels()) {
      return {levels.back().A, movedTo(owners, *hierarchy.nearNullSpace(l))};
    }
  }
  return {};
}
} // namespace

std::vector<ProjectedLevel> coarseLevels(RCP<const CrsMatrix> const& A,
                                         RCP<const MultiVector> const& near_null_space,
                                         Teuchos::ParameterList const& muelu, int rows_per_rank)
{
  Teuchos::ParameterList list(muelu);
  std::vector<ProjectedLevel> result;
  const int most_levels = list.get<int>("max levels");
  Level level = {A, near_null_space};
  while (!level.A.is_null()) {
    list.set("max levels", most_levels - static_cast<int>(result.size()));
    level = aggregate(level, list, rows_per_rank, result);
    list.set("number of equations", static_cast<int>(near_null_space->getNumVectors()));
  }
  return result;
}
} // namespace asperity::tnnmg::detail
