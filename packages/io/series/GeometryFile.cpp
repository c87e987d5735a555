#include "io/series/GeometryFile.hpp"

#include "base/hdf5/File.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"
#include "io/files/DurableFile.hpp"
#include "io/parallel/Gather.hpp"
#include "io/series/SegmentedTable.hpp"

#include <algorithm>
#include <variant>

namespace asperity::io::detail
{
namespace
{
// A dataset of which every rank has a part of the first dimension.
struct Piece
{
  std::string name, unit, description;
  h5::Shape shape;
  std::variant<std::vector<double>, std::vector<std::int64_t>> values; // of the part
  h5::Part part;
};

using Integers = std::vector<std::int64_t>;

Integers integers(std::vector<GlobalOrdinal> const& values)
{
  return {values.begin(), values.end()};
}

std::string positionMeaning(OutputDomain const& domain)
{
  return "Distance along the " + domain.name + " from " + startText(domain) + ".";
}

std::vector<Piece> nodePieces(OutputDomain const& domain, NodeBlocks const& blocks)
{
  char const* units[] = {"m", "m", "m^2", "m^3"};
  const auto nodes = static_cast<hsize_t>(domain.num_global_nodes);
  const auto dimension = static_cast<hsize_t>(domain.dimension);
  const h5::Part part{static_cast<hsize_t>(blocks.first()), static_cast<hsize_t>(blocks.count())};
  std::vector<Piece> pieces{{"coordinates",
                             "m",
                             "Coordinates of the nodes.",
                             {nodes, dimension},
                             blocks(domain.coordinates, 1, dimension),
                             part},
                            {"weights",
                             units[domain.nodes_per_element - 1],
                             "Lumped length, area or volume of each node.",
                             {nodes},
                             blocks(domain.weights, 1, 1),
                             part},
                            {"vertex_ids",
                             "-",
                             "Numbers of the nodes in the mesh.",
                             {nodes},
                             integers(blocks(domain.vertex_ids, 1, 1)),
                             part}};
  if (domain.isCurve()) {
    pieces.push_back(
      {"positions", "m", positionMeaning(domain), {nodes}, blocks(domain.positions, 1, 1), part});
  }
  return pieces;
}

struct Element
{
  std::vector<GlobalOrdinal> sorted, nodes;
  bool wraps;
};

// The elements whose least node is in this rank's block, sorted: one rank after the other these are
// all elements in order.
std::vector<Element> elementsOfBlock(OutputDomain const& domain, NodeBlocks const& blocks)
{
  const std::size_t corners = domain.nodes_per_element;
  std::vector<GlobalOrdinal> items; // nodes and, after them, whether it reaches across
  std::vector<int> destinations;
  for (std::size_t element = 0; element < domain.numOwnedElements(); ++element) {
    const auto nodes = domain.connectivity.begin() + element * corners;
    destinations.push_back(blocks.rankOf(*std::min_element(nodes, nodes + corners)));
    items.insert(items.end(), nodes, nodes + corners);
    items.push_back(domain.wraps[element]);
  }
  const auto arrived = sendItems(items, corners + 1, destinations, *domain.comm);
  std::vector<Element> elements;
  for (auto item = arrived.begin(); item != arrived.end(); item += corners + 1) {
    elements.push_back({{item, item + corners}, {item, item + corners}, item[corners] != 0});
    std::sort(elements.back().sorted.begin(), elements.back().sorted.end());
  }
  std::sort(elements.begin(), elements.end(),
            [](auto const& left, auto const& right) { return left.sorted < right.sorted; });
  return elements;
}

// Of the elements of a rank's block that `belongs` accepts.
template <class Belongs>
Piece elementPiece(std::string const& name, std::string const& description,
                   std::vector<Element> const& elements, OutputDomain const& domain,
                   Belongs const& belongs)
{
  Integers nodes;
  for (auto const& element : elements) {
    if (belongs(element)) {
      nodes.insert(nodes.end(), element.nodes.begin(), element.nodes.end());
    }
  }
  const auto corners = static_cast<hsize_t>(domain.nodes_per_element);
  h5::Part part{0, nodes.size() / corners};
  const auto counts =
    gatherToAll(std::vector<GlobalOrdinal>{static_cast<GlobalOrdinal>(part.count)}, *domain.comm);
  hsize_t total = 0;
  for (int rank = 0; rank < domain.comm->getSize(); ++rank) {
    part.first = rank == domain.comm->getRank() ? total : part.first;
    total += static_cast<hsize_t>(counts[rank]);
  }
  return {name, "-", description, {total, corners}, std::move(nodes), part};
}

void create(std::filesystem::path const& path, std::vector<Piece> const& pieces)
{
  makeFolderOf(path);
  h5::File file = h5::File::create(path);
  for (auto const& piece : pieces) {
    const bool is_real = piece.values.index() == 0;
    describe(file.create("geometry/" + piece.name, is_real ? h5::Type::float64 : h5::Type::int64,
                         piece.shape),
             piece.unit, piece.description);
  }
  file.close();
}

void fill(h5::File& file, Piece const& piece)
{
  auto dataset = file.openDataset("geometry/" + piece.name);
  std::visit([&](auto const& values) { dataset.writePart(values.data(), piece.part); },
             piece.values);
}
} // namespace

GeometryFile writeGeometry(std::filesystem::path const& directory, std::string const& name,
                           OutputDomain const& domain, NodeBlocks const& blocks)
{
  auto const& comm = *domain.comm;
  auto pieces = nodePieces(domain, blocks);
  const auto elements = elementsOfBlock(domain, blocks);
  pieces.push_back(elementPiece("connectivity", "Nodes of each element, as rows of coordinates.",
                                elements, domain, [](Element const&) { return true; }));
  GeometryFile result;
  result.name = "segments/" + name + "_geometry.h5";
  result.num_elements = result.num_whole = pieces.back().shape[0];
  if (domain.is_periodic) {
    pieces.push_back(
      elementPiece("whole_elements", "Those of `connectivity` that do not reach across a period.",
                   elements, domain, [](Element const& element) { return !element.wraps; }));
    result.num_whole = pieces.back().shape[0];
  }
  const auto path = directory / result.name;
  onRoot(comm, [&] { create(temporaryName(path), pieces); });
  std::optional<h5::File> file;
  onEveryRank(comm,
              [&] { file = h5::File::openShared(temporaryName(path), rawCommunicator(comm)); });
  for (auto const& piece : pieces) {
    fill(*file, piece);
  }
  file->close();
  onEveryRank(comm, [&] { synchronise(temporaryName(path)); });
  onRoot(comm, [&] { replaceDurably(path); });
  return result;
}
} // namespace asperity::io::detail
