#include "scenario/checks/FlatCellCheck.hpp"

#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
// Whether a boundary has a tip, on any rank.
template <int Dim>
bool hasTip(Problem<Dim> const& problem, std::string const& boundary)
{
  auto const vertices = mesh::boundaryVertices(problem.mesh(), boundary);
  auto const& pairs = problem.mesh().splits;
  const bool here = std::any_of(pairs.begin(), pairs.end(), [&](SplitVertex const& pair) {
    return pair.is_tip && std::binary_search(vertices.begin(), vertices.end(), pair.plus);
  });
  return maxOverRanks(here ? 1 : 0, *problem.communicator) == 1;
}
} // namespace

// Where slip is prescribed, the stiffness of the fault has no effect.
template <int Dim>
std::vector<Warning> warnOfFlatCells(Problem<Dim> const& problem)
{
  std::vector<Warning> warnings;
  auto const names = problem.settings.mesh.flat_cells.value_or(std::vector<std::string>());
  for (auto const& condition : problem.settings.conditions) {
    auto const& name = condition.boundary;
    if (condition.type->isContinuation() &&
        std::find(names.begin(), names.end(), name) != names.end() && hasTip(problem, name)) {
      warnings.push_back(
        {"flat cells",
         std::string("Mesh / ") + mesh_entries::flat_cells + " names '" + name +
           "', along which slip is prescribed and ends inside the body. Flat cells give "
           "friction the right stiffness, but do not improve the response of the body to "
           "prescribed slip: within two cells of its ends displacements err by 10 to 30 %, and "
           "move with the vertices. Leave '" +
           name + "' out, and take smaller cells there."});
    }
  }
  return warnings;
}

template std::vector<Warning> warnOfFlatCells(Problem<2> const&);
template std::vector<Warning> warnOfFlatCells(Problem<3> const&);
} // namespace asperity::scenario
