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
// one of either per region or, on faults, per fault, or an HDF5 dataset "file.h5:/dataset" with one
// value per global vertex.
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
  //
  // fault_names: those of the faults on which the field lives. Its list may then name every one of
  // them (part = index) instead of the regions. A list whose names are all regions is one of
  // regions.
  Field(ParameterList const& list, std::string const& name, std::string const& path,
        std::vector<std::string> const& region_names, std::vector<bool> const& used = {},
        std::vector<std::string> const& fault_names = {});

  static Field constant(double value);

  // x in m, t in s; `part` is a region as in region_names, or a fault if isPerFault(), of no
  // meaning unless the field is given by a list. InputError with path, value and position if the
  // value is not finite or outside the declared range, and for datasets.
  double operator()(std::array<double, 3> const& x, double t, int part) const
  {
    const double all = 1;
    return (*this)(x, t, part, {&x, &all, 1});
  }
  // With means over the patch.
  double operator()(std::array<double, 3> const& x, double t, int of_part,
                    Expression::Patch const& patch) const
  {
    if (parts_.empty()) {
      refuseDataset();
    }
    Part const& part = parts_[parts_.size() == 1 ? 0 : static_cast<std::size_t>(of_part)];
    return part.expression ? evaluate(part, x, t, patch) : part.value;
  }

  // The values of the vertices with these global ids. Only for datasets. Each rank reads its own
  // values. InputError unless the dataset has num_vertices values.
  std::vector<double> values(std::vector<long long> const& global_ids,
                             long long num_vertices) const;

  bool isDataset() const { return dataset_ != nullptr; }
  bool isPerFault() const { return is_per_fault_; } // whether its list names faults

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
  void readFaults(ParameterList const& faults, std::vector<std::string> const& fault_names);
  double evaluate(Part const& part, std::array<double, 3> const& x, double t,
                  Expression::Patch const& patch) const;
  [[noreturn]] void refuseDataset() const;

  std::string path_;
  Range range_ = Range::any();
  std::string hint_, unit_;
  Expression::Tables tables_;
  std::vector<Part> parts_; // one, or one per region or fault; none for a dataset
  bool is_per_fault_ = false;
  std::shared_ptr<const VertexDataset> dataset_;
};

// The index of the region among those of the mesh. InputError, with `path` of the entry that names
// it, if there is none.
std::size_t regionOf(std::string const& name, std::string const& path,
                     std::vector<std::string> const& region_names);
} // namespace asperity
