#pragma once

#include "base/Errors.hpp"

#include <hdf5.h>

#include <string>
#include <utility>

namespace asperity::h5
{
// What HDF5 was asked to do, with the file, and its own description of what went wrong.
class Error : public OutputError
{
public:
  using OutputError::OutputError;
};

// Whether HDF5 holds something that it could not close, for example because the disk is full. Its
// own end, in MPI_Finalize and at the exit of the program, would then try again and crash.
bool holdsUnclosed();
void noteUnclosed();

// HDF5 prints its stack of errors unless told not to; our messages say what a user needs. It is
// silent as long as this lives, and afterwards does what it did before.
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
  // Afterwards it is closed by close() alone: where closing is collective, a rank that has failed
  // would wait for others that have not.
  void closeOnlyOnDemand() { only_on_demand_ = true; }
  void close(std::string const& what); // Error if that fails, for example on a full disk

private:
  void swap(Handle& other) noexcept
  {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    std::swap(only_on_demand_, other.only_on_demand_);
  }

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
  bool only_on_demand_ = false;
};
} // namespace asperity::h5
