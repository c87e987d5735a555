#include "surfaces/TraceFile.hpp"

#include "surfaces/files/TextFile.hpp"

#include "base/Text.hpp"

#include <algorithm>

namespace asperity::geometry
{
std::vector<std::string> traceColumns() { return {"x y", "x y dip", "x y z", "x y z dip"}; }

TraceFile readTrace(std::string const& file_name, std::string const& columns)
{
  const auto names = split(columns, ' ');
  TextFile file(file_name, "Trace file", '#');
  TraceFile result;
  while (file.next()) {
    if (file.word(0) == ">") {
      if (!result.points.empty()) {
        file.fail("a second line begins here; a trace is a single one. Put each into a file of its "
                  "own.");
      }
      continue;
    }
    if (file.words().size() != names.size()) {
      file.fail("it has " + std::to_string(file.words().size()) +
                " columns, but Trace Columns says '" + columns + "'.");
    }
    auto& point = result.points.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == "dip") {
        result.dips.push_back(file.number(i));
        if (!(result.dips.back() > 0 && result.dips.back() < 180)) {
          file.fail("the dip " + formatNumber(result.dips.back()) +
                    " is outside (0, 180) degrees.");
        }
      } else {
        point[i] = file.number(i);
      }
    }
  }
  return result;
}
} // namespace asperity::geometry
