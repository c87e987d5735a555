#pragma once

#include "parameters/Parameters.hpp"
#include "parameters/fields/Expression.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace asperity
{
class VertexDataset;

// A quantity in space and time as decks give it: a number, an expression in x, y, z, t (muParser),
// one of either per region, or an HDF5 dataset "file.h5:/dataset" with one value per global vertex.
// A copy shares the parsed expressions: evaluate from one host thread at a time.
class Field
{
public:
  // Reads the entry `name` of a list completed by completeAndValidate, whose declaration gives the
  // range; `path` is where that list stands. A per-region list names every region of region_names
  // (region = index) and no other. InputError otherwise, for an expression that muParser refuses,
  // for a table in another unit than the field, and for a dataset not found. used: (num regions)
  // false where the field is never evaluated, so that a list need not name the region; empty if it
  // is used in all.
  Field(ParameterList const& list, std::string const& name, std::string const& path,
        std::vector<std::string> const& region_names, std::vector<bool> const& used = {});

  static Field constant(double value);

  // x in m, t in s; `region` as in region_names, of no meaning unless the field is given per
  // region. InputError with path, value and position if the value is not finite or outside the
  // declared range, and for datasets.
  double operator()(std::array<double, 3> const& x, double t, int region) const
  {
    const double all = 1;
    return (*this)(x, t, region, {&x, &all, 1});
  }
  // With means over the patch.
  double operator()(std::array<double, 3> const& x, double t, int region,
                    Expression::Patch const& patch) const
  {
    if (parts_.empty()) {
      refuseDataset();
    }
    Part const& part = parts_[parts_.size() == 1 ? 0 : static_cast<std::size_t>(region)];
    return part.expression ? evaluate(part, x, t, patch) : part.value;
  }

  // The values of the vertices with these global ids. Only for datasets. Each rank reads its own
  // values. InputError unless the dataset has num_vertices values.
  std::vector<double> values(std::vector<long long> const& global_ids,
                             long long num_vertices) const;

  bool isDataset() const { return dataset_ != nullptr; }

  bool takesMeans() const;
  bool dependsOnTime() const;

private:
  // A number, or an expression where there is one.
  struct Part
  {
    double value = 0.0;
    std::shared_ptr<const Expression> expression;
    std::string path;
  };

  Field() = default;
  Part makePart(Teuchos::ParameterEntry const& entry, std::string const& path) const;
  void readRegions(ParameterList const& regions, std::vector<std::string> const& region_names,
                   std::vector<bool> const& used);
  double evaluate(Part const& part, std::array<double, 3> const& x, double t,
                  Expression::Patch const& patch) const;
  [[noreturn]] void refuseDataset() const;

  std::string path_;
  Range range_ = Range::any();
  std::string hint_, unit_;
  Expression::Tables tables_;
  std::vector<Part> parts_; // one, or one per region; none for a dataset
  std::shared_ptr<const VertexDataset> dataset_;
};

// The index of the region among those of the mesh. InputError, with `path` of the entry that names
// it, if there is none.
std::size_t regionOf(std::string const& name, std::string const& path,
                     std::vector<std::string> const& region_names);
} // namespace asperity
