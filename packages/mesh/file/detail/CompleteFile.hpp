#pragma once

#include "hdf5/File.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// Makes a mesh file that is complete if it exists: write(file) fills it under another name, and
// then it is renamed. InputError, which names the file and contains the reason, if it cannot be
// made or renamed, or if a name of a boundary cannot be that of a group; OutputError if it could be
// created but not completed, as on a full disk.
void writeCompletely(std::string const& file_name, std::vector<std::string> const& boundaries,
                     std::function<void(h5::File& file)> const& write);

// Stores numbers, or rows of numbers.
template <class Number>
void store(h5::File& file, std::string const& path, std::vector<Number> const& numbers)
{
  file.store(path, numbers.data(), {numbers.size()});
}
template <class Number, std::size_t N>
void store(h5::File& file, std::string const& path, std::vector<std::array<Number, N>> const& rows)
{
  file.store(path, rows.empty() ? nullptr : rows.front().data(), {rows.size(), N});
}
} // namespace asperity::mesh::detail
