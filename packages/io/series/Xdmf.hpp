#pragma once

#include "io/series/SeriesLayout.hpp"

#include <cstdint>

namespace asperity::io::detail
{
// Removes DIR/<name>.xdmf of an earlier run. All functions are called on rank 0 only.
void removeXdmf(SeriesLayout const& layout);

// Adds the rows of a closed segment at the end of DIR/<name>.xdmf, which the first row makes.
// times(num_rows): the times of its rows [s].
// Elements that reach across a period are left out: they would be drawn right through the body.
void appendToXdmf(SeriesLayout const& layout, GeometryFile const& geometry, std::size_t segment,
                  double const* times, std::int64_t num_rows);

// Writes segments/<name>_<nnnnnn>_rows.h5, where each attribute of the XDMF file has a dataset
// <attribute>/<row> of its own. It has no numbers: its virtual datasets show parts of the segment.
// Not every reader of XDMF can take a part of a dataset.
void writeXdmfRows(SeriesLayout const& layout, GeometryFile const& geometry, std::size_t segment,
                   std::int64_t num_rows);

// The path of that file.
std::filesystem::path xdmfRowsPath(SeriesLayout const& layout, std::size_t segment);
} // namespace asperity::io::detail
