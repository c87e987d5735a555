#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/Curves.hpp"
#include "arrangement/complex/Patches.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
// The arranged surfaces as a model in Gmsh: points, curves and surfaces with tags 1, 2, ... in the
// order here, and the volume between them. InputError if a patch is closed or has a handle;
// exceptions of Gmsh are not caught.
class DiscreteModel
{
public:
  DiscreteModel(Complex const& complex, Model const& named_model);

  // Adds the entities to the current model of Gmsh.
  void build();
  // The width 1.5 area / perimeter [m] of patches and of the curves around them, by dimension and
  // tag.
  std::map<std::pair<int, int>, double> widths() const;
  // Tags of patches.
  std::map<std::string, std::vector<int>> surfacesByName() const;

private:
  void addNodes(int dimension, int entity, std::vector<int> const& points);
  void addCorners();
  void addCurves();
  void addPatch(int p);
  void requireNoHandle(int num_points, int num_edges, int p, std::string const& name,
                       std::string const& place) const;
  void addElements() const;
  void addVolume();
  void embed() const;

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
} // namespace asperity::geometry
