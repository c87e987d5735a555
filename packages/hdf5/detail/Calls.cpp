#include "hdf5/detail/Calls.hpp"

namespace asperity::h5
{
hid_t native(Type type)
{
  switch (type) {
  case Type::int8: return H5T_NATIVE_INT8;
  case Type::int32: return H5T_NATIVE_INT32;
  case Type::int64: return H5T_NATIVE_INT64;
  case Type::uint64: return H5T_NATIVE_UINT64;
  case Type::float32: return H5T_NATIVE_FLOAT;
  case Type::float64: break;
  }
  return H5T_NATIVE_DOUBLE;
}

Handle makeSpace(Shape const& shape, Shape const& largest, std::string const& what)
{
  return opened("Making a dataspace for " + what, H5Sclose, [&] {
    return shape.empty()
             ? H5Screate(H5S_SCALAR)
             : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), largest.data());
  });
}

Handle makeProperties(hid_t kind, std::string const& what)
{
  return opened("Making properties for " + what, H5Pclose, [&] { return H5Pcreate(kind); });
}

ValueClass valueClassOf(hid_t type, std::string const& what)
{
  switch (checked("Asking the type of " + what, [&] { return H5Tget_class(type); })) {
  case H5T_INTEGER: return ValueClass::integer;
  case H5T_FLOAT: return ValueClass::real;
  case H5T_STRING: return ValueClass::text;
  default: return ValueClass::other;
  }
}

Shape shapeOf(Handle const& space, std::string const& what)
{
  const std::string asking = "Asking the shape of " + what;
  const int num_dimensions =
    checked(asking, [&] { return H5Sget_simple_extent_ndims(space.get()); });
  Shape shape(static_cast<std::size_t>(num_dimensions));
  checked(asking, [&] { return H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr); });
  return shape;
}
} // namespace asperity::h5
