#include "fem/stress/CoulombPlane.hpp"

#include "base/Errors.hpp"
#include "fem/stress/CellStress.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem
{
namespace
{
using Direction = Point<3>;
using mesh::cross;

double radians(double degrees) { return degrees * std::acos(-1.) / 180; }

// x a + y b
Direction sum(double x, Direction const& a, double y, Direction const& b)
{
  return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}

Direction unit(Direction const& a)
{
  const double length = std::sqrt(mesh::dot<3>(a, a));
  ASPERITY_ASSERT(length > 0);
  return sum(1 / length, a, 0, a);
}
} // namespace

CoulombPlane CoulombPlane::inPlane(double angle, double rake, double friction)
{
  const Direction along = {std::cos(radians(angle)), std::sin(radians(angle)), 0};
  const Direction z = {0, 0, 1};
  return {cross(along, z), sum(std::cos(radians(rake)), along, std::sin(radians(rake)), z),
          friction};
}

CoulombPlane CoulombPlane::inSpace(double strike, double dip, double rake, double friction,
                                   Direction const& up, Direction const& east)
{
  auto const z = unit(up);
  auto const x = unit(sum(1, east, -mesh::dot<3>(east, z), z));
  auto const y = cross(z, x); // north
  auto const along = sum(std::sin(radians(strike)), x, std::cos(radians(strike)), y);
  auto const right = cross(along, z); // horizontal, to which the plane dips
  auto const up_dip = sum(-std::cos(radians(dip)), right, std::sin(radians(dip)), z);
  auto const into_hanging_wall = sum(std::sin(radians(dip)), right, std::cos(radians(dip)), z);
  return {into_hanging_wall, sum(std::cos(radians(rake)), along, std::sin(radians(rake)), up_dip),
          friction};
}

std::vector<double> CoulombPlane::factors(int displacement_components) const
{
  auto const& names = tensorComponents(displacement_components);
  std::vector<double> factors;
  for (auto const& name : names) {
    const int i = name[0] - 'x', k = name[1] - 'x';
    const double entry = slip[i] * normal[k] + friction * normal[i] * normal[k];
    const double transposed = slip[k] * normal[i] + friction * normal[i] * normal[k];
    factors.push_back(i == k ? entry : entry + transposed);
  }
  return factors;
}

bool CoulombPlane::isLoaded(int displacement_components) const
{
  constexpr double rounding = 1e-12; // of sines and cosines
  auto const all = factors(displacement_components);
  return std::any_of(all.begin(), all.end(), [](double f) { return std::abs(f) > rounding; });
}

std::vector<double> CoulombPlane::stress(std::vector<double> const& tensors,
                                         int displacement_components) const
{
  auto const factors = this->factors(displacement_components);
  std::vector<double> result(tensors.size() / factors.size(), 0.);
  for (std::size_t cell = 0; cell < result.size(); ++cell) {
    for (std::size_t c = 0; c < factors.size(); ++c) {
      result[cell] += factors[c] * tensors[cell * factors.size() + c];
    }
  }
  return result;
}
} // namespace asperity::fem
