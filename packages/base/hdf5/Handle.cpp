#include "base/hdf5/Handle.hpp"

#include "base/hdf5/detail/Calls.hpp"

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
} // namespace

void fail(std::string const& what)
{
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, describeError, &reason);
  throw Error(what + " failed" + (reason.empty() ? "" : " (HDF5: " + reason + ")") + ".");
}

Silence::Silence()
{
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Silence::~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

Handle::~Handle()
{
  if (id_ >= 0) {
    const Silence silence;
    close_(id_);
  }
}

void Handle::close(std::string const& what)
{
  if (id_ >= 0) {
    const hid_t id = std::exchange(id_, hid_t(H5I_INVALID_HID));
    checked(what, [&] { return close_(id); });
  }
}
} // namespace asperity::h5
