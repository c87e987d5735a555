#include "FaultSamples.hpp"

#include <random>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
template <int Dim>
using Facet = typename GlobalMesh<Dim>::Facet;

template <int Dim>
std::vector<Facet<Dim>> innerFacets(GlobalMesh<Dim> const& mesh)
{
  const detail::FacetTable<Dim> table(mesh.cells);
  std::vector<Facet<Dim>> inner;
  for (std::size_t i = 1; i < table.entries().size(); ++i) {
    if (table.entries()[i].key == table.entries()[i - 1].key) {
      inner.push_back(table.entries()[i].key);
    }
  }
  return inner;
}

template <int Dim>
int numShared(Facet<Dim> const& a, Facet<Dim> const& b)
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
  std::set<Facet<Dim>> used;
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

// How many of the meshes can be split; the others are refused with one message.
template <int Dim>
int numSplit(GlobalMesh<Dim> const& mesh, int num_trials)
{
  std::mt19937 random(1);
  int num_split = 0;
  for (int trial = 0; trial < num_trials; ++trial) {
    const auto faulted = withRandomFaults(mesh, random);
    auto result = faulted;
    try {
      splitFaults(result, "Here");
    } catch (InputError const& error) {
      EXPECT_EQ(std::string(error.what()).rfind("Here: ", 0), 0u);
      continue;
    }
    SCOPED_TRACE(trial);
    expectGoodSplit(faulted, result);
    ++num_split;
  }
  return num_split;
}
} // namespace

// Whatever is not refused is a good split.
TEST(RandomFaults, InThePlane)
{
  const auto mesh = rectangleMesh({4.0, 4.0, 4, 4, {0.0, 0.0}});
  EXPECT_GT(numSplit(mesh, 2000), 500);
}

TEST(RandomFaults, InSpace)
{
  const auto mesh = boxMesh({{3.0, 3.0, 3.0}, {3, 3, 3}, {0.0, 0.0, 0.0}});
  EXPECT_GT(numSplit(mesh, 2000), 250);
}
