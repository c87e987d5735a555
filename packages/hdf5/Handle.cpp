#include "hdf5/Handle.hpp"

#include "base/program/MpiScope.hpp"
#include "hdf5/detail/Calls.hpp"

#include <algorithm>
#include <cctype>

namespace asperity::h5
{
namespace
{
// A damaged file may have any bytes in its names.
std::string withoutControlCharacters(std::string message)
{
  std::replace_if(
    message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return message;
}

// Keeps the description of the deepest entry, where the error occurred.
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
  // For a failed system call HDF5 gives time, address and more; the system's own message is enough.
  const std::string words = "error message = '";
  if (const auto begin = reason.find(words); begin != std::string::npos) {
    reason = reason.substr(begin + words.size());
    reason = reason.substr(0, reason.find('\''));
    throw Error(withoutControlCharacters(what + " failed: " + reason + "."));
  }
  throw Error(withoutControlCharacters(what + " failed" +
                                       (reason.empty() ? "" : " (HDF5: " + reason + ")") + "."));
}

Silence::Silence()
{
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Silence::~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

Handle::~Handle()
{
  if (id_ < 0) {
    return;
  }
  const Silence silence;
  if (close_(id_) < 0) {
    noteUnclosedHdf5();
  }
}

void Handle::close(std::string const& what)
{
  if (id_ >= 0) {
    const hid_t id = std::exchange(id_, hid_t(H5I_INVALID_HID));
    checked(what, [&] {
      const herr_t result = close_(id);
      if (result < 0) {
        noteUnclosedHdf5();
      }
      return result;
    });
  }
}
} // namespace asperity::h5
