#include "io/platforms/PlatformFile.hpp"

#include "base/Text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace asperity::io::detail
{
void StepFacts::add(StepInfo const& step)
{
  if (step.step > 0) {
    shortest = std::min(shortest, step.step_size);
    longest = std::max(longest, step.step_size);
    ++count;
  }
}

void StepFacts::save(Archive& archive) const
{
  archive.set("shortest", shortest);
  archive.set("longest", longest);
  archive.set("count", count);
}

void StepFacts::restore(Archive const& archive)
{
  shortest = archive.getDouble("shortest");
  longest = archive.getDouble("longest");
  count = archive.getInteger("count");
}

namespace
{
template <class... Values>
std::string formatted(char const* format, Values... values)
{
  char text[64];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// Of the same length for any facts.
std::vector<std::string> stepLines(TextFormat const& format, StepFacts const& facts)
{
  const auto count = formatted("num_time_steps=%-12lld", static_cast<long long>(facts.count));
  if (format.platform == Platform::scec) {
    return {formatted("time_step=%.6E", format.time_step), count};
  }
  const double shortest = facts.count > 0 ? facts.shortest : 0;
  return {formatted("minimum_time_step=%.6E", shortest),
          formatted("maximum_time_step=%.6E", facts.longest), count};
}
} // namespace

std::string platformHeader(TextFormat const& format, PlatformContent const& content,
                           StepFacts const* facts)
{
  std::vector<std::string> lines{"This is the file header:",
                                 "problem=" + format.problem,
                                 "author=" + format.author,
                                 "date=" + format.date,
                                 "code=Asperity",
                                 "code_version=" + format.code_version,
                                 "element_size=" + formatShort(format.element_size) + " m"};
  if (!content.location.empty()) {
    lines.push_back("location=" + content.location);
  }
  if (facts != nullptr) {
    const auto about_steps = stepLines(format, *facts);
    lines.insert(lines.end(), about_steps.begin(), about_steps.end());
  }
  lines.insert(lines.end(), content.remarks.begin(), content.remarks.end());
  lines.emplace_back("The line below lists the names of the data fields:");
  std::string text;
  for (auto const& line : lines) {
    text += "# " + line + '\n';
  }
  return text + content.fields;
}

std::vector<std::string> columnRemarks(std::vector<std::string> const& columns)
{
  std::vector<std::string> remarks;
  for (auto const& column : columns) {
    remarks.push_back("Column #" + std::to_string(remarks.size() + 1) + " = " + column);
  }
  return remarks;
}

std::string platformTime(double value) { return formatted("%21.14E", value); }

std::string platformNumber(double value) { return formatted("%14.6E", value); }

double platformLogarithm(double value)
{
  return value > 0 ? std::max(std::log10(value), smallest_logarithm) : smallest_logarithm;
}

namespace
{
std::string headerBeforeAnyStep(TextFormat const& format, PlatformContent const& content)
{
  const StepFacts none;
  return platformHeader(format, content, &none);
}
} // namespace

PlatformSeries::PlatformSeries(TextFormat const& format, std::filesystem::path const& directory,
                               PlatformContent const& content, RCP<const Communicator> const& comm)
    : format_(format)
    , content_(content)
    , table_(directory / format.folder() / content.name, headerBeforeAnyStep(format, content), comm)
{
}

void PlatformSeries::writeRow(double time, double const* values, std::size_t number)
{
  std::string row = platformTime(time);
  for (std::size_t i = 0; i < number; ++i) {
    row += ' ' + platformNumber(values[i]);
  }
  table_.writeRow(row);
}

void PlatformSeries::flush(StepFacts const& facts)
{
  table_.setHeader(platformHeader(format_, content_, &facts));
  table_.flush();
}
} // namespace asperity::io::detail
