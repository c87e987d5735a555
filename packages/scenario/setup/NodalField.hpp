#pragma once

#include "base/Text.hpp"
#include "mesh/Mesh.hpp"
#include "parameters/fields/Field.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace asperity::scenario
{
// The points around nodes from which mean(f) is computed.
struct FieldSamples
{
  std::vector<std::array<double, 3>> places; // [m], those of one node side by side
  std::vector<double> weights;               // of the points; those of a node sum to 1
  std::vector<std::size_t> end; // (num_nodes) one past the index of the last point of the node

  Expression::Patch around(std::size_t node) const;
};

// Some local vertices of a mesh, at which fields of a deck are evaluated.
struct FieldNodes
{
  template <int Dim>
  FieldNodes(Mesh<Dim> const& mesh, std::vector<int> const& vertices);

  std::string text(std::size_t node) const; // "(0.5, -1)", for messages

  int dimension;                         // of space
  std::vector<std::string> region_names; // of the mesh
  long long num_global_vertices;
  std::vector<std::array<double, 3>> places; // (num_nodes) [m] as expressions see them
  std::vector<int> regions;                  // (num_nodes) of the first cell that has the vertex
  std::vector<long long> ids;                // (num_nodes) global ones
  std::vector<std::string> fault_names = {}; // if the nodes are those of faults
  std::vector<int> faults = {};              // (num_nodes) with fault_names: that of each node
  // Makes the points for mean(f) in expressions. If it is empty, mean(f) is f at the nodes.
  std::function<std::shared_ptr<const FieldSamples>()> samples = {};
};

// The values of a field at nodes.
class NodalField
{
public:
  NodalField(Field field, FieldNodes const& nodes);
  // The entry `name` of the list that stands at `path`, see Field.
  NodalField(ParameterList const& list, std::string const& name, std::string const& path,
             FieldNodes const& nodes);

  bool dependsOnTime() const { return field_.dependsOnTime(); }
  // (num_nodes) values at the time t [s]. InputError outside the declared range.
  std::vector<double> at(double t) const;

private:
  Field field_;
  std::vector<std::array<double, 3>> places_;
  std::vector<int> parts_; // of the nodes: regions or faults, whichever the field's list names
  std::shared_ptr<const FieldSamples> samples_; // null: no means
  std::vector<double> values_;                  // of a dataset
};

// The values of a field that does not change in time, (num_nodes). Throws InputError if it depends
// on time.
std::vector<double> nodalValues(ParameterList const& list, std::string const& name,
                                std::string const& path, FieldNodes const& nodes);

// A field that is evaluated once, at time zero. Throws InputError if it depends on time.
// region_names: the regions of the mesh; used, fault_names: as Field has them.
Field steadyField(ParameterList const& list, std::string const& name, std::string const& path,
                  std::vector<std::string> const& region_names, std::vector<bool> const& used = {},
                  std::vector<std::string> const& fault_names = {});

// A point as expressions see it: z is 0 in the plane.
template <int Dim>
std::array<double, 3> inSpace(Point<Dim> const& x)
{
  return {x[0], x[1], Dim == 3 ? x[Dim - 1] : 0};
}

// A local cell of a mesh, with its centroid [m] as expressions see it, and its region.
struct CellPlace
{
  int cell;
  std::array<double, 3> centroid;
  int region;
};

// The values in cells of a field that does not change in time: at the centroids, or of a dataset
// the means over the vertices.
class CellField
{
public:
  explicit CellField(Field field) : field_(std::move(field)) {}

  // Reads the values of a dataset, and does nothing for another field. Call it before the first
  // value is taken. InputError, maybe on one rank alone.
  template <int Dim>
  void read(Mesh<Dim> const& mesh);

  // InputError outside the declared range.
  double operator()(CellPlace const& place) const
  {
    return field_.isDataset() ? means_[place.cell] : field_(place.centroid, 0, place.region);
  }

private:
  Field field_;
  std::vector<double> means_; // (num local cells) of a dataset
};
} // namespace asperity::scenario
