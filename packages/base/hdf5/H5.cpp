#include "base/hdf5/H5.hpp"

#include "base/hdf5/detail/H5Calls.hpp"

namespace asperity::h5
{
namespace
{
// Keeps the description of the deepest entry, which is where things went wrong.
herr_t describeError(unsigned, H5E_error2_t const* entry, void* text)
{
  *static_cast<std::string*>(text) = entry->desc ? entry->desc : "";
  return 0;
}

// HDF5 prints its error stack unless told not to.
void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

void writeAttribute(hid_t object, std::string const& name, hid_t type, void const* value,
                    std::string const& what)
{
  const std::string attribute_name = "attribute '" + name + "' of " + what;
  const Handle space = makeSpace({}, {}, attribute_name);
  const Handle attribute(
    H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
    "Creating " + attribute_name);
  check(H5Awrite(attribute.get(), type, value), "Writing " + attribute_name);
}
} // namespace

void fail(std::string const& what)
{
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, describeError, &reason);
  throw Error(what + " failed" + (reason.empty() ? "" : " (HDF5: " + reason + ")") + ".");
}

void check(herr_t status, std::string const& what)
{
  if (status < 0) {
    fail(what);
  }
}

Handle makeSpace(Shape const& shape, Shape const& largest, std::string const& what)
{
  const hid_t space =
    shape.empty() ? H5Screate(H5S_SCALAR)
                  : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), largest.data());
  return Handle(space, H5Sclose, "Making a dataspace for " + what);
}

Handle makeTextType(std::string const& what)
{
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "Making a text type for " + what);
  check(H5Tset_size(type.get(), H5T_VARIABLE), "Sizing text of " + what);
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "Encoding text of " + what);
  return type;
}

Handle makeProperties(hid_t kind, std::string const& what)
{
  return Handle(H5Pcreate(kind), H5Pclose, "Making properties for " + what);
}

Handle::Handle(hid_t id, Close function, std::string const& what) : id_(id), close_(function)
{
  if (id < 0) {
    fail(what);
  }
}

Handle::~Handle()
{
  if (id_ >= 0) {
    close_(id_);
  }
}

void Handle::close(std::string const& what)
{
  if (id_ >= 0) {
    const herr_t status = close_(id_);
    id_ = H5I_INVALID_HID;
    check(status, what);
  }
}

void Object::setAttribute(std::string const& name, std::string const& value)
{
  const Handle type = makeTextType(what_);
  char const* text = value.c_str();
  writeAttribute(handle_.get(), name, type.get(), &text, what_);
}

void Object::setAttribute(std::string const& name, std::int64_t value)
{
  writeAttribute(handle_.get(), name, H5T_NATIVE_INT64, &value, what_);
}

std::string Object::textAttribute(std::string const& name) const
{
  const Handle attribute(H5Aopen(handle_.get(), name.c_str(), H5P_DEFAULT), H5Aclose,
                         "Opening attribute '" + name + "' of " + what_);
  const Handle type = makeTextType(what_);
  char* text = nullptr;
  check(H5Aread(attribute.get(), type.get(), &text),
        "Reading attribute '" + name + "' of " + what_);
  const std::string value = text ? text : "";
  H5free_memory(text);
  return value;
}

std::int64_t Object::integerAttribute(std::string const& name) const
{
  const Handle attribute(H5Aopen(handle_.get(), name.c_str(), H5P_DEFAULT), H5Aclose,
                         "Opening attribute '" + name + "' of " + what_);
  std::int64_t value = 0;
  check(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value),
        "Reading attribute '" + name + "' of " + what_);
  return value;
}

bool Group::has(std::string const& path) const
{
  // HDF5 asks that every group on the way exists.
  for (auto end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1)) {
    if (H5Lexists(handle_.get(), path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) {
      return false;
    }
  }
  return H5Lexists(handle_.get(), path.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Group::names() const
{
  const auto collect = [](hid_t, char const* name, H5L_info_t const*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
  };
  std::vector<std::string> names;
  check(H5Literate(handle_.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names),
        "Listing " + what_);
  return names;
}

bool Group::isGroup(std::string const& path) const
{
  const Handle object(H5Oopen(handle_.get(), path.c_str(), H5P_DEFAULT), H5Oclose,
                      "Opening " + describe(path));
  return H5Iget_type(object.get()) == H5I_GROUP;
}

void Group::link(std::string const& path, std::string const& file)
{
  check(H5Lcreate_external(file.c_str(), ("/" + path).c_str(), handle_.get(), path.c_str(),
                           H5P_DEFAULT, H5P_DEFAULT),
        "Linking " + what_ + ": " + path + " to " + file);
}

File File::create(std::filesystem::path const& path)
{
  silence();
  return File(Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                     "Creating " + path.string()),
              path.string());
}

File File::open(std::filesystem::path const& path)
{
  silence();
  return File(Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                     "Opening " + path.string()),
              path.string());
}

File File::openShared(std::filesystem::path const& path, MPI_Comm comm)
{
  silence();
  const Handle access = makeProperties(H5P_FILE_ACCESS, path.string());
  int num_ranks = 1;
  MPI_Comm_size(comm, &num_ranks);
  if (num_ranks > 1) { // a single rank needs no MPI-IO, which some file systems lack
    check(H5Pset_fapl_mpio(access.get(), comm, MPI_INFO_NULL), "Sharing " + path.string());
  }
  return File(
    Handle(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()), H5Fclose, "Opening " + path.string()),
    path.string());
}

void File::flush() { check(H5Fflush(handle_.get(), H5F_SCOPE_LOCAL), "Writing " + what_); }

void File::close() { handle_.close("Closing " + what_); }
} // namespace asperity::h5
