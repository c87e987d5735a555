#pragma once

#include <cmath>

namespace asperity::mesh
{
// How layers of cells beside a fault lose height: the first one has `height` times its own, the
// next ones 1.5 times as much each, until they have their own again.
class LayerHeights
{
public:
  static constexpr double growth = 1.5;

  // layer: the own height of a layer [m]; height: in (0, 1]
  LayerHeights(double layer, double height)
      : layer_(layer)
      , height_(height)
      , end_(layer * std::log(1 / height) / std::log(growth))
  {
  }

  double end() const { return end_; } // of the layers that lose height, before they do [m]

  // Where a vertex goes that has this distance from the fault, at most end() [m].
  double flat(double distance) const
  {
    return layer_ * height_ * (std::pow(growth, distance / layer_) - 1) / (growth - 1);
  }

private:
  double layer_, height_, end_;
};
} // namespace asperity::mesh
