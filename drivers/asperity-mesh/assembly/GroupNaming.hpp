#pragma once

#include "assembly/GroupNames.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace asperity::geometry
{
// The names of groups that a file has by number, by name or both: those that the user gives, or
// the file's own, or made from the number.
class GroupNaming
{
public:
  using Maker = std::function<std::string(std::int64_t)>;
  // option: that gives names, as "--names"; what: a group in messages, as "side set".
  GroupNaming(GivenNames const& given, std::string option, std::string what, Maker make);

  // own: the name in the file, "" if there is none.
  std::string nameOf(std::int64_t number, std::string const& own = "");
  std::string nameOf(std::string const& own); // a group without a number

  // After all groups: InputError for a name given to none, a warning for such a number, and
  // remarks on names that were made.
  void finish(std::string const& where) const;

private:
  std::string renamed(std::string const& own);

  GivenNames const& given_;
  std::string option_, what_;
  Maker make_;
  std::map<std::int64_t, std::string> of_number_;
  std::set<std::string> own_names_;
  std::string remarks_;
};

// Names of boundaries that cannot be in a file of Asperity's: "." and those with '/', for which
// others have '_'.
std::string boundaryName(std::string name);
} // namespace asperity::geometry
