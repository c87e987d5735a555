#include "scenario/setup/conditions/ConditionTypes.hpp"

#include "base/Errors.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/FaultConditions.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>
#include <map>

namespace asperity::scenario
{
namespace
{
constexpr char const* prescribed_slip_rate = "Prescribed Slip Rate";
constexpr char const* unilateral = "Unilateral"; // a word of `Contact`

ConditionType faultType(std::string const& name, FaultKind const& kind)
{
  ConditionType type;
  type.name = name;
  type.meaning = kind.meaning;
  type.place = ConditionPlace::fault;
  type.decides_on = DecidesOn::traction;
  type.makers = {addFault<2>, addFault<3>};
  type.other_side = kind.other_side;
  type.reads = {condition_entries::direction, condition_entries::plate_rate,
                condition_entries::slip_rate};
  if (kind.other_side.is_inside) {
    type.reads.emplace_back(condition_entries::contact);
  }
  return type;
}

ConditionType typeOfContinuations()
{
  ConditionType type;
  type.name = prescribed_slip_rate;
  type.meaning =
    "the boundary continues the fault and slips at that rate; where no boundary is a fault of "
    "another Type, it is a fault itself, inside the mesh.";
  type.place = ConditionPlace::continuation;
  type.decides_on = DecidesOn::traction;
  type.makers = {prescribeSlipRate<2>, prescribeSlipRate<3>};
  type.reads = {condition_entries::direction, condition_entries::slip_rate};
  return type;
}

// The registered type under its name. Its entries are known only when all libraries are loaded.
ConditionType typeOnBoundary(std::string const& name)
{
  auto type = BoundaryKindRegistry::instance().at(name);
  type.name = name;
  if (type.declare) {
    Declare own;
    type.declare(own);
    for (auto const& entry : *own.list()) {
      type.reads.push_back(entry.first);
    }
  }
  if (type.reads_direction) {
    type.reads.emplace_back(condition_entries::direction);
  }
  return type;
}

// A type for each kind of fault, then the types for other boundaries.
std::vector<ConditionType> makeTypes()
{
  std::vector<ConditionType> types;
  for (auto const& name : faultKinds()) {
    types.push_back(faultType(name, FaultKindRegistry::instance().at(name)));
  }
  types.push_back(typeOfContinuations());
  for (auto const& name : BoundaryKindRegistry::instance().names()) {
    ASPERITY_REQUIRE(
      std::none_of(types.begin(), types.end(), [&](auto const& type) { return type.name == name; }),
      "The boundary condition '" << name
                                 << "' of a plugin has the name of another Type. "
                                    "Register it under a name of its own.");
    types.push_back(typeOnBoundary(name));
  }
  return types;
}
} // namespace

std::vector<ConditionType> const& conditionTypes()
{
  static const auto types = makeTypes();
  return types;
}

ConditionType const& conditionType(std::string const& name)
{
  auto const& types = conditionTypes();
  auto const found = std::find_if(types.begin(), types.end(),
                                  [&name](auto const& type) { return type.name == name; });
  ASPERITY_ASSERT(found != types.end());
  return *found;
}

bool ConditionType::readsEntry(std::string const& entry) const
{
  return std::find(reads.begin(), reads.end(), entry) != reads.end();
}

ConditionType const& continuationType() { return conditionType(prescribed_slip_rate); }

namespace
{
std::vector<std::string> typeNames()
{
  std::vector<std::string> names;
  for (auto const& type : conditionTypes()) {
    names.push_back(type.name);
  }
  return names;
}

std::string meaningOfType()
{
  std::string text = "Says what holds on the boundary.";
  for (auto const& type : conditionTypes()) {
    text += " " + type.name + ": " + type.meaning;
  }
  return text;
}

struct CommonEntries
{
  std::string boundary, type;
  std::optional<std::vector<double>> direction;
};

// The entries that several types share.
Entries<CommonEntries> commonEntries()
{
  using S = CommonEntries;
  Entries<S> one_condition;
  one_condition
    .text("Boundary", &S::boundary, required,
          "Names the boundary of the mesh on which the condition holds.")
    .choiceOfWords(condition_entries::type, &S::type, required, typeNames(), meaningOfType())
    .realArray(
      condition_entries::direction, &S::direction, optional, "-", Range::any(),
      "Prescribed Velocity: components along the axes that say where the velocity points, of any "
      "length; it points along +x if they are left out, and an antiplane body moves along z "
      "alone. Prescribed Slip Rate, and faults with a Slip Rate or a Plate Rate, in three "
      "dimensions: the slip points along the projection of this vector onto the boundary.")
    .others()
    .choice(
      condition_entries::contact, optional, {"Bilateral", unilateral},
      "Faults inside the mesh: says whether the two sides may part. Bilateral, which it is if "
      "the entry is left out: they do not. Unilateral: the fault opens where the body or the "
      "pressure of a fluid would pull at it, has no friction there, and closes without a "
      "gap; the normal stress has to be Coupled.")
    .field(condition_entries::plate_rate, optional, "m/s", Range::any(),
           "Faults: says how fast the plates slide past each other along the fault (back slip). "
           "Friction and all outputs of slip include this rate in addition to the motion of the "
           "bodies, whose far boundaries are then at rest. It points along the tangent of the "
           "fault's frame, in three dimensions along Direction, and is constant in time.")
    .withoutDatasets()
    .field(condition_entries::slip_rate, optional, "m/s", Range::any(),
           "Prescribed Slip Rate, and faults whose slip is known: says how fast the boundary "
           "slips; in two dimensions along the tangent of the fault's frame, which points along "
           "+x on a fault below the body. A fault with a slip rate has no friction.")
    .withoutDatasets();
  return one_condition;
}
} // namespace

BoundaryCondition::BoundaryCondition(std::string const& path, ParameterList const& completed)
    : name(path)
    , list(completed)
{
  auto const common = commonEntries().read(list, name);
  type = &conditionType(common.type);
  boundary = common.boundary;
  direction = common.direction;
  may_open = isGiven(list, condition_entries::contact) &&
             list.get<std::string>(condition_entries::contact) == unilateral;
}

namespace
{
// Of the registered types, which share one list: no entry may have two meanings.
void addEntriesOfTypes(ParameterList& list)
{
  std::map<std::string, std::string> owners;
  auto const& registry = BoundaryKindRegistry::instance();
  for (auto const& type : registry.names()) {
    auto const& declare = registry.at(type).declare;
    if (!declare) {
      continue;
    }
    Declare own;
    declare(own);
    for (auto const& item : *own.list()) {
      auto const& entry = item.first;
      auto const owner = owners.find(entry);
      ASPERITY_REQUIRE(!list.isParameter(entry),
                       joinPath(joinPath(conditions_path, "<condition>"), entry)
                         << (owner == owners.end()
                               ? " belongs to all types"
                               : " belongs to the boundary condition '" + owner->second + "'")
                         << ", and the boundary condition '" << type
                         << "' declares it again. All types share one list of entries: give it "
                            "another name in the plugin.");
      owners[entry] = type;
      list.setEntry(entry, item.second);
    }
  }
}
} // namespace

RCP<const ParameterList> boundaryParameters()
{
  auto const one = commonEntries().list();
  addEntriesOfTypes(*one);
  return Declare()
    .sublist("<condition>", one, "Describes one boundary condition; choose any name.")
    .list();
}

std::vector<BoundaryCondition> readConditions(ParameterList const& list)
{
  std::vector<BoundaryCondition> conditions;
  for (auto const& entry : list) {
    conditions.emplace_back(joinPath(conditions_path, entry.first), list.sublist(entry.first));
  }
  return conditions;
}

bool haveFriction(ParameterList const& list)
{
  auto const kinds = faultKinds();
  return std::any_of(list.begin(), list.end(), [&](auto const& entry) {
    if (!list.isSublist(entry.first)) {
      return false;
    }
    auto const& condition = list.sublist(entry.first);
    return condition.template isType<std::string>(condition_entries::type) &&
           !isGiven(condition, condition_entries::slip_rate) &&
           std::find(kinds.begin(), kinds.end(),
                     condition.template get<std::string>(condition_entries::type)) != kinds.end();
  });
}
} // namespace asperity::scenario
