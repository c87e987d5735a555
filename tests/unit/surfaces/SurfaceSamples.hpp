#pragma once

#include "surfaces/TriangleSurface.hpp"

#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <unistd.h>

namespace asperity::geometry
{
// A folder for files, gone at the end of the test.
class FileTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    folder_ =
      std::filesystem::temp_directory_path() / ("asperity-surfaces-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(std::string const& name) const { return (folder_ / name).string(); }
  std::string write(std::string const& name, std::string const& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }
  std::filesystem::path const& folder() const { return folder_; }

private:
  std::filesystem::path folder_;
};

// The bytes of a number, little-endian or turned round.
template <class Number>
std::string bytes(Number value, bool big_endian = false)
{
  std::string text(sizeof(value), '\0');
  std::memcpy(text.data(), &value, sizeof(value));
  return big_endian ? std::string(text.rbegin(), text.rend()) : text;
}

inline std::array<double, 3> normalOf(TriangleSurface const& surface,
                                      std::array<int, 3> const& triangle)
{
  auto const& a = surface.points[triangle[0]];
  auto const& b = surface.points[triangle[1]];
  auto const& c = surface.points[triangle[2]];
  std::array<double, 3> u, v;
  for (int d = 0; d < 3; ++d) {
    u[d] = b[d] - a[d];
    v[d] = c[d] - a[d];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline double areaOf(TriangleSurface const& surface)
{
  double area = 0;
  for (auto const& triangle : surface.triangles) {
    const auto normal = normalOf(surface, triangle);
    area += std::hypot(normal[0], normal[1], normal[2]) / 2;
  }
  return area;
}

// The largest value of |f| at the points.
inline double largest(TriangleSurface const& surface,
                      std::function<double(std::array<double, 3> const&)> const& f)
{
  double result = 0;
  for (auto const& point : surface.points) {
    result = std::max(result, std::abs(f(point)));
  }
  return result;
}

// {low, high} of one coordinate.
inline std::array<double, 2> extentOf(TriangleSurface const& surface, int d)
{
  std::array<double, 2> extent = {1e300, -1e300};
  for (auto const& point : surface.points) {
    extent = {std::min(extent[0], point[d]), std::max(extent[1], point[d])};
  }
  return extent;
}
} // namespace asperity::geometry
