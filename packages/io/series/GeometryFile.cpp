#include "io/series/GeometryFile.hpp"

#include "base/parallel/Agreement.hpp"
#include "hdf5/File.hpp"
#include "io/files/DurableFile.hpp"
#include "io/parallel/BlocksInOrder.hpp"
#include "io/parallel/ElementBlocks.hpp"
#include "io/series/SeriesLayout.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace asperity::io::detail
{
namespace
{
using Integers = std::vector<long long>;

// A dataset of which every rank has a part of the first dimension, one rank after the other.
struct Piece
{
  std::string name, unit, description;
  h5::Shape shape;
  std::variant<std::vector<double>, Integers> values; // of the part
};

template <class Number>
Integers integers(std::vector<Number> const& values)
{
  return {values.begin(), values.end()};
}

std::string positionMeaning(OutputDomain const& domain)
{
  return "Distance along the " + domain.name + " from " + startText(domain) + ".";
}

// On rank 0.
void writeParts(h5::File& file, OutputDomain const& domain)
{
  std::vector<std::string> names;
  std::vector<double> ends;
  for (auto const& part : domain.parts) {
    names.push_back(part.name);
    ends.insert(ends.end(), {part.begin, part.end});
  }
  if (!domain.boundaries.empty() && !domain.isCurve()) {
    describe(file.createTexts("geometry/boundary_names", domain.boundaries), "-",
             "Boundaries of the mesh that the domain is made of.");
  }
  if (!names.empty()) {
    describe(file.createTexts("geometry/part_names", names), "-",
             "Boundaries of the mesh that the curve is made of.");
    writeDataset(file, "geometry/part_ends", ends, {names.size(), 2}, "m",
                 "Positions of the two ends of each part.");
  }
}

std::vector<Piece> nodePieces(OutputDomain const& domain, NodeBlocks const& blocks)
{
  char const* units[] = {"m", "m", "m^2", "m^3"};
  const auto nodes = static_cast<hsize_t>(domain.num_global_nodes);
  const auto dimension = static_cast<hsize_t>(domain.dimension);
  std::vector<Piece> pieces{{"coordinates",
                             "m",
                             "Coordinates of the nodes.",
                             {nodes, dimension},
                             blocks(domain.coordinates, 1, dimension)},
                            {"weights",
                             units[domain.nodes_per_element - 1],
                             "Lumped length, area or volume of each node.",
                             {nodes},
                             blocks(domain.weights, 1, 1)},
                            {"vertex_ids",
                             "-",
                             "Numbers of the nodes in the mesh.",
                             {nodes},
                             integers(blocks(domain.vertex_ids, 1, 1))}};
  if (domain.isCurve()) {
    pieces.push_back(
      {"positions", "m", positionMeaning(domain), {nodes}, blocks(domain.positions, 1, 1)});
  }
  return pieces;
}

// The first `total` elements of all ranks; this rank's part is what its block has of them.
Piece elementPiece(std::string const& name, std::string const& description,
                   ElementBlocks const& elements, GlobalOrdinal total, int corners)
{
  const auto first = std::min(elements.first(), total);
  const auto count = std::min(elements.first() + elements.count(), total) - first;
  auto const& nodes = elements.nodes();
  return {name,
          "-",
          description,
          {static_cast<hsize_t>(total), static_cast<hsize_t>(corners)},
          Integers(nodes.begin(), nodes.begin() + count * corners)};
}

// The boundary of each element of a surface that is made of several boundaries.
Piece boundaryPiece(OutputDomain const& domain, ElementBlocks const& elements)
{
  const std::vector<double> own(domain.element_boundaries.begin(), domain.element_boundaries.end());
  return {"element_boundaries",
          "-",
          "The boundary of each element, as a row of boundary_names.",
          {static_cast<hsize_t>(elements.total())},
          integers(elements(own, 1, 1))};
}

h5::File create(std::filesystem::path const& path, std::vector<Piece> const& pieces,
                OutputDomain const& domain)
{
  makeFolderOf(path);
  h5::File file = h5::File::create(path);
  for (auto const& piece : pieces) {
    const bool is_real = piece.values.index() == 0;
    describe(file.create("geometry/" + piece.name, is_real ? h5::Type::float64 : h5::Type::int64,
                         piece.shape),
             piece.unit, piece.description);
  }
  writeParts(file, domain);
  return file;
}

// Rank 0 writes the parts of all ranks. Collective.
void fill(std::optional<h5::File>& file, Piece const& piece, Communicator const& comm)
{
  hsize_t row_size = 1, first = 0;
  for (std::size_t d = 1; d < piece.shape.size(); ++d) {
    row_size *= piece.shape[d];
  }
  std::visit(
    [&](auto const& mine) {
      using Number = typename std::decay_t<decltype(mine)>::value_type;
      visitInOrder<Number>(mine, comm, [&](std::vector<Number> const& values) {
        const hsize_t count = values.size() / row_size;
        if (count > 0) {
          file->openDataset("geometry/" + piece.name).writePart(values.data(), {first, count});
        }
        first += count;
      });
    },
    piece.values);
}
} // namespace

GeometryFile writeGeometry(std::filesystem::path const& directory, std::string const& name,
                           OutputDomain const& domain, NodeBlocks const& blocks)
{
  auto const& comm = *domain.comm;
  auto pieces = nodePieces(domain, blocks);
  const ElementBlocks elements(domain, blocks);
  pieces.push_back(elementPiece("connectivity", "Nodes of each element, as rows of coordinates.",
                                elements, elements.total(), domain.nodes_per_element));
  GeometryFile result;
  result.name = "segments/" + name + "_geometry.h5";
  result.num_elements = static_cast<hsize_t>(elements.total());
  result.num_whole = static_cast<hsize_t>(elements.numWhole());
  if (domain.is_periodic) {
    pieces.push_back(elementPiece("whole_elements",
                                  "The first ones of `connectivity`, which do not reach across a "
                                  "period.",
                                  elements, elements.numWhole(), domain.nodes_per_element));
  }
  if (!domain.boundaries.empty() && !domain.isCurve()) {
    pieces.push_back(boundaryPiece(domain, elements));
  }
  const auto path = directory / result.name;
  std::optional<h5::File> file; // of rank 0
  onRoot(comm, [&] { file = create(temporaryName(path), pieces, domain); });
  for (auto const& piece : pieces) {
    fill(file, piece, comm);
  }
  onRoot(comm, [&] {
    file->close();
    synchronise(temporaryName(path));
    replaceDurably(path);
  });
  return result;
}
} // namespace asperity::io::detail
