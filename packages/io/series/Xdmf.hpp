#pragma once

#include "io/series/SeriesLayout.hpp"

#include <cstdint>

namespace asperity::io::detail
{
// DIR/<name>.xdmf without any row. Elements that reach across a period are left out: they would be
// drawn right through the body. On rank 0, like the next one.
void startXdmf(SeriesLayout const& layout, GeometryFile const& geometry);

// Adds the rows of a closed segment at the end; times: of its num_rows rows [s].
void appendToXdmf(SeriesLayout const& layout, std::size_t segment, double const* times,
                  std::int64_t num_rows);
} // namespace asperity::io::detail
