#include "base/Text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace asperity
{
namespace
{
constexpr double minute = 60.0;
constexpr double hour = 60.0 * minute;
constexpr double day = 24.0 * hour;
constexpr double year = 365.25 * day;

std::string significant(double value, int digits) { return formatted("%.*g", digits, value); }

// "3 min 20 s": whole numbers of the larger and the smaller unit
std::string inTwoUnits(double seconds, double larger, std::string const& larger_name,
                       double smaller, std::string const& smaller_name)
{
  const auto count = std::llround(seconds / smaller);
  const auto per_larger = std::llround(larger / smaller);
  std::string text = std::to_string(count / per_larger) + " " + larger_name;
  if (count % per_larger != 0) {
    text += " " + std::to_string(count % per_larger) + " " + smaller_name;
  }
  return text;
}

// The limits are slightly below the round numbers, so that rounding to three digits never gives
// 1000 of a unit: 999.6 ms becomes 1 s.
std::string shortDuration(double seconds)
{
  if (seconds < 0.9995e-6) {
    return significant(seconds * 1e9, 3) + " ns";
  }
  if (seconds < 0.9995e-3) {
    return significant(seconds * 1e6, 3) + " us";
  }
  if (seconds < 0.9995) {
    return significant(seconds * 1e3, 3) + " ms";
  }
  return significant(seconds, 3) + " s";
}

std::string years(double count)
{
  if (count < 999.5e3) {
    return count < 100.0 ? significant(count, 3) + " years"
                         : std::to_string(std::llround(count)) + " years";
  }
  return significant(count * 1e-6, 3) + " million years";
}
} // namespace

std::string formatNumber(double value)
{
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

std::string formatShort(double value) { return significant(value, 6); }

std::string formatPoint(std::vector<double> const& point, std::string (*format)(double))
{
  std::string text;
  for (const double coordinate : point) {
    text += (text.empty() ? "(" : ", ") + format(coordinate);
  }
  return text + ")";
}

std::string formatDuration(double seconds)
{
  if (!std::isfinite(seconds)) {
    return formatNumber(seconds) + " s";
  }
  if (seconds < 0.0) {
    return "-" + formatDuration(-seconds);
  }
  if (seconds == 0.0) {
    return "0 s";
  }
  if (seconds < minute - 0.05) {
    return shortDuration(seconds);
  }
  if (seconds < hour - 0.5) {
    return inTwoUnits(seconds, minute, "min", 1.0, "s");
  }
  if (seconds < day - 0.5 * minute) {
    return inTwoUnits(seconds, hour, "h", minute, "min");
  }
  if (seconds < year) {
    return inTwoUnits(seconds, day, "d", hour, "h");
  }
  return years(seconds / year);
}

std::string counted(std::int64_t number, std::string const& noun)
{
  return std::to_string(number) + ' ' + noun + (number == 1 ? "" : "s");
}

std::string trimmed(std::string const& text)
{
  const auto blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<std::string> insideBraces(std::string const& text)
{
  const std::string whole = trimmed(text);
  const bool has_braces = whole.size() >= 2 && whole.front() == '{' && whole.back() == '}';
  return has_braces ? std::optional(trimmed(whole.substr(1, whole.size() - 2))) : std::nullopt;
}

std::string excerpt(std::string const& text)
{
  constexpr std::size_t most_characters = 200;
  const bool is_long = text.size() > most_characters;
  std::string line = is_long ? text.substr(0, most_characters) + "..." : text;
  std::replace_if(
    line.begin(), line.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return line;
}

std::vector<std::string> split(std::string const& text, char separator)
{
  std::vector<std::string> pieces;
  std::size_t first = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, first)) {
    pieces.push_back(trimmed(text.substr(first, end - first)));
    first = end + 1;
  }
  pieces.push_back(trimmed(text.substr(first)));
  return pieces;
}

std::string quotedNames(std::vector<std::string> const& names)
{
  std::string text;
  for (auto const& name : names) {
    text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return text.empty() ? "none" : text;
}

std::string quotedAlternatives(std::vector<std::string> const& names)
{
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_last = i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " or " : ", ") + ("'" + names[i] + "'");
  }
  return text;
}

namespace
{
// Reads the whole text with std::from_chars, which does not accept a plus sign.
template <class T>
std::optional<T> readWhole(std::string const& text)
{
  std::string digits = trimmed(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') {
    digits.erase(0, 1);
  }
  T value{};
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional<T>(value) : std::nullopt;
}
} // namespace

std::optional<double> readNumber(std::string const& text)
{
  const auto number = readWhole<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<int> readInteger(std::string const& text) { return readWhole<int>(text); }
} // namespace asperity
