#pragma once

#include "base/parallel/Reductions.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/parallel/Partition.hpp"
#include "refinement/UniformRefinement.hpp"
#include "unit/mesh/FaultSamples.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <random>

namespace asperity::refinement::test
{
using namespace asperity::mesh;

inline Teuchos::MpiComm<int> world() { return Teuchos::MpiComm<int>(MPI_COMM_WORLD); }
inline Teuchos::MpiComm<int> self() { return Teuchos::MpiComm<int>(MPI_COMM_SELF); }

// This rank's part of a mesh that all ranks refine together.
template <int Dim>
Mesh<Dim> refined(GlobalMesh<Dim> const& mesh, int refinements)
{
  return refineUniformly(distribute(mesh, world()), refinements, world());
}

// The mesh that this rank refines alone.
template <int Dim>
GlobalMesh<Dim> wholeRefined(GlobalMesh<Dim> const& mesh, int refinements)
{
  const auto part = refineUniformly(distribute(mesh, self()), refinements, self());
  return {part.vertices,     part.period,     part.cells,  part.cell_regions,
          part.region_names, part.boundaries, part.splits, part.faults};
}

inline GlobalMesh<3> unitBox(int cells) { return boxMesh({{1, 1, 1}, {cells, cells, cells}, {}}); }

inline GlobalMesh<3> periodicBox(int cells)
{
  auto mesh = boxMesh({{2, 1, 1}, {2, 1, cells}, {}});
  makePeriodic(mesh, 2, "front", "back");
  return mesh;
}

// Its inner vertices are moved about: no two cells are alike.
inline GlobalMesh<3> crookedBox(int cells, double amplitude)
{
  auto mesh = unitBox(cells);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-amplitude / cells, amplitude / cells);
  for (auto& point : mesh.vertices) {
    const bool is_inside = *std::min_element(point.begin(), point.end()) > 0.0 &&
                           *std::max_element(point.begin(), point.end()) < 1.0;
    for (double& x : point) {
      const double by = shift(random);
      x += is_inside ? by : 0.0;
    }
  }
  return mesh;
}

// A main fault that ends inside and a splay above it.
inline Conditions<2> branchInThePlane()
{
  return {{"main", [](auto& p) { return p[1] == 0.0 && p[0] >= 1.0; }},
          {"splay", [](auto& p) { return p[0] == 2.0 && p[1] >= 0.0; }}};
}

inline Conditions<3> branchInSpace()
{
  return {{"main", [](auto& p) { return p[1] == 0.0 && p[0] >= 1.0; }},
          {"splay", [](auto& p) { return p[0] == 2.0 && p[1] >= 0.0 && p[2] >= 1.0; }}};
}

// A rectangle inside the body: edges lead from tip to tip across two of its corners.
inline Conditions<3> buried()
{
  return {{"main", [](auto& p) {
             return p[1] == 0.0 && p[0] >= 1.0 && p[0] <= 3.0 && p[2] >= 1.0 && p[2] <= 3.0;
           }}};
}

// All this rank has, by global ids: what localPart makes of the whole mesh.
template <int Dim>
void expectPartOf(GlobalMesh<Dim> const& whole, Mesh<Dim> const& part)
{
  std::vector<int> owners(whole.vertices.size(), 0);
  for (int v = 0; v < part.num_owned; ++v) {
    owners.at(static_cast<std::size_t>(part.global_ids[v])) = 1;
  }
  const auto expected = localPart(whole, owners, 1);
  EXPECT_EQ(part.global_ids, expected.global_ids);
  EXPECT_EQ(part.num_owned, expected.num_owned);
  EXPECT_EQ(part.num_global_vertices, expected.num_global_vertices);
  EXPECT_EQ(part.vertices, expected.vertices);
  EXPECT_EQ(part.period, expected.period);
  EXPECT_EQ(part.region_names, expected.region_names);
  EXPECT_EQ(part.faults, expected.faults);
  EXPECT_EQ(part.splits, expected.splits);
  const auto with_regions = [](Mesh<Dim> const& mesh) {
    std::multiset<std::pair<typename Mesh<Dim>::Cell, int>> cells;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      cells.insert({mesh.cells[c], mesh.cell_regions[c]});
    }
    return cells;
  };
  EXPECT_TRUE(with_regions(part) == with_regions(expected));
  ASSERT_EQ(part.boundaries.size(), expected.boundaries.size());
  for (auto const& [name, facets] : expected.boundaries) {
    using Facets = std::multiset<typename Mesh<Dim>::Facet>;
    auto const& ours = part.boundaries.at(name);
    EXPECT_TRUE(Facets(ours.begin(), ours.end()) == Facets(facets.begin(), facets.end())) << name;
  }
  EXPECT_EQ(sumOverRanks(static_cast<double>(part.num_owned), world()),
            static_cast<double>(whole.vertices.size()));
}
} // namespace asperity::refinement::test
