#include "assembly/SharedFacets.hpp"

#include "Warnings.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace asperity::geometry
{
namespace
{
template <std::size_t N>
std::array<int, N> sorted(std::array<int, N> facet)
{
  std::sort(facet.begin(), facet.end());
  return facet;
}

template <int Dim>
using Facet = typename GlobalMesh<Dim>::Facet;
} // namespace

template <int Dim>
std::set<std::string> faultsOf(GlobalMesh<Dim> const& mesh)
{
  std::vector<Facet<Dim>> sides; // of all cells, sorted
  sides.reserve(mesh.cells.size() * (Dim + 1));
  for (auto const& cell : mesh.cells) {
    for (int opposite = 0; opposite <= Dim; ++opposite) {
      Facet<Dim> side;
      std::copy_if(cell.begin(), cell.end(), side.begin(),
                   [&](int const& vertex) { return &vertex != &cell[opposite]; });
      sides.push_back(sorted(side));
    }
  }
  std::sort(sides.begin(), sides.end());
  std::set<std::string> faults;
  for (auto const& [name, facets] : mesh.boundaries) {
    if (std::any_of(facets.begin(), facets.end(), [&](auto const& facet) {
          const auto range = std::equal_range(sides.begin(), sides.end(), sorted(facet));
          return range.second - range.first == 2;
        })) {
      faults.insert(name);
    }
  }
  return faults;
}

template <int Dim>
void separateFaults(GlobalMesh<Dim>& mesh, std::set<std::string> const& faults,
                    std::string const& where)
{
  std::vector<std::string> ascending(faults.begin(), faults.end()); // by number of facets
  std::stable_sort(ascending.begin(), ascending.end(),
                   [&](std::string const& a, std::string const& b) {
                     return mesh.boundaries.at(a).size() < mesh.boundaries.at(b).size();
                   });
  std::map<Facet<Dim>, std::string> owner;
  for (auto const& name : ascending) {
    auto& facets = mesh.boundaries.at(name);
    std::map<std::string, int> lost; // number of facets that another fault keeps
    std::vector<Facet<Dim>> kept;
    for (auto const& facet : facets) {
      const auto [entry, is_new] = owner.emplace(sorted(facet), name);
      if (is_new) {
        kept.push_back(facet);
      } else {
        ++lost[entry->second];
      }
    }
    for (auto const& [other, number] : lost) {
      ASPERITY_REQUIRE(!kept.empty(), where << ": all facets of fault '" << name
                                            << "' are in fault '" << other
                                            << "', too, or in others. A facet has one fault: "
                                            << "leave one of them out with 'asperity-mesh convert "
                                            << "--without " << name << "'.");
      warn(where + ": " + std::to_string(number) + " facets are in fault '" + name +
           "' and in fault '" + other + "'. They stay in '" + other + "', which has fewer; '" +
           name + "' is what is left. --without " + other + " leaves them to '" + name + "'.");
    }
    facets = std::move(kept);
  }
}

template std::set<std::string> faultsOf(GlobalMesh<2> const&);
template std::set<std::string> faultsOf(GlobalMesh<3> const&);
template void separateFaults(GlobalMesh<2>&, std::set<std::string> const&, std::string const&);
template void separateFaults(GlobalMesh<3>&, std::set<std::string> const&, std::string const&);
} // namespace asperity::geometry
