#include "gmsh/GmshGroups.hpp"

#include "gmsh/GmshSession.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <gmsh.h>

#include <algorithm>
#include <map>
#include <set>

namespace asperity::geometry
{
namespace model = gmsh::model;

namespace
{
std::string list(std::vector<std::string> const& words)
{
  std::string text;
  for (auto const& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text.empty() ? "none" : text;
}

// The groups of one dimension under their names.
class Naming
{
public:
  Naming(int dimension, bool of_cells, GivenNames const& given, PhysicalGroups& result,
         std::string const& where)
      : dimension_(dimension)
      , of_cells_(of_cells)
      , given_(given)
      , result_(result)
      , where_(where)
  {
  }

  std::vector<Group> run()
  {
    gmsh::vectorpair tags;
    model::getPhysicalGroups(tags, dimension_);
    ASPERITY_REQUIRE(!tags.empty(), where_ << " has no physical " << entityName(dimension_)
                                           << ", from which "
                                           << (of_cells_ ? "regions" : "boundaries and faults")
                                           << " come: Physical " << entityName(dimension_)
                                           << "(\"name\") = {...};");
    std::vector<Group> groups;
    for (auto const& [dim, tag] : tags) {
      groups.push_back({nameOf(tag), {}});
      model::getEntitiesForPhysicalGroup(dim, tag, groups.back().entities);
      numbers_.push_back(std::to_string(tag));
    }
    requireNamesThatDiffer(groups);
    for (auto const& [own, name] : given_.by_name) {
      requireKnownName(option(), own, own_names_, where_);
    }
    warnOfUnused();
    return groups;
  }

private:
  std::string nameOf(int tag)
  {
    const auto given = given_.by_number.find(tag);
    std::string name;
    model::getPhysicalName(dimension_, tag, name);
    const auto renamed = given_.by_name.find(name);
    own_names_.push_back(name);
    if (given != given_.by_number.end()) {
      name = given->second;
    } else if (renamed != given_.by_name.end()) {
      name = renamed->second;
    } else if (trimmed(name).empty()) {
      name = (of_cells_ ? "region_" : "boundary_") + std::to_string(tag);
      made_.insert(name);
      result_.remarks.push_back("physical " + std::string(entityName(dimension_)) + " " +
                                std::to_string(tag) + " has no name and is called '" + name +
                                "'; " + option() + " " + std::to_string(tag) +
                                "=NAME gives another one");
    }
    ASPERITY_REQUIRE(of_cells_ || (name != "." && name.find('/') == std::string::npos),
                     where_ << ": '" << name << "' cannot be the name of a boundary, which is not "
                            << "'.' and contains no '/'. Give another one: " << option() << " "
                            << tag << "=NAME.");
    return name;
  }

  // Two groups may be given one name, and are one boundary then. A name made here is of one group.
  void requireNamesThatDiffer(std::vector<Group> const& groups) const
  {
    std::set<std::string> known;
    for (auto const& group : groups) {
      ASPERITY_REQUIRE(known.insert(group.name).second || made_.count(group.name) == 0,
                       where_ << ": one physical " << entityName(dimension_) << " is called '"
                              << group.name << "', and another one without a name would be. Give "
                              << "it one: " << option() << " NUMBER=NAME.");
    }
  }

  void warnOfUnused() const
  {
    for (auto const& [tag, name] : given_.by_number) {
      const auto number = std::to_string(tag);
      if (std::find(numbers_.begin(), numbers_.end(), number) == numbers_.end()) {
        result_.warnings.push_back("Option " + std::string(option()) + " " + number + "=" + name +
                                   " names nothing: " + where_ + " has no physical " +
                                   entityName(dimension_) + " " + number + ", only " +
                                   list(numbers_) + ".");
      }
    }
  }

  char const* option() const { return of_cells_ ? regions_option : boundaries_option; }

  int dimension_;
  bool of_cells_;
  GivenNames const& given_;
  PhysicalGroups& result_;
  std::string const& where_;
  std::vector<std::string> numbers_, own_names_;
  std::set<std::string> made_; // names
};

void requireOneRegion(std::vector<Group> const& regions, int dimension, std::string const& where)
{
  std::map<int, std::string> region_of_entity;
  for (auto const& group : regions) {
    for (int entity : group.entities) {
      const auto known = region_of_entity.emplace(entity, group.name).first;
      ASPERITY_REQUIRE(known->second == group.name, where << ": " << entityName(dimension) << " "
                                                          << entity << " is in two regions, '"
                                                          << known->second << "' and '"
                                                          << group.name << "'.");
    }
  }
}

std::vector<std::string> namesOf(std::vector<Group> const& groups)
{
  std::vector<std::string> names;
  for (auto const& group : groups) {
    names.push_back(group.name);
  }
  return names;
}

void leaveOut(std::set<std::string> const& without, PhysicalGroups& groups,
              std::string const& where)
{
  requireBoundaries(without, namesOf(groups.boundaries), namesOf(groups.regions), where);
  auto& kept = groups.boundaries;
  kept.erase(std::remove_if(kept.begin(), kept.end(),
                            [&](Group const& group) { return without.count(group.name) > 0; }),
             kept.end());
}
} // namespace

PhysicalGroups physicalGroups(int dimension, GroupNames const& names, std::string const& where)
{
  PhysicalGroups groups;
  groups.regions = Naming(dimension, true, names.regions, groups, where).run();
  groups.boundaries = Naming(dimension - 1, false, names.boundaries, groups, where).run();
  requireOneRegion(groups.regions, dimension, where);
  leaveOut(names.without, groups, where);
  return groups;
}
} // namespace asperity::geometry
