#include "io/checkpoint/MeshChecksum.hpp"

#include "base/Hashes.hpp"
#include "mesh/SplitVertices.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace asperity::io
{
namespace
{
enum Entity : int
{
  vertex,
  cell,
  facet,
  pair
};

// The sum of the checksums of all entities of the part, each of which one rank counts: where it has
// its (first) vertex. Sums do not depend on how a mesh is divided.
template <int Dim>
class PartSum
{
public:
  explicit PartSum(Mesh<Dim> const& part) : part_(part) {}

  void addVertices(ChecksumOf what)
  {
    for (int v = 0; v < part_.num_owned; ++v) {
      Checksum checksum;
      checksum.add(vertex).add(part_.global_ids[v]);
      if (what == ChecksumOf::everything) {
        checksum.add(std::vector<Point<Dim>>{part_.vertices[v]});
      }
      value_ += checksum.value();
    }
  }

  void addCells()
  {
    for (std::size_t c = 0; c < part_.cells.size(); ++c) {
      add(part_.cells[c], Checksum().add(cell).add(part_.cell_regions[c]));
    }
  }

  void addFacets()
  {
    for (auto const& [name, facets] : part_.boundaries) {
      for (auto const& each : facets) {
        add(each, Checksum().add(facet).add(name));
      }
    }
  }

  void addPairs()
  {
    for (auto const& split : part_.splits) {
      add(std::array<int, 2>{split.plus, split.minus},
          Checksum().add(pair).add(mesh::kindOf(split)));
    }
  }

  std::uint64_t value() const { return value_; }

private:
  template <std::size_t N>
  void add(std::array<int, N> const& vertices, Checksum checksum)
  {
    if (vertices.front() < part_.num_owned) {
      for (const int v : vertices) {
        checksum.add(part_.global_ids[v]);
      }
      value_ += checksum.value();
    }
  }

  Mesh<Dim> const& part_;
  std::uint64_t value_ = 0;
};
} // namespace

template <int Dim>
std::uint64_t checksum(Mesh<Dim> const& part, ChecksumOf what, Communicator const& communicator)
{
  PartSum<Dim> sum(part);
  sum.addVertices(what);
  sum.addCells();
  sum.addFacets();
  sum.addPairs();
  const auto mine = static_cast<long long>(sum.value());
  std::vector<long long> of_ranks(static_cast<std::size_t>(communicator.getSize()));
  Teuchos::gatherAll(communicator, 1, &mine, communicator.getSize(), of_ranks.data());
  std::uint64_t of_all = 0;
  for (const long long value : of_ranks) {
    of_all += static_cast<std::uint64_t>(value);
  }
  Checksum checksum;
  checksum.add(Dim).add(part.num_global_vertices).add(part.region_names).add(part.faults);
  if (what == ChecksumOf::everything) {
    checksum.add(std::vector<Point<Dim>>{part.period});
  }
  return checksum.add(of_all).value();
}

template std::uint64_t checksum(Mesh<2> const&, ChecksumOf, Communicator const&);
template std::uint64_t checksum(Mesh<3> const&, ChecksumOf, Communicator const&);
} // namespace asperity::io
