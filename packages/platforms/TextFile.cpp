#include "platforms/TextFile.hpp"

#include "base/Text.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::platforms
{
void StepFacts::add(io::StepInfo const& step)
{
  if (step.step > 0) {
    shortest = std::min(shortest, step.step_size);
    longest = std::max(longest, step.step_size);
    ++count;
  }
}

void StepFacts::save(io::Archive& archive) const
{
  archive.set("shortest", shortest);
  archive.set("longest", longest);
  archive.set("count", count);
}

void StepFacts::restore(io::Archive const& archive)
{
  shortest = archive.getDouble("shortest");
  longest = archive.getDouble("longest");
  count = archive.getInteger("count");
}

std::string fileHeader(Platform const& platform, FileContent const& content, StepFacts const* facts)
{
  std::vector<std::string> lines{"This is the file header:",
                                 "problem=" + platform.run.problem,
                                 "author=" + platform.run.author,
                                 "date=" + platform.run.date,
                                 "code=Asperity",
                                 "code_version=" + platform.run.code_version,
                                 "element_size=" + formatShort(platform.run.element_size) + " m"};
  if (!content.place.empty()) {
    lines.push_back("location=" + content.place);
  }
  if (facts != nullptr) {
    const auto about_steps = platform.step_lines(*facts);
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
  remarks.reserve(columns.size());
  for (auto const& column : columns) {
    remarks.push_back("Column #" + std::to_string(remarks.size() + 1) + " = " + column);
  }
  return remarks;
}

std::string timeText(double value) { return formatted("%21.14E", value); }

std::string numberText(double value) { return formatted("%14.6E", value); }

std::string stepSizeLine(std::string const& name, double value)
{
  return name + formatted("=%.6E", value);
}

std::string countLine(std::int64_t count)
{
  return formatted("num_time_steps=%-12lld", static_cast<long long>(count));
}

double decimalLogarithm(double value)
{
  return value > 0 ? std::max(std::log10(value), smallest_logarithm) : smallest_logarithm;
}

namespace
{
std::string headerBeforeAnyStep(Platform const& platform, FileContent const& content)
{
  const StepFacts none;
  return fileHeader(platform, content, &none);
}
} // namespace

TimeSeries::TimeSeries(Platform const& platform, FileContent const& content,
                       io::OutputContext const& context)
    : platform_(platform)
    , content_(content)
    , table_(context.directory / platform.folder / content.name,
             headerBeforeAnyStep(platform, content), context.comm)
{
}

void TimeSeries::writeRow(double time, double const* values, std::size_t number)
{
  std::string row = timeText(time);
  for (std::size_t i = 0; i < number; ++i) {
    row += ' ' + numberText(values[i]);
  }
  table_.writeRow(row);
}

void TimeSeries::flush(StepFacts const& facts)
{
  table_.setHeader(fileHeader(platform_, content_, &facts));
  table_.flush();
}
} // namespace asperity::platforms
