#include "assembly/FaultSheets.hpp"

#include "base/DisjointSets.hpp"
#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <tuple>

namespace asperity::geometry
{
namespace
{
template <int Dim>
class Division
{
public:
  using Facet = typename GlobalMesh<Dim>::Facet;
  using Ridge = std::array<int, Dim - 1>; // ascending vertices

  Division(std::vector<Point<Dim>> const& vertices, std::vector<Facet> const& facets)
      : vertices_(vertices)
      , facets_(facets)
      , parts_(facets.size())
  {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      for (int i = 0; i < Dim; ++i) {
        facets_at_[opposite(facets[f], i)].push_back({f, facets[f][i]});
      }
    }
  }

  std::vector<std::vector<int>> run()
  {
    bool has_junctions = false;
    for (auto const& [ridge, there] : facets_at_) {
      has_junctions = has_junctions || there.size() > 2;
      if (there.size() == 2) {
        parts_.join(there[0].facet, there[1].facet);
      }
    }
    if (has_junctions) {
      joinAtJunctions();
    } else {
      for (std::size_t f = 1; f < facets_.size(); ++f) {
        parts_.join(f, 0);
      }
    }
    return sorted();
  }

private:
  struct AtRidge
  {
    std::size_t facet;
    int tip; // the vertex of the facet that is not of the ridge
  };
  using Pair = std::pair<std::size_t, std::size_t>; // places among the parts that meet

  static Ridge opposite(Facet const& facet, int corner)
  {
    Ridge ridge;
    std::copy_if(facet.begin(), facet.end(), ridge.begin(),
                 [&](int const& vertex) { return &vertex != &facet[corner]; });
    std::sort(ridge.begin(), ridge.end());
    return ridge;
  }

  // The unit vector in the facet that is normal to the ridge, away from it.
  Point<Dim> away(Ridge const& ridge, int tip) const
  {
    auto const& origin = vertices_[ridge[0]];
    auto result = mesh::difference<Dim>(vertices_[tip], origin);
    if constexpr (Dim == 3) {
      const auto along = mesh::difference<Dim>(vertices_[ridge[1]], origin);
      const double share = mesh::dot<Dim>(result, along) / mesh::dot<Dim>(along, along);
      for (int d = 0; d < Dim; ++d) {
        result[d] -= share * along[d];
      }
    }
    const double length = std::sqrt(mesh::dot<Dim>(result, result));
    for (double& x : result) {
      x /= length;
    }
    return result;
  }

  double lengthOf(Ridge const& ridge) const
  {
    if constexpr (Dim == 2) {
      return 1;
    } else {
      return mesh::distance<Dim>(vertices_[ridge[0]], vertices_[ridge[1]]);
    }
  }

  // The sum over all places where the same parts meet decides, not each place: facets of a rough
  // fault bend by chance.
  void joinAtJunctions()
  {
    std::map<std::vector<std::size_t>, std::map<Pair, double>> bends; // by the parts that meet
    for (auto const& [ridge, there] : facets_at_) {
      if (there.size() < 3) {
        continue;
      }
      std::vector<std::pair<std::size_t, Point<Dim>>> sectors;
      for (auto const& one : there) {
        sectors.emplace_back(parts_.find(one.facet), away(ridge, one.tip));
      }
      std::sort(sectors.begin(), sectors.end());
      std::vector<std::size_t> meeting;
      for (auto const& sector : sectors) {
        meeting.push_back(sector.first);
      }
      auto& sums = bends[meeting];
      for (std::size_t i = 0; i < sectors.size(); ++i) {
        for (std::size_t k = i + 1; k < sectors.size(); ++k) {
          sums[{i, k}] += lengthOf(ridge) * mesh::dot<Dim>(sectors[i].second, sectors[k].second);
        }
      }
    }
    for (auto const& [meeting, sums] : bends) {
      joinStraightest(meeting, sums);
    }
  }

  void joinStraightest(std::vector<std::size_t> const& meeting, std::map<Pair, double> const& sums)
  {
    std::vector<std::pair<double, Pair>> by_bend;
    for (auto const& [pair, sum] : sums) {
      by_bend.emplace_back(sum, pair);
    }
    std::sort(by_bend.begin(), by_bend.end()); // -1 goes straight on
    std::vector<bool> is_joined(meeting.size(), false);
    for (auto const& [sum, pair] : by_bend) {
      if (sum < 0 && !is_joined[pair.first] && !is_joined[pair.second]) {
        is_joined[pair.first] = is_joined[pair.second] = true;
        parts_.join(meeting[pair.first], meeting[pair.second]);
      }
    }
  }

  std::vector<std::vector<int>> sorted()
  {
    std::map<std::size_t, std::pair<double, std::vector<int>>> found; // with the area
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      auto& [area, facets] = found[parts_.find(f)];
      std::array<Point<Dim>, Dim> corners;
      std::transform(facets_[f].begin(), facets_[f].end(), corners.begin(),
                     [&](int vertex) { return vertices_[vertex]; });
      area -= mesh::facetMeasure(corners);
      facets.push_back(static_cast<int>(f));
    }
    std::vector<std::pair<double, std::vector<int>>> by_area;
    for (auto& item : found) {
      by_area.push_back(std::move(item.second));
    }
    std::sort(by_area.begin(), by_area.end());
    std::vector<std::vector<int>> sheets;
    for (auto& item : by_area) {
      sheets.push_back(std::move(item.second));
    }
    return sheets;
  }

  std::vector<Point<Dim>> const& vertices_;
  std::vector<Facet> const& facets_;
  asperity::DisjointSets parts_;
  std::map<Ridge, std::vector<AtRidge>> facets_at_;
};
} // namespace

template <int Dim>
std::vector<std::vector<int>> sheetsOf(std::vector<Point<Dim>> const& vertices,
                                       std::vector<typename GlobalMesh<Dim>::Facet> const& facets)
{
  return Division<Dim>(vertices, facets).run();
}

template <int Dim>
void divideIntoSheets(GlobalMesh<Dim>& mesh, std::string const& name, std::string const& where)
{
  const auto facets = mesh.boundaries.at(name);
  const auto sheets = sheetsOf<Dim>(mesh.vertices, facets);
  if (sheets.size() < 2) {
    return;
  }
  mesh.boundaries.erase(name);
  std::string text;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const auto of_sheet = name + '.' + std::to_string(i + 1);
    ASPERITY_REQUIRE(mesh.boundaries.count(of_sheet) == 0,
                     where << ": the faults of group '" << name << "' would be called '" << name
                           << ".1' and so on, and '" << of_sheet
                           << "' is another group. Give one of the groups another name.");
    for (int facet : sheets[i]) {
      mesh.boundaries[of_sheet].push_back(facets[static_cast<std::size_t>(facet)]);
    }
    text += (i == 0 ? " " : ", ") + of_sheet + " (" + std::to_string(sheets[i].size()) + " facets)";
  }
  std::cout << "more than two facets of '" << name << "' meet: it is divided into faults that go "
            << "straight on there," << text << '\n';
}

template std::vector<std::vector<int>> sheetsOf<2>(std::vector<Point<2>> const&,
                                                   std::vector<GlobalMesh<2>::Facet> const&);
template std::vector<std::vector<int>> sheetsOf<3>(std::vector<Point<3>> const&,
                                                   std::vector<GlobalMesh<3>::Facet> const&);
template void divideIntoSheets(GlobalMesh<2>&, std::string const&, std::string const&);
template void divideIntoSheets(GlobalMesh<3>&, std::string const&, std::string const&);
} // namespace asperity::geometry
