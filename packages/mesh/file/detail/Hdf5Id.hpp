#pragma once

#include <hdf5.h>

#include <cstdint>

namespace asperity::mesh::detail
{
// Closes an HDF5 id at the end of its life.
class Hdf5Id
{
public:
  Hdf5Id(hid_t id, herr_t (*function)(hid_t)) : id_(id), close_(function) {}
  ~Hdf5Id() { close(); }
  Hdf5Id(Hdf5Id const&) = delete;
  Hdf5Id& operator=(Hdf5Id const&) = delete;

  operator hid_t() const { return id_; }
  bool isValid() const { return id_ >= 0; }

  // True if there is nothing to close, or closing succeeds.
  bool close()
  {
    const hid_t id = id_;
    id_ = H5I_INVALID_HID;
    return id < 0 || close_(id) >= 0;
  }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// HDF5's name of a type, as it lies in memory.
inline hid_t nativeType(double) { return H5T_NATIVE_DOUBLE; }
inline hid_t nativeType(int) { return H5T_NATIVE_INT; }
inline hid_t nativeType(long long) { return H5T_NATIVE_LLONG; }
inline hid_t nativeType(std::uint64_t) { return H5T_NATIVE_UINT64; }

// HDF5 prints its own stack of errors; ours say what the user needs. Silent as long as this lives.
class Hdf5Silence
{
public:
  Hdf5Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Hdf5Silence(Hdf5Silence const&) = delete;
  Hdf5Silence& operator=(Hdf5Silence const&) = delete;

private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};
} // namespace asperity::mesh::detail
