#include "mesh/faults/detail/FaultFacets.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/faults/Facing.hpp"
#include "mesh/faults/detail/Continuations.hpp"

namespace asperity::mesh::detail
{
namespace
{
template <int Dim>
std::vector<FaultFacet<Dim>> collect(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                                     std::vector<std::string> const& names,
                                     std::string const& where)
{
  std::vector<FaultFacet<Dim>> all;
  for (std::size_t n = 0; n < names.size(); ++n) {
    auto const& facets = mesh.boundaries.at(names[n]);
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const auto [first, last] = table.find(facets[f]);
      ASPERITY_ASSERT(last - first == 2);
      all.push_back(
        {first->key, static_cast<int>(n), f, {first->cell, (first + 1)->cell}, first->outward});
    }
  }
  std::sort(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.key < b.key; });
  for (std::size_t f = 1; f < all.size(); ++f) {
    if (all[f].key == all[f - 1].key) {
      auto const& first = names[all[f - 1].fault];
      auto const& second = names[all[f].fault];
      auto const size = [&](std::string const& name) { return mesh.boundaries.at(name).size(); };
      throw InputError(where + ": the facet at " + text(centroid(corners(mesh, all[f].key))) +
                       " is in fault '" + first + "' and in fault '" + second +
                       "'. Remove it from one of them; 'asperity-mesh convert --without " +
                       (size(first) < size(second) ? first : second) +
                       "' leaves out the smaller one.");
    }
  }
  return all;
}

// Gives all facets of a connected set the same orientation, with normals that point out of the body
// on the plus side: downwards or, of a ring, inwards.
template <int Dim>
class Orientation
{
public:
  Orientation(GlobalMesh<Dim> const& mesh, std::vector<std::string> const& names,
              std::string const& where, std::vector<FaultFacet<Dim>>& facets)
      : mesh_(mesh)
      , names_(names)
      , where_(where)
      , facets_(facets)
      , neighbours_(facets.size())
  {
  }

  // Returns the facets of two faults that are one fault at their common ridge.
  std::vector<std::array<int, 2>> run()
  {
    connect();
    std::vector<bool> is_done(facets_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (!is_done[f]) {
        choosePlus(orientConnected(static_cast<int>(f), is_done));
      }
    }
    return std::move(joined_);
  }

private:
  struct AtRidge
  {
    int facet;
    int sign; // of the ridge in the boundary of the facet, 1 or -1
  };
  struct Neighbour
  {
    int facet;
    bool looks_alike; // both have the same orientation before any is turned
  };

  // The boundary of the simplex (v_0, v_1, ...) is the sum of (-1)^i times the simplex without v_i.
  static std::pair<Ridge<Dim>, int> ridge(typename GlobalMesh<Dim>::Facet const& facet, int without)
  {
    Ridge<Dim> rest{};
    int next = 0;
    for (int i = 0; i < Dim; ++i) {
      if (i != without) {
        rest[next++] = facet[i];
      }
    }
    int sign = without % 2 == 0 ? 1 : -1;
    const auto in_order = sorted(rest);
    return {in_order, in_order == rest ? sign : -sign};
  }

  void connect()
  {
    std::map<Ridge<Dim>, std::vector<AtRidge>> ridges;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      for (int i = 0; i < Dim; ++i) {
        const auto [vertices, sign] = ridge(facets_[f].outward, i);
        ridges[vertices].push_back({static_cast<int>(f), sign});
      }
    }
    std::map<Ridge<Dim>, std::vector<int>> joints;
    for (auto const& [vertices, there] : ridges) {
      if (there.size() == 2) {
        join(there[0], there[1]);
      } else if (there.size() > 2) {
        joinFacetsOfOneFault(vertices, there);
        for (auto const& one : there) {
          joints[vertices].push_back(one.facet);
        }
      }
    }
    for (auto const& [vertices, pair] : continuations(mesh_, facets_, joints)) {
      const auto at = [&there = ridges.at(vertices)](int facet) {
        return *std::find_if(there.begin(), there.end(),
                             [&](AtRidge const& one) { return one.facet == facet; });
      };
      join(at(pair[0]), at(pair[1]));
    }
  }

  void join(AtRidge const& a, AtRidge const& b)
  {
    const bool looks_alike = a.sign != b.sign;
    neighbours_[a.facet].push_back({b.facet, looks_alike});
    neighbours_[b.facet].push_back({a.facet, looks_alike});
    if (facets_[a.facet].fault != facets_[b.facet].fault) {
      joined_.push_back({a.facet, b.facet});
    }
  }

  // At a junction of several faults only facets of the same fault are connected.
  void joinFacetsOfOneFault(Ridge<Dim> const& vertices, std::vector<AtRidge> const& there)
  {
    std::map<int, std::vector<AtRidge>> of_fault;
    for (auto const& one : there) {
      of_fault[facets_[one.facet].fault].push_back(one);
    }
    for (auto const& [fault, its] : of_fault) {
      ASPERITY_REQUIRE(its.size() <= 2,
                       where_ << ": " << its.size() << " facets of fault '" << names_[fault]
                              << "' meet at " << text(centroid(corners(mesh_, vertices)))
                              << ". At most two may: give a branch a name of its own.");
      if (its.size() == 2) {
        join(its[0], its[1]);
      }
    }
  }

  void turn(FaultFacet<Dim>& facet) const
  {
    std::swap(facet.cells[0], facet.cells[1]);
    std::swap(facet.outward[0], facet.outward[1]);
  }

  // Gives all facets that are connected with this one the same orientation, and returns them with
  // this one.
  std::vector<int> orientConnected(int first, std::vector<bool>& is_done)
  {
    std::vector<int> connected = {first};
    std::map<int, bool> is_turned = {{first, false}};
    is_done[first] = true;
    for (std::size_t next = 0; next < connected.size(); ++next) {
      const int facet = connected[next];
      for (auto const& neighbour : neighbours_[facet]) {
        const bool turned = is_turned.at(facet) == neighbour.looks_alike;
        const auto known = is_turned.emplace(neighbour.facet, turned);
        if (known.second) {
          is_done[neighbour.facet] = true;
          connected.push_back(neighbour.facet);
        }
        ASPERITY_REQUIRE(known.first->second == turned,
                         where_ << ": fault '" << names_[facets_[facet].fault]
                                << "' cannot be oriented: along a closed path on it through "
                                << text(centroid(corners(mesh_, facets_[facet].key)))
                                << " its two sides are exchanged.");
      }
    }
    for (auto const& [facet, turned] : is_turned) {
      if (turned) {
        turn(facets_[facet]);
      }
    }
    return connected;
  }

  // Plus is the upper side or, of a ring, the outside.
  void choosePlus(std::vector<int> const& connected)
  {
    std::vector<std::array<Point<Dim>, Dim>> from_plus; // seen from the plus side
    for (int facet : connected) {
      from_plus.push_back(corners(mesh_, facets_[facet].outward));
    }
    if (isTurned(connected, facingOf<Dim>(from_plus))) {
      for (int facet : connected) {
        turn(facets_[facet]);
      }
    }
  }

  // Whether plus has to become minus.
  bool isTurned(std::vector<int> const& connected, Facing const& from_plus) const
  {
    if (from_plus.isRing()) {
      return from_plus.outwards > 0.0;
    }
    ASPERITY_REQUIRE(from_plus.hasMeanNormal(),
                     where_ << ": fault '" << names_[facets_[connected.front()].fault]
                            << "' cannot be oriented: neither of its sides is the upper one or the "
                               "outer one. Give its parts different names, and separate them.");
    auto const& down = from_plus.normal; // from plus to minus
    const double length = std::sqrt(dot<3>(down, down));
    const int last = Dim - 1; // z in space, x in the plane
    const int axis = std::abs(down[1]) >= 1e-6 * length   ? 1
                     : std::abs(down[0]) >= 1e-6 * length ? 0
                                                          : last;
    return down[axis] > 0.0;
  }

  GlobalMesh<Dim> const& mesh_;
  std::vector<std::string> const& names_;
  std::string const& where_;
  std::vector<FaultFacet<Dim>>& facets_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<std::array<int, 2>> joined_;
};
} // namespace

template <int Dim>
OrientedFacets<Dim> orientedFaultFacets(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                                        std::vector<std::string> const& names,
                                        std::string const& where)
{
  OrientedFacets<Dim> result;
  result.facets = collect(mesh, table, names, where);
  result.joined = Orientation<Dim>(mesh, names, where, result.facets).run();
  return result;
}

template OrientedFacets<2> orientedFaultFacets(GlobalMesh<2> const&, FacetTable<2> const&,
                                               std::vector<std::string> const&, std::string const&);
template OrientedFacets<3> orientedFaultFacets(GlobalMesh<3> const&, FacetTable<3> const&,
                                               std::vector<std::string> const&, std::string const&);
} // namespace asperity::mesh::detail
