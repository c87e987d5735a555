#pragma once

#include "FaultSamples.hpp"

#include <random>

namespace asperity::mesh
{
template <int Dim>
std::vector<typename GlobalMesh<Dim>::Facet> innerFacets(GlobalMesh<Dim> const& mesh)
{
  const detail::FacetTable<Dim> table(mesh.cells);
  std::vector<typename GlobalMesh<Dim>::Facet> inner;
  for (std::size_t i = 1; i < table.entries().size(); ++i) {
    if (table.entries()[i].key == table.entries()[i - 1].key) {
      inner.push_back(table.entries()[i].key);
    }
  }
  return inner;
}

template <int Dim>
int numShared(typename GlobalMesh<Dim>::Facet const& a, typename GlobalMesh<Dim>::Facet const& b)
{
  return static_cast<int>(std::count_if(
    a.begin(), a.end(), [&](int v) { return std::count(b.begin(), b.end(), v) > 0; }));
}

// One or two faults, each grown facet by facet across ridges, in space roughly along a plane.
template <int Dim>
GlobalMesh<Dim> withRandomFaults(GlobalMesh<Dim> mesh, std::mt19937& random)
{
  const auto inner = innerFacets(mesh);
  const auto choose = [&random](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
  };
  std::set<typename GlobalMesh<Dim>::Facet> used;
  const bool has_two = choose(2) == 1;
  for (char const* name : {"first", "second"}) {
    if (!has_two && std::string(name) == "second") {
      break;
    }
    auto& fault = mesh.boundaries[name];
    const std::size_t wanted = 2 + choose(Dim == 2 ? 6 : 20);
    for (int trial = 0; trial < 200 && fault.size() < wanted; ++trial) {
      auto const& facet = inner[choose(inner.size())];
      const bool is_connected =
        fault.empty() || std::any_of(fault.begin(), fault.end(), [&](auto const& other) {
          return numShared<Dim>(facet, other) == Dim - 1;
        });
      const bool has_other = std::any_of(fault.begin(), fault.end(), [&](auto const& other) {
        const auto normal = facetNormal(corners(mesh, facet));
        return std::abs(dot<Dim>(normal, facetNormal(corners(mesh, other)))) < 0.7;
      });
      const bool makes_a_star = std::any_of(fault.begin(), fault.end(), [&](auto const& other) {
        const auto is_beside = [&](auto const& third) {
          std::vector<int> common;
          std::copy_if(facet.begin(), facet.end(), std::back_inserter(common), [&](int v) {
            return std::count(other.begin(), other.end(), v) +
                     std::count(third.begin(), third.end(), v) ==
                   2;
          });
          return third != other && common.size() >= Dim - 1;
        };
        return std::any_of(fault.begin(), fault.end(), is_beside);
      });
      if (is_connected && !makes_a_star && !(Dim == 3 && has_other) && used.count(facet) == 0) {
        fault.push_back(facet);
        used.insert(facet);
      }
    }
  }
  return mesh;
}
} // namespace asperity::mesh
