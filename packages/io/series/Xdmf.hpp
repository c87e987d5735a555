#pragma once

#include "io/series/SeriesLayout.hpp"

#include <cstdint>

namespace asperity::io::detail
{
// Writes DIR/<name>.xdmf without any row. Elements that reach across a period are left out: they
// would be drawn right through the body. Both functions are called on rank 0 only.
void startXdmf(SeriesLayout const& layout, GeometryFile const& geometry);

// Adds the rows of a closed segment at the end. times(num_rows): the times of its rows [s].
void appendToXdmf(SeriesLayout const& layout, GeometryFile const& geometry, std::size_t segment,
                  double const* times, std::int64_t num_rows);
} // namespace asperity::io::detail
