#include "mesh/parallel/Partition.hpp"

#include "base/Errors.hpp"
#include "mesh/SplitVertices.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace asperity::mesh
{
namespace
{
// The vertices, cells and facets of a part, by their numbers in the whole mesh, ascending.
struct Selection
{
  std::vector<int> owned;
  std::vector<int> cells;
  std::map<std::string, std::vector<int>> facets; // per boundary
};

// Calls visit(part) once for every part that owns a vertex of the cell or facet.
template <std::size_t N, class Visit>
void forOwners(std::array<int, N> const& simplex, std::vector<int> const& owners, Visit visit)
{
  std::array<int, N> parts;
  for (std::size_t i = 0; i < N; ++i) {
    parts[i] = owners[static_cast<std::size_t>(simplex[i])];
    if (std::find(parts.begin(), parts.begin() + i, parts[i]) == parts.begin() + i) {
      visit(parts[i]);
    }
  }
}

// Adds to selection(part) the numbers of that part, unless it is nullptr.
template <int Dim, class SelectionOf>
void select(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, SelectionOf selection)
{
  for (std::size_t v = 0; v < owners.size(); ++v) {
    if (Selection* part = selection(owners[v])) {
      part->owned.push_back(static_cast<int>(v));
    }
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    forOwners(mesh.cells[c], owners, [&](int owner) {
      if (Selection* part = selection(owner)) {
        part->cells.push_back(static_cast<int>(c));
      }
    });
  }
  for (auto const& [name, facets] : mesh.boundaries) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      forOwners(facets[f], owners, [&, &boundary = name](int owner) {
        if (Selection* part = selection(owner)) {
          part->facets[boundary].push_back(static_cast<int>(f));
        }
      });
    }
  }
}

// Makes the meshes of the parts.
template <int Dim>
class Cutter
{
public:
  explicit Cutter(GlobalMesh<Dim> const& mesh)
      : mesh_(mesh)
      , local_(mesh.vertices.size(), -1)
      , pairs_(mesh.splits)
  {
    for (auto const& [plus, minus, is_tip, is_joint] : mesh.splits) {
      const int place = pairs_.placeOf(plus);
      place_of_.insert({{plus, place}, {place, place}});
      at_place_.insert({{place, place}, {place, plus}});
    }
  }

  Mesh<Dim> part(Selection const& selection)
  {
    Mesh<Dim> part;
    part.num_global_vertices = static_cast<GlobalOrdinal>(mesh_.vertices.size());
    part.period = mesh_.period;
    part.region_names = mesh_.region_names;
    addVertices(selection, part);
    for (int c : selection.cells) {
      part.cells.push_back(renumbered(mesh_.cells[c]));
      part.cell_regions.push_back(mesh_.cell_regions[c]);
    }
    for (auto const& [name, facets] : mesh_.boundaries) {
      auto& local_facets = part.boundaries[name];
      const auto selected = selection.facets.find(name);
      if (selected != selection.facets.end()) {
        for (int f : selected->second) {
          local_facets.push_back(renumbered(facets[f]));
        }
      }
    }
    addPairs(part);
    for (GlobalOrdinal vertex : part.global_ids) {
      local_[static_cast<std::size_t>(vertex)] = -1;
    }
    return part;
  }

private:
  // The owned vertices, then the ghosts, each in the order of their global ids.
  void addVertices(Selection const& selection, Mesh<Dim>& part)
  {
    number(selection.owned, part);
    part.num_owned = static_cast<int>(selection.owned.size());
    std::vector<int> ghosts;
    for (int c : selection.cells) {
      for (int vertex : mesh_.cells[c]) {
        if (local_[vertex] < 0) {
          ghosts.push_back(vertex);
        }
      }
    }
    addCopies(selection.owned, ghosts);
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    number(ghosts, part);
  }

  // Adds all vertices at a place of a fault of which the part has one.
  void addCopies(std::vector<int> const& owned, std::vector<int>& ghosts) const
  {
    std::unordered_set<int> places;
    const auto note_place = [&](int vertex) {
      const auto known = place_of_.find(vertex);
      if (known != place_of_.end()) {
        places.insert(known->second);
      }
    };
    std::for_each(owned.begin(), owned.end(), note_place);
    std::for_each(ghosts.begin(), ghosts.end(), note_place);
    for (int place : places) {
      const auto [first, last] = at_place_.equal_range(place);
      for (auto entry = first; entry != last; ++entry) {
        if (local_[entry->second] < 0) {
          ghosts.push_back(entry->second);
        }
      }
    }
  }

  void addPairs(Mesh<Dim>& part) const
  {
    part.faults = mesh_.faults;
    for (std::size_t v = 0; v < part.global_ids.size(); ++v) {
      if (auto const* pair = pairs_.find(static_cast<int>(part.global_ids[v]))) {
        part.splits.push_back(
          {static_cast<int>(v), local_[pair->minus], pair->is_tip, pair->is_joint});
      }
    }
  }

  void number(std::vector<int> const& vertices, Mesh<Dim>& part)
  {
    for (int vertex : vertices) {
      local_[vertex] = static_cast<int>(part.vertices.size());
      part.vertices.push_back(mesh_.vertices[vertex]);
      part.global_ids.push_back(vertex);
    }
  }

  template <std::size_t N>
  std::array<int, N> renumbered(std::array<int, N> simplex) const
  {
    for (int& vertex : simplex) {
      vertex = local_[static_cast<std::size_t>(vertex)];
    }
    return simplex;
  }

  GlobalMesh<Dim> const& mesh_;
  std::vector<int> local_; // vertex number in the current part, -1 for other vertices
  FaultPairs pairs_;
  std::unordered_map<int, int> place_of_;      // of a vertex at a fault, as FaultPairs::placeOf
  std::unordered_multimap<int, int> at_place_; // all vertices at a place
};
} // namespace

template <int Dim>
Mesh<Dim> localPart(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, int rank)
{
  ASPERITY_ASSERT(owners.size() == mesh.vertices.size());
  Selection selection;
  select(mesh, owners, [&](int part) { return part == rank ? &selection : nullptr; });
  return Cutter<Dim>(mesh).part(selection);
}

template <int Dim>
std::vector<NumberedPart<Dim>> localParts(GlobalMesh<Dim> const& mesh,
                                          std::vector<int> const& owners, int num_parts)
{
  ASPERITY_ASSERT(owners.size() == mesh.vertices.size());
  std::vector<Selection> selections(static_cast<std::size_t>(num_parts));
  select(mesh, owners, [&](int part) { return &selections.at(static_cast<std::size_t>(part)); });
  Cutter<Dim> cutter(mesh);
  std::vector<NumberedPart<Dim>> parts;
  for (auto& selection : selections) {
    for (auto const& boundary : mesh.boundaries) {
      selection.facets[boundary.first]; // every part has every name
    }
    auto part = cutter.part(selection);
    parts.push_back({std::move(part), std::move(selection.cells), std::move(selection.facets)});
  }
  return parts;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template Mesh<Dim> localPart(GlobalMesh<Dim> const&, std::vector<int> const&, int);              \
  template std::vector<NumberedPart<Dim>> localParts(GlobalMesh<Dim> const&,                       \
                                                     std::vector<int> const&, int);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
