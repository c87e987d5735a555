#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"

#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"
#include "mesh/MeetingFaults.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
template <int Dim>
std::string boundingBox(GlobalMesh<Dim> const& mesh)
{
  std::string box;
  for (int d = 0; d < Dim; ++d) {
    const auto [low, high] =
      std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                          [d](auto const& a, auto const& b) { return a[d] < b[d]; });
    box += (d == 0 ? "[" : " x [") + formatShort((*low)[d]) + ", " + formatShort((*high)[d]) + "]";
  }
  return box;
}

// The number of vertices of a fault at which it ends inside the body.
template <int Dim>
std::string tips(GlobalMesh<Dim> const& mesh, std::string const& fault)
{
  const auto vertices = mesh::boundaryVertices(mesh, fault);
  const auto number = std::count_if(mesh.splits.begin(), mesh.splits.end(), [&](auto const& pair) {
    return pair.is_tip && std::binary_search(vertices.begin(), vertices.end(), pair.plus);
  });
  return std::to_string(number) + (number == 1 ? " tip, " : " tips, ");
}

template <int Dim>
void printSizes(GlobalMesh<Dim> const& mesh)
{
  const auto sizes = mesh::cellSizes(mesh);
  std::cout << "dimension        " << Dim << "\nvertices         " << mesh.vertices.size();
  if (!mesh.splits.empty()) { // withMesh splits faults, unless the file has them split
    std::cout << ", " << mesh.splits.size() << " of them copies at faults";
  }
  std::cout << "\ncells            " << mesh.cells.size() << "\nbounding box     "
            << boundingBox(mesh) << " m\n";
  for (int d = 0; d < Dim; ++d) {
    if (mesh.period[d] > 0) {
      std::cout << "period along "
                << "xyz"[d] << "   " << formatShort(mesh.period[d]) << " m\n";
    }
  }
  std::cout << (Dim == 2 ? "area             " : "volume           ") << formatShort(sizes.measure)
            << (Dim == 2 ? " m^2\n" : " m^3\n") << "cell diameters   "
            << formatShort(sizes.smallest_diameter) << " to " << formatShort(sizes.largest_diameter)
            << " m\nshortest edge    " << formatShort(sizes.shortest_edge) << " m at "
            << mesh::text(sizes.place_of_shortest_edge) << " m\nsmallest angle   "
            << formatShort(sizes.smallest_angle * 180 / std::acos(-1.)) << " degrees at "
            << mesh::text(sizes.place_of_smallest_angle) << " m\n";
}

template <int Dim>
void printNames(GlobalMesh<Dim> const& mesh)
{
  std::vector<int> num_cells(mesh.region_names.size(), 0);
  for (int region : mesh.cell_regions) {
    ++num_cells[static_cast<std::size_t>(region)];
  }
  for (std::size_t r = 0; r < num_cells.size(); ++r) {
    std::cout << "region           " << mesh.region_names[r] << ": " << num_cells[r] << " cells\n";
  }
  for (auto const& [name, facets] : mesh.boundaries) {
    const bool is_fault = std::binary_search(mesh.faults.begin(), mesh.faults.end(), name);
    std::cout << (is_fault ? "fault            " : "boundary         ") << name << ": "
              << facets.size() << " facets, " << mesh::boundaryVertices(mesh, name).size()
              << " vertices, " << (is_fault ? tips(mesh, name) : "") << "shortest edge "
              << formatShort(mesh::shortestEdge(mesh, name)) << " m\n";
  }
}

// Where two faults meet: points of the plane, lines in space. `which` has a width of 17.
template <int Dim>
void printLine(std::string const& which, std::string const& relation,
               mesh::MeetingLine<Dim> const& line)
{
  std::cout << which << line.faults[0] << relation << line.faults[1] << " at ";
  if (line.num_vertices > 1) {
    std::cout << line.num_vertices << " vertices from " << mesh::text(line.ends[0]) << " to "
              << mesh::text(line.ends[1]) << " m, " << formatShort(line.length) << " m long\n";
  } else {
    std::cout << mesh::text(line.ends[0]) << " m\n";
  }
}

template <int Dim>
void printMeetings(GlobalMesh<Dim> const& mesh)
{
  for (auto const& line : mesh::crossingLines(mesh)) {
    printLine("crossing         ", " and ", line);
  }
  for (auto const& line : mesh::jointLines(mesh)) {
    printLine("joint            ", " ends on ", line);
  }
}

class Info final : public Command
{
public:
  CommandText text() const override
  {
    return {"info",
            "FILE.h5",
            "Prints counts after the split along the faults, sizes, regions, boundaries, faults, "
            "where two of them cross, and where one ends on another and slips along it.",
            {"FILE.h5"}};
  }

  void declareOptions(Arguments& /*arguments*/) override {}

  void run(Arguments const& arguments) override
  {
    withMesh(arguments.file(0), [](auto const& mesh, auto const& parts) {
      if (parts) {
        std::cout << "parts            " << parts->num_parts;
        if (!parts->options.boundary.empty()) {
          std::cout << ", with boundary " << parts->options.boundary << " balanced";
        }
        std::cout << "\nfingerprint      " << parts->fingerprint << '\n';
      }
      printSizes(mesh);
      printNames(mesh);
      printMeetings(mesh);
    });
  }
};
} // namespace

std::unique_ptr<Command> infoCommand() { return std::make_unique<Info>(); }
} // namespace asperity::geometry
