#include "hdf5/detail/Texts.hpp"

#include "hdf5/detail/Calls.hpp"

#include <algorithm>

namespace asperity::h5
{
namespace
{
std::vector<std::string> readVariable(std::size_t count, std::function<void(void*)> const& read)
{
  std::vector<char*> pointers(count, nullptr);
  read(pointers.data());
  std::vector<std::string> texts;
  for (char* pointer : pointers) {
    texts.emplace_back(pointer ? pointer : "");
    H5free_memory(pointer);
  }
  return texts;
}

// Filled up with zeros or blanks.
std::vector<std::string> readFixed(Handle const& type, std::size_t count,
                                   std::function<void(void*)> const& read)
{
  const std::size_t length = H5Tget_size(type.get());
  const char filler = H5Tget_strpad(type.get()) == H5T_STR_SPACEPAD ? ' ' : '\0';
  std::string letters(length * count, '\0');
  read(letters.data());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = letters.substr(i * length, length);
    text = text.substr(0, text.find('\0'));
    text.erase(text.find_last_not_of(filler) + 1);
    texts.push_back(text);
  }
  return texts;
}
} // namespace

Texts::Texts(std::vector<std::string> const& values, TextLength length, std::string const& what)
    : type_(opened("Making a text type for " + what, H5Tclose, [] { return H5Tcopy(H5T_C_S1); }))
{
  const bool is_fixed = length == TextLength::fixed;
  std::size_t longest = 1; // HDF5 has no texts of length 0
  for (auto const& value : values) {
    pointers_.push_back(value.c_str());
    longest = std::max(longest, value.size());
  }
  if (is_fixed) {
    for (auto const& value : values) {
      letters_ += value + std::string(longest - value.size(), '\0');
    }
    checked("Padding text of " + what, [&] { return H5Tset_strpad(type_.get(), H5T_STR_NULLPAD); });
  }
  checked("Sizing text of " + what,
          [&] { return H5Tset_size(type_.get(), is_fixed ? longest : H5T_VARIABLE); });
  checked("Encoding text of " + what, [&] { return H5Tset_cset(type_.get(), H5T_CSET_UTF8); });
}

std::vector<std::string> readTexts(Handle const& type, std::size_t count, std::string const& what,
                                   std::function<void(void*)> const& read)
{
  const bool is_variable =
    checked("Asking the type of " + what, [&] { return H5Tis_variable_str(type.get()); }) > 0;
  return is_variable ? readVariable(count, read) : readFixed(type, count, read);
}
} // namespace asperity::h5
