#include "mesh/parallel/MeshChecksum.hpp"

#include "base/Hashes.hpp"
#include "mesh/faults/SplitVertices.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace asperity::mesh
{
namespace
{
template <int Dim>
std::uint64_t checksumOfPart(Mesh<Dim> const& part, ChecksumOf what)
{
  Checksum checksum;
  checksum.add(Dim).add(part.global_ids).add(part.num_owned).add(part.cells);
  checksum.add(part.cell_regions).add(part.region_names);
  for (auto const& [name, facets] : part.boundaries) {
    checksum.add(name).add(facets);
  }
  if (!part.faults.empty()) {
    checksum.add(part.faults).add(asRows(part.splits));
  }
  if (what == ChecksumOf::everything) {
    checksum.add(part.vertices).add(std::vector<Point<Dim>>{part.period});
  }
  return checksum.value();
}
} // namespace

template <int Dim>
std::uint64_t checksum(Mesh<Dim> const& part, ChecksumOf what, Communicator const& communicator)
{
  const auto mine = static_cast<long long>(checksumOfPart(part, what));
  std::vector<long long> of_ranks(static_cast<std::size_t>(communicator.getSize()));
  Teuchos::gatherAll(communicator, 1, &mine, communicator.getSize(), of_ranks.data());
  return Checksum().add(of_ranks).value();
}

template std::uint64_t checksum(Mesh<2> const&, ChecksumOf, Communicator const&);
template std::uint64_t checksum(Mesh<3> const&, ChecksumOf, Communicator const&);
} // namespace asperity::mesh
