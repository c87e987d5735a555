#include "io/FieldRegistry.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <algorithm>

namespace asperity::io
{
namespace
{
Field const* find(std::deque<Field> const& fields, std::string const& location,
                  std::string const& name)
{
  const auto found = std::find_if(fields.begin(), fields.end(), [&](Field const& field) {
    return field.location == location && field.name == name;
  });
  return found == fields.end() ? nullptr : &*found;
}

Scalar const* find(std::deque<Scalar> const& scalars, std::string const& name)
{
  const auto found = std::find_if(scalars.begin(), scalars.end(),
                                  [&](Scalar const& scalar) { return scalar.name == name; });
  return found == scalars.end() ? nullptr : &*found;
}
} // namespace

void FieldRegistry::add(Field field)
{
  ASPERITY_ASSERT(find(fields_, field.location, field.name) == nullptr);
  fields_.push_back(std::move(field));
}

void FieldRegistry::add(Scalar scalar)
{
  ASPERITY_ASSERT(find(scalars_, scalar.name) == nullptr);
  scalars_.push_back(std::move(scalar));
}

Field const& FieldRegistry::field(std::string const& location, std::string const& name) const
{
  Field const* found = find(fields_, location, name);
  ASPERITY_REQUIRE(found, "There is no field '" << name << "' on the " << location << "."
                                                << didYouMean(name, fieldNames(location)));
  return *found;
}

Scalar const& FieldRegistry::scalar(std::string const& name) const
{
  Scalar const* found = find(scalars_, name);
  ASPERITY_REQUIRE(found, "There is no quantity '" << name << "' of a step."
                                                   << didYouMean(name, scalarNames()));
  return *found;
}

std::vector<Field const*> FieldRegistry::fields(std::string const& location,
                                                std::vector<std::string> const& names,
                                                std::string const& where) const
{
  std::vector<Field const*> chosen;
  for (auto const& name : names) {
    Field const& next = field(location, name);
    ASPERITY_REQUIRE(std::find(chosen.begin(), chosen.end(), &next) == chosen.end(),
                     where << " names '" << name << "' twice.");
    chosen.push_back(&next);
  }
  return chosen;
}

bool FieldRegistry::hasField(std::string const& location, std::string const& name) const
{
  return find(fields_, location, name) != nullptr;
}

std::vector<std::string> FieldRegistry::fieldNames(std::string const& location) const
{
  std::vector<std::string> names;
  for (auto const& field : fields_) {
    if (field.location == location) {
      names.push_back(field.name);
    }
  }
  return names;
}

std::vector<std::string> FieldRegistry::scalarNames() const
{
  std::vector<std::string> names;
  for (auto const& scalar : scalars_) {
    names.push_back(scalar.name);
  }
  return names;
}
} // namespace asperity::io
