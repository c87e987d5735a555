#include "base/hdf5/Group.hpp"

#include "base/hdf5/detail/Calls.hpp"
#include "base/hdf5/detail/Texts.hpp"

namespace asperity::h5
{
namespace
{
Handle parentsAreMade(std::string const& what)
{
  Handle properties = makeProperties(H5P_LINK_CREATE, what);
  checked("Making groups for " + what,
          [&] { return H5Pset_create_intermediate_group(properties.get(), 1); });
  return properties;
}
} // namespace

// HDF5 asks that every group on the way exists.
bool Group::has(std::string const& path) const
{
  const Silence silence;
  for (auto end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(handle_.get(), path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) {
      return false;
    }
    if (end == std::string::npos) {
      return H5Oexists_by_name(handle_.get(), path.c_str(), H5P_DEFAULT) > 0;
    }
  }
}

std::vector<std::string> Group::names() const
{
  const auto collect = [](hid_t, char const* name, H5L_info_t const*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
  };
  std::vector<std::string> names;
  checked("Listing " + what_, [&] {
    return H5Literate(handle_.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names);
  });
  return names;
}

H5I_type_t Group::objectType(std::string const& path) const
{
  const Handle object = opened("Opening " + describe(path), H5Oclose,
                               [&] { return H5Oopen(handle_.get(), path.c_str(), H5P_DEFAULT); });
  return H5Iget_type(object.get());
}

bool Group::isGroup(std::string const& path) const { return objectType(path) == H5I_GROUP; }

bool Group::isDataset(std::string const& path) const { return objectType(path) == H5I_DATASET; }

Group Group::createGroup(std::string const& path)
{
  const Handle links = parentsAreMade(describe(path));
  return Group(opened("Creating " + describe(path), H5Gclose,
                      [&] {
                        return H5Gcreate2(handle_.get(), path.c_str(), links.get(), H5P_DEFAULT,
                                          H5P_DEFAULT);
                      }),
               describe(path));
}

Group Group::openGroup(std::string const& path) const
{
  return Group(opened("Opening " + describe(path), H5Gclose,
                      [&] { return H5Gopen2(handle_.get(), path.c_str(), H5P_DEFAULT); }),
               describe(path));
}

Dataset Group::openDataset(std::string const& path) const
{
  return Dataset(opened("Opening " + describe(path), H5Dclose,
                        [&] { return H5Dopen2(handle_.get(), path.c_str(), H5P_DEFAULT); }),
                 describe(path));
}

Dataset Group::createWith(std::string const& path, hid_t type, Handle const& space,
                          Handle const& properties)
{
  const Handle links = parentsAreMade(describe(path));
  return Dataset(opened("Creating " + describe(path), H5Dclose,
                        [&] {
                          return H5Dcreate2(handle_.get(), path.c_str(), type, space.get(),
                                            links.get(), properties.get(), H5P_DEFAULT);
                        }),
                 describe(path));
}

Dataset Group::create(std::string const& path, Type type, Shape const& shape)
{
  return createWith(path, native(type), makeSpace(shape, shape, describe(path)),
                    makeProperties(H5P_DATASET_CREATE, describe(path)));
}

Dataset Group::createTexts(std::string const& path, std::vector<std::string> const& texts,
                           TextLength length)
{
  const std::string what = describe(path);
  const Shape shape{texts.size()};
  const Texts values(texts, length, what);
  Dataset dataset = createWith(path, values.type(), makeSpace(shape, shape, what),
                               makeProperties(H5P_DATASET_CREATE, what));
  checked("Writing " + what, [&] {
    return H5Dwrite(dataset.handle_.get(), values.type(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    values.data());
  });
  return dataset;
}

void Group::link(std::string const& path, std::string const& file)
{
  checked("Linking " + what_ + ": " + path + " to " + file, [&] {
    return H5Lcreate_external(file.c_str(), ("/" + path).c_str(), handle_.get(), path.c_str(),
                              H5P_DEFAULT, H5P_DEFAULT);
  });
}
} // namespace asperity::h5
