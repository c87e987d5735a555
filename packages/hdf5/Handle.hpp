#pragma once

#include "base/Errors.hpp"

#include <hdf5.h>

#include <string>
#include <utility>

namespace asperity::h5
{
// The message has the operation that failed, the file, and HDF5's own description of the error.
class Error : public OutputError
{
public:
  using OutputError::OutputError;
};

// While this object lives, HDF5 does not print its error stack; Asperity's messages say what a user
// needs. The destructor restores the earlier setting.
class Silence
{
public:
  Silence();
  ~Silence();
  Silence(Silence const&) = delete;
  Silence& operator=(Silence const&) = delete;

private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

// Owns an HDF5 identifier.
class Handle
{
public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close function) : id_(id), close_(function) {}
  Handle(Handle&& other) noexcept { swap(other); }
  Handle& operator=(Handle&& other) noexcept
  {
    swap(other);
    return *this;
  }
  ~Handle();

  hid_t get() const { return id_; }
  void close(std::string const& what); // Error if that fails, for example on a full disk

private:
  void swap(Handle& other) noexcept
  {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};
} // namespace asperity::h5
