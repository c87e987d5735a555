#include "mesh/file/detail/Assembly.hpp"

#include "base/Errors.hpp"

#include <algorithm>

namespace asperity::mesh::detail
{
namespace
{
template <std::size_t N>
std::array<int, N> noSimplex()
{
  std::array<int, N> vertices;
  vertices.fill(-1);
  return vertices;
}

template <std::size_t N>
std::array<int, N> globalSimplex(std::array<int, N> simplex, std::vector<GlobalOrdinal> const& ids)
{
  for (int& vertex : simplex) {
    vertex = static_cast<int>(ids[static_cast<std::size_t>(vertex)]);
  }
  return simplex;
}

void requireNumbers(std::vector<int> const& numbers, std::size_t wanted, std::size_t limit,
                    std::string const& where)
{
  ASPERITY_REQUIRE(numbers.size() == wanted, where << ": there are " << wanted
                                                   << ", but numbers for " << numbers.size()
                                                   << ". Partition the mesh again.");
  for (int number : numbers) {
    ASPERITY_REQUIRE(number >= 0 && static_cast<std::size_t>(number) < limit,
                     where << ": the number " << number << " is outside [0, " << limit << ").");
  }
}

template <class Simplices>
bool isComplete(Simplices const& simplices)
{
  return std::all_of(simplices.begin(), simplices.end(),
                     [](auto const& simplex) { return simplex[0] >= 0; });
}
} // namespace

template <int Dim>
Assembly<Dim>::Assembly(PartitionSummary const& summary)
    : has_vertex_(static_cast<std::size_t>(summary.num_vertices), false)
{
  mesh_.vertices.resize(has_vertex_.size());
  std::copy_n(summary.period.begin(), Dim, mesh_.period.begin());
  mesh_.cells.assign(static_cast<std::size_t>(summary.num_cells), noSimplex<Dim + 1>());
  mesh_.cell_regions.resize(mesh_.cells.size());
  mesh_.region_names = summary.region_names;
  mesh_.faults = summary.faults;
}

template <int Dim>
void Assembly<Dim>::add(NumberedPart<Dim> const& part, std::string const& where)
{
  auto const& ids = part.mesh.global_ids;
  for (int v = 0; v < part.mesh.num_owned; ++v) {
    mesh_.vertices[ids[v]] = part.mesh.vertices[v];
    has_vertex_[ids[v]] = true;
  }
  addCells(part, where);
  for (auto const& boundary : part.mesh.boundaries) {
    addFacets(boundary.first, part, where);
  }
  addPairs(part.mesh);
}

// A pair is in every part that has its vertices.
template <int Dim>
void Assembly<Dim>::addPairs(Mesh<Dim> const& part)
{
  for (auto const& [plus, minus, is_tip, is_joint] : part.splits) {
    const auto number = static_cast<int>(part.global_ids[static_cast<std::size_t>(plus)]);
    pairs_[number] = {number, static_cast<int>(part.global_ids[static_cast<std::size_t>(minus)]),
                      is_tip, is_joint};
  }
}

template <int Dim>
void Assembly<Dim>::addCells(NumberedPart<Dim> const& part, std::string const& where)
{
  requireNumbers(part.cells, part.mesh.cells.size(), mesh_.cells.size(), where + ", cells");
  for (std::size_t c = 0; c < part.cells.size(); ++c) {
    const auto cell = static_cast<std::size_t>(part.cells[c]);
    mesh_.cells[cell] = globalSimplex(part.mesh.cells[c], part.mesh.global_ids);
    mesh_.cell_regions[cell] = part.mesh.cell_regions[c];
  }
}

template <int Dim>
void Assembly<Dim>::addFacets(std::string const& boundary, NumberedPart<Dim> const& part,
                              std::string const& where)
{
  auto const& local_facets = part.mesh.boundaries.at(boundary);
  auto const& numbers = part.facets.at(boundary);
  // The file does not contain the number of facets; a cell has at most Dim + 1.
  requireNumbers(numbers, local_facets.size(), (Dim + 1) * mesh_.cells.size(),
                 where + ", facets of boundary '" + boundary + "'");
  auto& facets = mesh_.boundaries[boundary];
  for (std::size_t f = 0; f < numbers.size(); ++f) {
    const auto facet = static_cast<std::size_t>(numbers[f]);
    if (facet >= facets.size()) {
      facets.resize(facet + 1, noSimplex<Dim>());
    }
    facets[facet] = globalSimplex(local_facets[f], part.mesh.global_ids);
  }
}

template <int Dim>
GlobalMesh<Dim> Assembly<Dim>::finish(std::string const& where)
{
  bool is_complete = isComplete(mesh_.cells) &&
                     std::find(has_vertex_.begin(), has_vertex_.end(), false) == has_vertex_.end();
  for (auto const& boundary : mesh_.boundaries) {
    is_complete = is_complete && isComplete(boundary.second);
  }
  ASPERITY_REQUIRE(is_complete, where << ": its parts are not a whole mesh; some vertex, cell or "
                                      << "facet is in none of them. Partition the mesh again.");
  for (auto const& pair : pairs_) {
    mesh_.splits.push_back(pair.second);
  }
  return std::move(mesh_);
}

template class Assembly<2>;
template class Assembly<3>;
} // namespace asperity::mesh::detail
