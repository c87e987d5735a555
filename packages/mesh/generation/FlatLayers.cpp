#include "mesh/generation/FlatLayers.hpp"

#include "base/Errors.hpp"
#include "mesh/generation/LayerHeights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace asperity::mesh
{
namespace
{
// Where a vertex goes that has this distance from a plane.
class Squeeze
{
public:
  // length: from the plane to where nothing moves [m]
  Squeeze(LayerHeights const& layers, double length)
      : layers_(layers)
      , rest_((length - layers.flat(layers.end())) / (length - layers.end()))
  {
  }

  double operator()(double distance) const
  {
    const double end = layers_.end();
    return distance < end ? layers_.flat(distance) : layers_.flat(end) + rest_ * (distance - end);
  }

private:
  LayerHeights layers_;
  double rest_;
};

// The smallest extent along the axis of cells with a facet in the plane; 0 without such a cell.
template <int Dim>
double layerAt(GlobalMesh<Dim> const& mesh, int axis, double position, double close)
{
  double smallest = std::numeric_limits<double>::max();
  bool is_found = false;
  for (auto const& cell : mesh.cells) {
    int in_plane = 0;
    double extent = 0;
    for (int vertex : cell) {
      const double distance = std::abs(mesh.vertices[vertex][axis] - position);
      in_plane += distance < close ? 1 : 0;
      extent = std::max(extent, distance);
    }
    if (in_plane == Dim) {
      smallest = std::min(smallest, extent);
      is_found = true;
    }
  }
  return is_found ? smallest : 0;
}
} // namespace

template <int Dim>
void flattenLayers(GlobalMesh<Dim>& mesh, FlatLayers const& layers, std::string const& where)
{
  const int axis = layers.axis;
  const auto [lowest, highest] = std::minmax_element(
    mesh.vertices.begin(), mesh.vertices.end(),
    [axis](Point<Dim> const& a, Point<Dim> const& b) { return a[axis] < b[axis]; });
  const double low = (*lowest)[axis], high = (*highest)[axis];
  const double close = 1e-9 * (high - low);
  auto planes = layers.positions;
  std::sort(planes.begin(), planes.end());

  std::vector<double> moved(mesh.vertices.size());
  std::transform(mesh.vertices.begin(), mesh.vertices.end(), moved.begin(),
                 [axis](Point<Dim> const& x) { return x[axis]; });
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double plane = planes[i];
    const double layer = layerAt(mesh, axis, plane, close);
    ASPERITY_REQUIRE(layer > 0, where << ": no facets of cells lie at " << plane << " m.");
    for (const int side : {-1, 1}) {
      const bool is_last = side < 0 ? i == 0 : i + 1 == planes.size();
      const double end = is_last ? (side < 0 ? low : high) : (plane + planes[i + side]) / 2;
      const double length = side * (end - plane);
      if (length < close) {
        continue;
      }
      const LayerHeights heights(layer, layers.height);
      ASPERITY_REQUIRE(heights.end() + layer <= length,
                       where << " needs more layers of cells beside " << plane << " m: one is "
                             << layer << " m high, and there are " << length << " m.");
      const Squeeze squeeze(heights, length);
      for (std::size_t vertex = 0; vertex < moved.size(); ++vertex) {
        const double distance = side * (mesh.vertices[vertex][axis] - plane);
        if (distance > close && distance < length - close) {
          moved[vertex] = plane + side * squeeze(distance);
        }
      }
    }
  }
  for (std::size_t vertex = 0; vertex < moved.size(); ++vertex) {
    mesh.vertices[vertex][axis] = moved[vertex];
  }
}

template void flattenLayers<2>(GlobalMesh<2>&, FlatLayers const&, std::string const&);
template void flattenLayers<3>(GlobalMesh<3>&, FlatLayers const&, std::string const&);
} // namespace asperity::mesh
