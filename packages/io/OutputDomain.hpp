#pragma once

#include "base/Types.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::io
{
// The end of a curve at which its positions are 0. The upper end is the one with the greater y; of
// ends that are equally high the one with the smaller x. Of surfaces, which are level but for their
// relief, it is always the one with the smaller x (then y).
enum class CurveStart
{
  upper_end,
  smaller_x
};

// Ends of a curve that differ less in height than this share of its extent are equally high.
constexpr double equally_high = 1e-6;

// Where fields live: a boundary or the volume, as this rank sees it.
//
// Nodes are this rank's owned vertices that belong to the domain, in the order of the mesh. Every
// node has a number within the domain, 0 <= number < num_global_nodes, which is also its place in
// every file, so that files do not depend on the number of ranks: along a curve the nodes are
// numbered by position, elsewhere by the vertices' global ids.
struct OutputDomain
{
  std::string name;          // "fault", "surface", "volume"
  int dimension = 0;         // of space
  int nodes_per_element = 0; // 2 segments, 3 triangles, 4 tetrahedra
  GlobalOrdinal num_global_nodes = 0;
  RCP<const Communicator> comm;

  std::vector<int> vertices;                // (num_owned) local vertices of the mesh
  std::vector<GlobalOrdinal> vertex_ids;    // (num_owned) global ids in the mesh
  std::vector<GlobalOrdinal> node_numbers;  // (num_owned) numbers within the domain
  std::vector<double> coordinates;          // (num_owned, dimension) [m]
  std::vector<double> weights;              // (num_owned) lumped measure [m], [m^2] or [m^3]
  std::vector<double> positions;            // (num_owned) arc length [m]; empty unless a curve
  CurveStart start = CurveStart::upper_end; // where positions are 0
  // A boundary of the mesh that a curve is made of: the range of its positions [m].
  struct Part
  {
    std::string name;
    double begin, end;
  };
  std::vector<Part> parts; // by position; empty if the curve is a single boundary
  // The boundaries of the mesh that the domain is made of, in the order of the deck, and the first
  // of them that has a node, or the one that has an element; empty if it is a single boundary.
  std::vector<std::string> boundaries;
  std::vector<int> node_boundaries;    // (num_owned)
  std::vector<int> element_boundaries; // (num_owned_elements)

  std::vector<GlobalOrdinal> connectivity; // (num_owned_elements, nodes_per_element), by number
  std::vector<double> corners;             // (num_owned_elements, nodes_per_element, dimension) [m]

  // A fault in two dimensions: whether its plus side, that of the body, lies below it.
  bool is_foot_wall = false;

  // In a periodic mesh an element may reach across a period: its corners above lie next to each
  // other, but the coordinates of its nodes do not.
  bool is_periodic = false;
  std::vector<char> wraps; // (num_owned_elements) 1 where the element reaches across a period
  // (num_owned_elements) the number of each among this rank's cells, or facets of the boundary
  std::vector<int> numbers_in_mesh;

  std::size_t numOwned() const { return vertices.size(); }
  std::size_t numOwnedElements() const { return connectivity.size() / nodes_per_element; }
  bool isCurve() const { return dimension == 2 && nodes_per_element == 2; }
};

// Where the positions of a curve are 0, in words for descriptions of files, "its upper end (...)",
// with the names and positions of its parts.
std::string startText(OutputDomain const& curve);
// "main: 0 to 20000 m, splay: 20000 to 24000 m", or nothing.
std::string partsText(OutputDomain const& curve);
// The name of the part at a position [m]; of two that meet there the first; "" without parts.
std::string partAt(OutputDomain const& curve, double position);

// The domain `name` made of the mesh's boundary `boundary` (num_owned may be 0 on a rank).
//
// In two dimensions positions are the distance along the boundary from its start. Each further
// piece of a boundary continues where the piece before it ended.
// Throws InputError if the mesh has no boundary of that name, or if the boundary has no facets on
// any rank. Collective.
template <int Dim>
OutputDomain boundaryDomain(std::string const& name, Mesh<Dim> const& mesh,
                            std::string const& boundary, RCP<const Communicator> const& comm,
                            CurveStart start = CurveStart::upper_end);

// Fills the boundaries and, of a curve, the parts of a domain whose boundary joinBoundaries made of
// these. Does nothing if it is a single one. Collective.
template <int Dim>
void nameParts(OutputDomain& domain, Mesh<Dim> const& mesh,
               std::vector<std::string> const& boundaries);

// All vertices and cells, under the name "volume".
template <int Dim>
OutputDomain volumeDomain(Mesh<Dim> const& mesh, RCP<const Communicator> const& comm);
} // namespace asperity::io
