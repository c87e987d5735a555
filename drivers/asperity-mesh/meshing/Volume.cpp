#include "meshing/Volume.hpp"

#include "GmshSession.hpp"
#include "arrangement/Curves.hpp"
#include "arrangement/Patches.hpp"
#include "meshing/MeshInGmsh.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <gmsh.h>

#include <chrono>
#include <numeric>
#include <set>

namespace asperity::geometry
{
namespace
{
namespace model = gmsh::model;
using ProgressSink = std::function<void(std::string const&)>;

// Gmsh's types of elements
constexpr int type_point = 15, type_segment = 1, type_triangle = 2;

std::size_t tagOf(int point) { return static_cast<std::size_t>(point) + 1; }

// The model in Gmsh: points, curves and surfaces with tags 1, 2, ... in the order here.
class DiscreteModel
{
public:
  DiscreteModel(Complex const& complex, Model const& named_model)
      : complex_(complex)
      , model_(named_model)
      , curves_(findCurves(complex))
      , patches_(findPatches(complex))
      , triangles_of_(patches_.list.size())
      , has_node_(complex.points.size(), false)
  {
    for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
      triangles_of_[patches_.patch_of_triangle[i]].push_back(static_cast<int>(i));
    }
  }

  void build()
  {
    addCorners();
    addCurves();
    for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
      addPatch(static_cast<int>(p));
    }
    addElements();
    model::mesh::createGeometry();
    addVolume();
    embed();
  }

  // 1.5 area / perimeter, for patches and the curves around them.
  std::map<std::pair<int, int>, double> widths() const
  {
    std::map<std::pair<int, int>, double> widths;
    for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
      double perimeter = 0;
      for (int c : borders_[p]) {
        perimeter += lengthOf(complex_, curves_[c - 1]);
      }
      const double width = 1.5 * patches_.list[p].area / perimeter;
      widths[{2, static_cast<int>(p) + 1}] = width;
      for (int c : borders_[p]) {
        auto& of_curve = widths.emplace(std::pair(1, c), width).first->second;
        of_curve = std::min(of_curve, width);
      }
    }
    return widths;
  }

  std::map<std::string, std::vector<int>> surfacesByName() const
  {
    std::map<std::string, std::vector<int>> surfaces;
    for (std::size_t p = 0; p < patches_.list.size(); ++p) {
      surfaces[model_.name(patches_.list[p].surface)].push_back(static_cast<int>(p) + 1);
    }
    return surfaces;
  }

private:
  void addNodes(int dimension, int entity, std::vector<int> const& points)
  {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    for (int v : points) {
      tags.push_back(tagOf(v));
      coordinates.insert(coordinates.end(), complex_.points[v].begin(), complex_.points[v].end());
      has_node_[v] = true;
    }
    model::mesh::addNodes(dimension, entity, tags, coordinates);
  }

  void addCorners()
  {
    std::set<int> corners;
    for (auto const& curve : curves_) {
      corners.insert({curve.points.front(), curve.points.back()});
    }
    for (int v : corners) {
      const int tag = static_cast<int>(corner_.size()) + 1;
      corner_[v] = tag;
      model::addDiscreteEntity(0, tag);
      addNodes(0, tag, {v});
      model::mesh::addElementsByType(tag, type_point, {}, {tagOf(v)});
    }
  }

  void addCurves()
  {
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const int tag = static_cast<int>(c) + 1;
      auto const& points = curves_[c].points;
      model::addDiscreteEntity(1, tag, {corner_.at(points.front()), corner_.at(points.back())});
      addNodes(1, tag, {points.begin() + 1, points.end() - 1});
      for (std::size_t i = 1; i < points.size(); ++i) {
        curve_at_[edgeOf(points[i - 1], points[i])] = tag;
      }
    }
  }

  // Curves at which the patch lies on one side bound it; those inside it are embedded.
  void addPatch(int p)
  {
    std::map<int, int> sides; // of the patch at an edge of the curve
    std::set<int> points, on_curves;
    std::set<Edge> edges;
    std::map<Edge, int> count;
    for (int i : triangles_of_[p]) {
      auto const& t = complex_.triangles[i];
      points.insert(t.begin(), t.end());
      for (int k = 0; k < 3; ++k) {
        const auto edge = edgeOf(t, k);
        edges.insert(edge);
        if (curve_at_.count(edge) > 0) {
          ++count[edge];
          on_curves.insert(edge.begin(), edge.end());
        }
      }
    }
    for (auto const& [edge, number] : count) {
      sides[curve_at_.at(edge)] = number;
    }
    auto& borders = borders_.emplace_back();
    auto& inner = inner_.emplace_back();
    for (auto const& [curve, number] : sides) {
      (number == 1 ? borders : inner).push_back(curve);
    }
    auto const& name = model_.name(patches_.list[p].surface);
    const auto place =
      placeText(centroidOf(complex_.points, complex_.triangles[patches_.list[p].largest]));
    ASPERITY_REQUIRE(!borders.empty(),
                     "'" << name << "' is closed at " << place
                         << ", as a sphere is. Cut it into two surfaces with a name each.");
    requireNoHandle(static_cast<int>(points.size()), static_cast<int>(edges.size()), p, name,
                    place);
    const int tag = p + 1;
    model::addDiscreteEntity(2, tag, borders);
    std::vector<int> own;
    auto& touched = touched_.emplace_back();
    for (int v : points) {
      if (!has_node_[v]) {
        own.push_back(v);
      } else if (on_curves.count(v) == 0 && corner_.count(v) > 0) {
        touched.push_back(corner_.at(v));
      }
    }
    addNodes(2, tag, own);
  }

  // Euler's number of a sphere with h holes is 2 - h; a handle takes 2 more.
  void requireNoHandle(int num_points, int num_edges, int p, std::string const& name,
                       std::string const& place) const
  {
    std::map<int, std::set<int>> next; // along the border
    for (int c : borders_[p]) {
      auto const& points = curves_[c - 1].points;
      for (std::size_t i = 1; i < points.size(); ++i) {
        next[points[i - 1]].insert(points[i]);
        next[points[i]].insert(points[i - 1]);
      }
    }
    int loops = 0, pinches = 0;
    std::set<int> known;
    for (auto const& [start, ends] : next) {
      pinches += static_cast<int>(ends.size()) / 2 - 1;
      std::vector<int> queue;
      if (known.insert(start).second) {
        ++loops;
        queue.push_back(start);
      }
      for (std::size_t k = 0; k < queue.size(); ++k) {
        for (int v : next.at(queue[k])) {
          if (known.insert(v).second) {
            queue.push_back(v);
          }
        }
      }
    }
    const int euler = num_points - num_edges + static_cast<int>(triangles_of_[p].size());
    ASPERITY_REQUIRE(euler + loops + pinches >= 2 || pinches > 0,
                     "'" << name << "' has a handle, as the surface of a ring has, at " << place
                         << ". Cut it into surfaces with a name each.");
  }

  void addElements() const
  {
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      std::vector<std::size_t> ends;
      auto const& points = curves_[c].points;
      for (std::size_t i = 1; i < points.size(); ++i) {
        ends.insert(ends.end(), {tagOf(points[i - 1]), tagOf(points[i])});
      }
      model::mesh::addElementsByType(static_cast<int>(c) + 1, type_segment, {}, ends);
    }
    for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
      std::vector<std::size_t> corners;
      for (int i : triangles_of_[p]) {
        for (int v : complex_.triangles[i]) {
          corners.push_back(tagOf(v));
        }
      }
      model::mesh::addElementsByType(static_cast<int>(p) + 1, type_triangle, {}, corners);
    }
  }

  void addVolume()
  {
    std::vector<int> shell;
    for (std::size_t p = 0; p < patches_.list.size(); ++p) {
      (model_.isFault(patches_.list[p].surface) ? faults_ : shell)
        .push_back(static_cast<int>(p) + 1);
    }
    volume_ = model::geo::addVolume({model::geo::addSurfaceLoop(shell)});
    model::geo::synchronize();
  }

  void embed() const
  {
    model::mesh::embed(2, faults_, 3, volume_);
    for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
      const int tag = static_cast<int>(p) + 1;
      if (!inner_[p].empty()) {
        model::mesh::embed(1, inner_[p], 2, tag);
      }
      if (!touched_[p].empty()) {
        model::mesh::embed(0, touched_[p], 2, tag);
      }
    }
  }

  Complex const& complex_;
  Model const& model_;
  std::vector<Curve> curves_;
  Patches patches_;
  std::vector<std::vector<int>> triangles_of_;              // by patch
  std::vector<std::vector<int>> borders_, inner_, touched_; // by patch: curves, curves, corners
  std::vector<bool> has_node_;                              // (num_points)
  std::map<int, int> corner_;                               // tag by point
  std::map<Edge, int> curve_at_;                            // tag by edge
  std::vector<int> faults_;
  int volume_ = 0;
};

// The errors that Gmsh has reported.
std::string gmshErrors()
{
  std::vector<std::string> lines;
  gmsh::logger::get(lines);
  std::string text;
  int number = 0;
  for (auto const& line : lines) {
    const bool is_error = line.rfind("Error", 0) == 0 || line.rfind("Warning", 0) == 0;
    if (is_error && number < 5) {
      text += "\n  Gmsh: " + line;
      ++number;
    }
  }
  return text;
}

void generate(int dimension)
{
  constexpr char const* what[] = {"", "curves", "surfaces", "volume"};
  const auto error = errorOfGmsh([&] { model::mesh::generate(dimension); });
  ASPERITY_REQUIRE(error.empty(), "Gmsh cannot mesh the " << what[dimension] << ": " << error
                                                          << ". Try a smaller Cell Size at the "
                                                             "place, or a larger Snap."
                                                          << gmshErrors());
}

void setOptions()
{
  constexpr int frontal = 6, delaunay = 1; // of surfaces, of volumes
  gmsh::option::setNumber("General.NumThreads", 1);
  for (auto const* name : {"Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints",
                           "Mesh.MeshSizeFromCurvature"}) {
    gmsh::option::setNumber(name, 0);
  }
  gmsh::option::setNumber("Mesh.Algorithm", frontal);
  gmsh::option::setNumber("Mesh.Algorithm3D", delaunay);
  gmsh::option::setNumber("Mesh.Optimize", 1);
}

// Gmsh's size at a place of an entity; newer versions give their own size as the last argument.
template <class SizeAt>
void setSize(SizeAt const& size)
{
#if GMSH_API_VERSION_MAJOR > 4 || GMSH_API_VERSION_MINOR > 8
  model::mesh::setSizeCallback(
    [size](int dimension, int entity, double x, double y, double z, double) {
      return size(dimension, entity, {x, y, z});
    });
#else
  model::mesh::setSizeCallback([size](int dimension, int entity, double x, double y, double z) {
    return size(dimension, entity, {x, y, z});
  });
#endif
}

// How far the volume is, from how many sizes Gmsh has requested there.
class FillProgress
{
public:
  FillProgress(double expected_cells, ProgressSink const& reportProgress)
      : expected_(calls_per_cell * expected_cells)
      , tell_(reportProgress)
  {
  }

  // The first calls do not count: Gmsh prepares for long between them.
  void count()
  {
    if (++number_ % calls_between_looks != 0) {
      return;
    }
    const auto now = Clock::now();
    if (number_ == calls_between_looks) {
      start_ = last_ = now;
    }
    if (now - last_ < interval) {
      return;
    }
    last_ = now;
    const auto done = static_cast<double>(number_ - calls_between_looks);
    const double share = done / expected_;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    tell_(share < 0.95
            ? "the volume is filled to about " + formatted("%.0f", 100 * share) + " %, about " +
                formatted("%.0f", seconds * (1 / share - 1)) + " s are left"
            : "the volume is nearly filled");
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr double calls_per_cell = 0.1; // measured
  static constexpr long long calls_between_looks = 64;
  static constexpr std::chrono::seconds interval{10};

  double expected_;
  ProgressSink const& tell_;
  long long number_ = 0;
  Clock::time_point start_, last_;
};
} // namespace

GlobalMesh<3> fillVolume(Complex const& complex, Model const& model, CellSize const& size,
                         double expected_cells, ProgressSink const& reportProgress)
{
  const GmshSession session(false);
  gmsh::logger::start();
  setOptions();
  model::add("built");
  DiscreteModel discrete(complex, model);
  const auto error = errorOfGmsh([&] { discrete.build(); });
  ASPERITY_REQUIRE(error.empty(),
                   "Gmsh cannot take the surfaces: " << error << '.' << gmshErrors());
  const auto widths = discrete.widths();
  FillProgress progress(expected_cells, reportProgress);
  setSize([&](int dimension, int entity, Point<3> const& place) {
    if (dimension == 3) {
      progress.count();
    }
    const auto width = widths.find({dimension, entity});
    const double at_place = size(place);
    return width == widths.end() ? at_place : std::min(at_place, width->second);
  });
  generate(1);
  generate(2);
  std::vector<std::size_t> tags, nodes;
  model::mesh::getElementsByType(type_triangle, tags, nodes);
  reportProgress("surfaces have " + std::to_string(tags.size()) + " facets");
  generate(3);
  auto mesh = meshInGmsh(discrete.surfacesByName());
  reportProgress("the volume has " + std::to_string(mesh.cells.size()) + " cells");
  model::mesh::removeSizeCallback();
  mesh::orientCells(mesh);
  mesh::orientFacets(mesh);
  return mesh;
}
} // namespace asperity::geometry
