#include "arrangement/Body.hpp"

#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/Patches.hpp"
#include "surfaces/TriangleSurface.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace asperity::geometry
{
namespace
{
// Height of the ground above a place, -inf where there is none.
double groundAt(TriangleSurface const& ground, double x, double y)
{
  constexpr double rounding = 1e-12;
  double height = -std::numeric_limits<double>::infinity();
  for (auto const& triangle : ground.triangles) {
    auto const& a = ground.points[triangle[0]];
    const auto u = mesh::difference<3>(ground.points[triangle[1]], a);
    const auto v = mesh::difference<3>(ground.points[triangle[2]], a);
    const double determinant = u[0] * v[1] - u[1] * v[0];
    if (determinant == 0) {
      continue; // a vertical triangle
    }
    const double s = ((x - a[0]) * v[1] - (y - a[1]) * v[0]) / determinant;
    const double t = (u[0] * (y - a[1]) - u[1] * (x - a[0])) / determinant;
    if (s >= -rounding && t >= -rounding && s + t <= 1 + rounding) {
      height = std::max(height, a[2] + s * u[2] + t * v[2]);
    }
  }
  return height;
}

class Selection
{
public:
  Selection(Arrangement const& arrangement, Model const& model)
      : complex_(arrangement.complex)
      , model_(model)
      , patches_(findPatches(complex_))
      , is_kept_(patches_.list.size(), true)
  {
  }

  void dropOutside()
  {
    for (std::size_t p = 0; p < is_kept_.size(); ++p) {
      if (!isInBody(patches_.list[p])) {
        drop(p, Dropped::Reason::outside);
      }
    }
  }

  void dropPushed(std::vector<std::vector<int>> const& points_of,
                  std::vector<std::vector<bool>> const& is_moved)
  {
    std::vector<std::map<int, bool>> moved_points(model_.surfaces.size());
    for (std::size_t s = 0; s < points_of.size(); ++s) {
      for (std::size_t i = 0; i < points_of[s].size(); ++i) {
        moved_points[s][points_of[s][i]] = is_moved[s][i];
      }
    }
    std::vector<int> given(is_kept_.size(), 0), moved(is_kept_.size(), 0);
    for (std::size_t i = 0; i < complex_.triangles.size(); ++i) {
      for (int v : complex_.triangles[i]) {
        auto const& points = moved_points[complex_.surfaces[i]];
        const auto found = points.find(v);
        if (found != points.end()) {
          ++given[patches_.patch_of_triangle[i]];
          moved[patches_.patch_of_triangle[i]] += found->second ? 1 : 0;
        }
      }
    }
    for (std::size_t p = 0; p < is_kept_.size(); ++p) {
      if (is_kept_[p] && given[p] > 0 && given[p] == moved[p]) {
        drop(p, Dropped::Reason::pushed);
      }
    }
  }

  void dropStubs(double share)
  {
    std::vector<double> areas(model_.surfaces.size(), 0);
    for (std::size_t p = 0; p < is_kept_.size(); ++p) {
      areas[patches_.list[p].surface] += is_kept_[p] ? patches_.list[p].area : 0;
    }
    for (std::size_t p = 0; p < is_kept_.size(); ++p) {
      auto const& patch = patches_.list[p];
      if (is_kept_[p] && model_.isFault(patch.surface) && patch.has_free_border &&
          patch.meets_others && patch.area < share * areas[patch.surface]) {
        drop(p, Dropped::Reason::overshoot);
      }
    }
  }

  std::vector<bool> keptTriangles() const
  {
    std::vector<bool> is_kept;
    for (int patch : patches_.patch_of_triangle) {
      is_kept.push_back(is_kept_[patch]);
    }
    return is_kept;
  }

  std::vector<Dropped> const& dropped() const { return dropped_; }

private:
  bool isInBody(Patch const& patch) const
  {
    auto const& box = model_.box;
    const double rounding = 1e-9 * mesh::distance<3>(box.low, box.high);
    auto c = centroidOf(complex_.points, complex_.triangles[patch.largest]);
    for (int d = 0; d < 2; ++d) {
      if (c[d] < box.low[d] - rounding || c[d] > box.high[d] + rounding) {
        return false;
      }
      c[d] = std::clamp(c[d], box.low[d], box.high[d]);
    }
    return c[2] >= box.low[2] - rounding &&
           (model_.isGround(patch.surface) ||
            c[2] < groundAt(model_.surfaces[model_.ground()].surface, c[0], c[1]));
  }

  void drop(std::size_t patch, Dropped::Reason reason)
  {
    is_kept_[patch] = false;
    auto const& dropped_patch = patches_.list[patch];
    dropped_.push_back({model_.name(dropped_patch.surface), model_.isFault(dropped_patch.surface),
                        reason, dropped_patch.area,
                        centroidOf(complex_.points, complex_.triangles[dropped_patch.largest])});
  }

  Complex const& complex_;
  Model const& model_;
  Patches patches_;
  std::vector<bool> is_kept_; // (num_patches)
  std::vector<Dropped> dropped_;
};

void requireFaults(Complex const& complex, Model const& model)
{
  std::vector<bool> is_there(model.surfaces.size(), false);
  for (int s : complex.surfaces) {
    is_there[s] = true;
  }
  for (int s = 0; s < model.num_faults; ++s) {
    ASPERITY_REQUIRE(is_there[s],
                     "Fault '" << model.name(s) << "' is not inside the body: its "
                               << extentText(model.surfaces[s].surface.points) << "; the box has "
                               << extentText({model.box.low, model.box.high})
                               << ", and what lies above the ground is left out. Are Units right, "
                                  "and Box, or Trim Stubs?");
  }
}

// The outer surface is closed if each of its edges has two of its triangles.
void requireClosed(Complex const& complex, Model const& model)
{
  for (auto const& [edge, triangles] : trianglesAtEdges(complex.triangles)) {
    std::vector<int> outer;
    for (int i : triangles) {
      if (!model.isFault(complex.surfaces[i])) {
        outer.push_back(complex.surfaces[i]);
      }
    }
    ASPERITY_REQUIRE(
      outer.empty() || outer.size() == 2,
      "'" << model.name(outer[0]) << "' ends at " << placeText(complex.points[edge[0]])
          << ", so that the body is not closed there. The ground has to reach beyond the walls "
             "everywhere, without a hole, and to lie above the bottom: give a smaller Box / Margin "
             "or a larger ground.");
  }
  std::vector<bool> is_there(model.surfaces.size(), false);
  for (int s : complex.surfaces) {
    is_there[s] = true;
  }
  for (int s = model.ground(); s < static_cast<int>(model.surfaces.size()); ++s) {
    ASPERITY_REQUIRE(is_there[s], "Nothing is left of '"
                                    << model.name(s)
                                    << "': is the ground above the bottom, and over the box? It "
                                       "has "
                                    << extentText(model.surfaces[model.ground()].surface.points)
                                    << ", the box " << extentText({model.box.low, model.box.high})
                                    << ".");
  }
}
} // namespace

std::vector<Dropped> keepBody(Arrangement& arrangement, Model const& model,
                              std::vector<std::vector<bool>> const& is_moved, double stub_share)
{
  Selection outside(arrangement, model);
  outside.dropOutside();
  outside.dropPushed(arrangement.points_of, is_moved);
  keepTriangles(arrangement.complex, outside.keptTriangles());
  Selection stubs(arrangement, model); // finds patches anew, without the removed pieces
  stubs.dropStubs(stub_share);
  keepTriangles(arrangement.complex, stubs.keptTriangles());
  requireFaults(arrangement.complex, model);
  requireClosed(arrangement.complex, model);
  auto dropped = outside.dropped();
  dropped.insert(dropped.end(), stubs.dropped().begin(), stubs.dropped().end());
  return dropped;
}
} // namespace asperity::geometry
