#pragma once

#include <array>
#include <vector>

namespace asperity::fem
{
// A plane on which stress is resolved: n is a unit normal of it, s the unit vector along which the
// side to which n points slips. With sigma positive in tension, the Coulomb stress is
//   s . sigma n + friction n . sigma n
// A larger value is nearer to failure. friction is the effective coefficient (King, Stein and Lin
// 1994), which includes the effect of pore pressure.
struct CoulombPlane
{
  std::array<double, 3> normal{};
  std::array<double, 3> slip{};
  double friction = 0;

  // The plane through the mesh's z axis whose direction t has the angle [deg] from +x towards +y.
  // The side on the right of t, seen against +z, slips along cos(rake) t + sin(rake) e_z.
  static CoulombPlane inPlane(double angle, double rake, double friction);

  // Aki and Richards: strike [deg] clockwise from north, seen from above; the plane dips [deg] to
  // the right of the strike, and its hanging wall slips at the rake [deg] from the strike, upwards
  // for 0 < rake < 180. up and east need not have unit length; only the horizontal part of east is
  // used, which must not vanish.
  static CoulombPlane inSpace(double strike, double dip, double rake, double friction,
                              std::array<double, 3> const& up, std::array<double, 3> const& east);

  // (num_cells) the Coulomb stress [Pa] of stress tensors (num_cells, tensor components [Pa]) in
  // the order of tensorComponents(displacement_components).
  std::vector<double> stress(std::vector<double> const& tensors, int displacement_components) const;

  // Whether any such tensor has a Coulomb stress on this plane. In antiplane models it has none
  // along a rake of 0 or 180 degrees.
  bool isLoaded(int displacement_components) const;

private:
  std::vector<double> factors(int displacement_components) const; // of the tensor's components
};
} // namespace asperity::fem
