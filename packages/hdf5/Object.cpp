#include "hdf5/Object.hpp"

#include "hdf5/detail/Calls.hpp"
#include "hdf5/detail/Texts.hpp"

#include <functional>
#include <numeric>

namespace asperity::h5
{
namespace
{
std::string describe(std::string const& name, std::string const& what)
{
  return "attribute '" + name + "' of " + what;
}

void writeAttribute(Handle const& object, std::string const& name, hid_t type, Shape const& shape,
                    void const* value, std::string const& what)
{
  const std::string described = describe(name, what);
  const Handle space = makeSpace(shape, shape, described);
  const Handle attribute = opened("Creating " + described, H5Aclose, [&] {
    return H5Acreate2(object.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT);
  });
  checked("Writing " + described, [&] { return H5Awrite(attribute.get(), type, value); });
}

// An existing attribute.
class Attribute
{
public:
  Attribute(Handle const& object, std::string const& name, std::string const& what)
      : what_(describe(name, what))
      , attribute_(opened("Opening " + what_, H5Aclose,
                          [&] { return H5Aopen(object.get(), name.c_str(), H5P_DEFAULT); }))
      , type_(opened("Asking the type of " + what_, H5Tclose,
                     [&] { return H5Aget_type(attribute_.get()); }))
      , space_(opened("Asking the shape of " + what_, H5Sclose,
                      [&] { return H5Aget_space(attribute_.get()); }))
  {
  }

  Handle const& type() const { return type_; }
  ValueClass valueClass() const { return valueClassOf(type_.get(), what_); }

  std::size_t numValues() const
  {
    const Shape shape = shapeOf(space_, what_);
    return std::accumulate(shape.begin(), shape.end(), std::size_t(1), std::multiplies<>());
  }

  void read(hid_t type, void* values) const
  {
    checked("Reading " + what_, [&] { return H5Aread(attribute_.get(), type, values); });
  }

  void require(bool is_fit, std::string const& kind) const
  {
    if (!is_fit) {
      throw Error("The " + what_ + " is not " + kind + ".");
    }
  }

private:
  std::string what_;
  Handle attribute_, type_, space_;
};
} // namespace

void Object::setAttribute(std::string const& name, std::string const& value, TextLength length)
{
  const std::vector<std::string> values{value};
  const Texts text(values, length, describe(name, what_));
  writeAttribute(handle_, name, text.type(), {}, text.data(), what_);
}

void Object::setAttribute(std::string const& name, int value)
{
  writeAttribute(handle_, name, H5T_NATIVE_INT, {}, &value, what_);
}

void Object::setAttribute(std::string const& name, std::int64_t value)
{
  writeAttribute(handle_, name, H5T_NATIVE_INT64, {}, &value, what_);
}

void Object::setAttribute(std::string const& name, std::vector<double> const& values)
{
  writeAttribute(handle_, name, H5T_NATIVE_DOUBLE, {values.size()}, values.data(), what_);
}

bool Object::hasAttribute(std::string const& name) const
{
  const Silence silence;
  return H5Aexists(handle_.get(), name.c_str()) > 0;
}

std::string Object::textAttribute(std::string const& name) const
{
  const Attribute attribute(handle_, name, what_);
  attribute.require(attribute.valueClass() == ValueClass::text && attribute.numValues() == 1,
                    "a text");
  return readTexts(attribute.type(), 1, describe(name, what_),
                   [&](void* values) { attribute.read(attribute.type().get(), values); })[0];
}

std::int64_t Object::integerAttribute(std::string const& name) const
{
  const Attribute attribute(handle_, name, what_);
  attribute.require(attribute.valueClass() == ValueClass::integer && attribute.numValues() == 1,
                    "an integer");
  std::int64_t value = 0;
  attribute.read(H5T_NATIVE_INT64, &value);
  return value;
}

std::vector<double> Object::numbersAttribute(std::string const& name) const
{
  const Attribute attribute(handle_, name, what_);
  const ValueClass value_class = attribute.valueClass();
  attribute.require(value_class == ValueClass::integer || value_class == ValueClass::real,
                    "a list of numbers");
  std::vector<double> values(attribute.numValues());
  attribute.read(H5T_NATIVE_DOUBLE, values.data());
  return values;
}
} // namespace asperity::h5
