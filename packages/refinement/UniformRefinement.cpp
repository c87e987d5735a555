#include "refinement/UniformRefinement.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Directory.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "refinement/MemoryCheck.hpp"
#include "refinement/detail/Points.hpp"
#include "refinement/detail/RedRule.hpp"
#include "refinement/detail/RefinementStep.hpp"

#include <algorithm>

namespace asperity::refinement
{
namespace
{
void order(Mesh<2>&) {}

// Orders the corners of each cell by the ids that the vertices had before the mesh was split.
void order(Mesh<3>& part)
{
  const auto ids = detail::idsOfPlaces(part);
  for (auto& cell : part.cells) {
    auto sorted = cell;
    std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return ids[a] < ids[b]; });
    cell = detail::firstOrder(sorted, mesh::corners(part, sorted));
  }
}

template <int Dim>
void orient(Mesh<Dim>& part)
{
  for (auto& cell : part.cells) {
    if (mesh::signedMeasure(mesh::corners(part, cell)) < 0.0) {
      std::swap(cell[Dim - 1], cell[Dim]);
    }
  }
}

// The rank that owns each vertex of a part, (num_local).
template <int Dim>
std::vector<int> ownersOf(Mesh<Dim> const& part, Communicator const& communicator)
{
  const std::vector<GlobalOrdinal> owned(part.global_ids.begin(),
                                         part.global_ids.begin() + part.num_owned);
  const std::vector<GlobalOrdinal> me(owned.size(), communicator.getRank());
  const Directory directory(part.num_global_vertices, communicator);
  const auto owners = directory.valuesAt(part.global_ids, owned, me);
  ASPERITY_ASSERT(std::find(owners.begin(), owners.end(), -1) == owners.end());
  return {owners.begin(), owners.end()};
}
} // namespace

template <int Dim>
Mesh<Dim> refineUniformly(Mesh<Dim> part, int refinements, Communicator const& communicator,
                          std::string const& where)
{
  ASPERITY_REQUIRE(refinements >= 0, where << " = " << refinements << " is outside [0, inf).");
  if (refinements == 0) {
    return part;
  }
  requireMemory(part, refinements, communicator, where);
  auto owners = ownersOf(part, communicator);
  detail::OwnedPart<Dim> refined{std::move(part), std::move(owners)};
  order(refined.mesh);
  for (int i = 0; i < refinements; ++i) {
    refined = detail::refineOnce(refined, communicator, where);
  }
  orient(refined.mesh);
  return std::move(refined.mesh);
}

template Mesh<2> refineUniformly(Mesh<2>, int, Communicator const&, std::string const&);
template Mesh<3> refineUniformly(Mesh<3>, int, Communicator const&, std::string const&);
} // namespace asperity::refinement
