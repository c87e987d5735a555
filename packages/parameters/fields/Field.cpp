#include "parameters/fields/Field.hpp"

#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/RangeText.hpp"
#include "parameters/fields/TableFunction.hpp"
#include "parameters/fields/Unit.hpp"
#include "parameters/fields/VertexDataset.hpp"

#include <algorithm>
#include <optional>

namespace asperity
{
namespace
{
// Whether the list names faults in place of regions: not all its names are regions, and one is a
// fault. InputError for a list of both, and for a name that is neither.
bool namesFaults(ParameterList const& list, std::string const& path,
                 std::vector<std::string> const& region_names,
                 std::vector<std::string> const& fault_names)
{
  const auto is_in = [](std::vector<std::string> const& names, std::string const& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  bool has_fault = false, has_region = false;
  for (auto const& name : namesIn(list)) {
    const bool is_region = is_in(region_names, name), is_fault = is_in(fault_names, name);
    if (!fault_names.empty() && !is_region && !is_fault) {
      auto known = region_names;
      known.insert(known.end(), fault_names.begin(), fault_names.end());
      throw InputError(joinPath(path, name) + ": '" + name +
                       "' is neither a region of the mesh nor a fault." + didYouMean(name, known));
    }
    has_region = has_region || !is_fault;
    has_fault = has_fault || !is_region;
  }
  ASPERITY_REQUIRE(fault_names.empty() || !has_region || !has_fault,
                   path << " names regions and faults: " << quotedNames(namesIn(list))
                        << ". Give a value for each region, " << quotedNames(region_names)
                        << ", or for each fault, " << quotedNames(fault_names) << ".");
  return !fault_names.empty() && has_fault;
}

// After the end of a sentence.
std::string nextSentence(std::string const& text) { return text.empty() ? "" : " " + text; }

// nullopt for one that tables cannot have, such as deg.
std::optional<Unit> knownUnit(std::string const& text)
{
  try {
    return Unit(text, "");
  } catch (InputError const&) {
    return std::nullopt;
  }
}

// The unit of a field whose value is that of a table, where the table names one.
void requireUnit(Expression const& expression, std::string const& wanted, std::string const& path)
{
  auto const* table = expression.tableAlone();
  if (!table || table->valueUnit().empty()) {
    return;
  }
  auto const of_field = knownUnit(wanted);
  ASPERITY_REQUIRE(!of_field || of_field->powers() == Unit(table->valueUnit(), path).powers(),
                   path << " = '" << excerpt(expression.text()) << "' is in " << table->valueUnit()
                        << ", as " << table->path() << " says, but "
                        << (of_field->isPureNumber() ? "a number without a unit" : wanted)
                        << " is wanted. Name the right column.");
}
} // namespace

Field Field::constant(double value)
{
  Field field;
  field.parts_.resize(1);
  field.parts_[0].value = value;
  return field;
}

Field::Field(ParameterList const& list, std::string const& name, std::string const& path,
             std::vector<std::string> const& region_names, std::vector<bool> const& used,
             std::vector<std::string> const& fault_names)
    : path_(joinPath(path, name))
{
  ASPERITY_REQUIRE(list.isParameter(name), path_ << " is missing.");
  if (const auto info = parameterInfo(list, name); !info.is_null()) {
    range_ = info->range;
    hint_ = info->hint;
    unit_ = info->unit;
    tables_ = info->tables;
  }
  auto const& entry = list.getEntry(name);
  if (entry.isList()) {
    auto const& parts = get<ParameterList>(entry);
    is_per_fault_ = namesFaults(parts, path_, region_names, fault_names);
    if (is_per_fault_) {
      readFaults(parts, fault_names);
    } else {
      readRegions(parts, region_names, used);
    }
  } else if (holds<std::string>(entry) && VertexDataset::isName(get<std::string>(entry))) {
    dataset_ = std::make_shared<VertexDataset>(get<std::string>(entry), path_);
  } else {
    parts_.push_back(makePart(entry, path_));
  }
}

Field::Part Field::makePart(Teuchos::ParameterEntry const& entry, std::string const& path) const
{
  Part part;
  part.path = path;
  if (holds<std::string>(entry)) {
    part.expression = std::make_shared<Expression>(get<std::string>(entry), path, tables_);
    requireUnit(*part.expression, unit_, path);
    if (!part.expression->dependsOnSpace() && !part.expression->dependsOnTime()) {
      const std::array<double, 3> origin{};
      const double all = 1;
      part.value = evaluate(part, origin, 0, {&origin, &all, 1});
      part.expression.reset();
    }
    return part;
  }
  const auto number = numberIn(entry);
  ASPERITY_REQUIRE(number, path << " = " << valueText(entry) << " is " << typeText(entry)
                                << ", but a number or an expression is wanted.");
  part.value = *number;
  ASPERITY_REQUIRE(range_.contains(part.value), path << " = " << formatNumber(part.value)
                                                     << " is outside " << textOf(range_) << "."
                                                     << nextSentence(hint_));
  return part;
}

void Field::readRegions(ParameterList const& regions, std::vector<std::string> const& region_names,
                        std::vector<bool> const& used)
{
  for (auto const& name : namesIn(regions)) {
    regionOf(name, joinPath(path_, name), region_names);
  }
  parts_.resize(region_names.size());
  for (std::size_t region = 0; region < region_names.size(); ++region) {
    auto const& name = region_names[region];
    const bool is_given = regions.isParameter(name);
    ASPERITY_REQUIRE(is_given || (!used.empty() && !used[region]),
                     path_ << " has no value for the region '" << name
                           << "'. The mesh has the regions " << quotedNames(region_names)
                           << ", the list has " << quotedNames(namesIn(regions)) << ".");
    if (is_given) {
      parts_[region] = makePart(regions.getEntry(name), joinPath(path_, name));
    }
  }
}

void Field::readFaults(ParameterList const& faults, std::vector<std::string> const& fault_names)
{
  for (auto const& name : fault_names) {
    ASPERITY_REQUIRE(faults.isParameter(name),
                     path_ << " has no value for the fault '" << name
                           << "'. The model has the faults " << quotedNames(fault_names)
                           << ", the list has " << quotedNames(namesIn(faults)) << ".");
    parts_.push_back(makePart(faults.getEntry(name), joinPath(path_, name)));
  }
}

std::size_t regionOf(std::string const& name, std::string const& path,
                     std::vector<std::string> const& region_names)
{
  auto const found = std::find(region_names.begin(), region_names.end(), name);
  ASPERITY_REQUIRE(found != region_names.end(),
                   path << ": '" << name << "' is not a region of the mesh."
                        << didYouMean(name, region_names)
                        << " A layer that is thinner than the cells is not in the mesh: "
                           "is the cell size too large?");
  return static_cast<std::size_t>(found - region_names.begin());
}

void Field::refuseDataset() const
{
  throw InputError(path_ + " is a dataset, which has values at vertices only. Give a number, an "
                           "expression, or one of them per region.");
}

double Field::evaluate(Part const& part, std::array<double, 3> const& x, double t,
                       Expression::Patch const& patch) const
{
  const double value = (*part.expression)(x, t, patch);
  ASPERITY_REQUIRE(range_.contains(value),
                   part.path << " = '" << excerpt(part.expression->text()) << "' is "
                             << formatNumber(value) << " at " << placeText(x, t) << ", outside "
                             << textOf(range_) << "." << nextSentence(hint_));
  return value;
}

std::vector<double> Field::values(std::vector<long long> const& global_ids,
                                  long long num_vertices) const
{
  ASPERITY_ASSERT(isDataset());
  auto values = dataset_->read(global_ids, num_vertices);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASPERITY_REQUIRE(range_.contains(values[i]),
                     path_ << " = '" << dataset_->name() << "' is " << formatNumber(values[i])
                           << " at vertex " << global_ids[i] << ", outside " << textOf(range_)
                           << "." << nextSentence(hint_));
  }
  return values;
}

bool Field::takesMeans() const
{
  return std::any_of(parts_.begin(), parts_.end(), [](Part const& part) {
    return part.expression && part.expression->takesMeans();
  });
}

bool Field::dependsOnTime() const
{
  return std::any_of(parts_.begin(), parts_.end(), [](Part const& part) {
    return part.expression && part.expression->dependsOnTime();
  });
}
} // namespace asperity
