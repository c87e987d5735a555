#pragma once

#include "surfaces/TriangleSurface.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
enum class Outside
{
  refuse,
  clamp // the value at the nearest place of the edge
};

// Values z at the crossings of lines x and y, nan where there is none.
class Grid
{
public:
  // x (num_x), y (num_y): either direction, spacing may vary; z (num_y, num_x). is_periodic: x is a
  // longitude [degrees], so that x and x + 360 are the same. InputError, which starts with `where`,
  // unless both axes have two or more values that go in one direction, all finite.
  Grid(std::vector<double> x, std::vector<double> y, std::vector<double> z, bool is_periodic,
       std::string const& where);

  // Bilinear. InputError outside of the axes, unless clamped, and where one of the values around
  // that have a weight is undefined.
  double operator()(double x, double y, Outside outside = Outside::refuse) const;

  std::vector<double> const& x() const { return x_; } // increasing
  std::vector<double> const& y() const { return y_; } // increasing
  double z(std::size_t i, std::size_t j) const { return z_[j * x_.size() + i]; }
  void setPeriodic() { is_periodic_ = true; } // where the file does not tell it
  std::string const& where() const { return where_; }

  void scale(double factor); // multiplies all z

  // The surface through every `stride`-th line of both axes and the last one, with two triangles
  // for a cell with four values and one for a cell with three.
  TriangleSurface surface(std::size_t stride = 1) const;

private:
  struct Place
  {
    std::size_t below;
    double share; // of the next line
  };
  Place place(std::vector<double> const& axis, double value, char const* name,
              Outside outside) const;

  std::vector<double> x_, y_, z_;
  bool is_periodic_;
  std::string where_;
};
} // namespace asperity::geometry
