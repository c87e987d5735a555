#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
// The values in a format of printf: formatted("%.3e m", x).
template <class... Values>
std::string formatted(char const* format, Values... values)
{
  std::string text(std::snprintf(nullptr, 0, format, values...), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

// The shortest decimal that reads back as the same double: 0.1, 3e+10, inf, nan.
std::string formatNumber(double value);

// Six digits at most, for messages and tables: 0.333333
std::string formatShort(double value);

// "(0, -12.5)", for messages and tables.
std::string formatPoint(std::vector<double> const& point,
                        std::string (*format)(double) = formatShort);

// "850 ns", "12.5 ms", "48.3 s", "3 min 20 s", "2 h 5 min", "3 d 4 h", "12.5 years", "1.2 million
// years"; a year has 365.25 days.
std::string formatDuration(double seconds);

// "1 step", "3 steps", "0 steps": for words that only add an s.
std::string counted(std::int64_t number, std::string const& noun);

// The text without blanks at its ends.
std::string trimmed(std::string const& text);

// What stands between braces, trimmed: "1, 2" of " {1, 2} "; nullopt if the text has none.
std::optional<std::string> insideBraces(std::string const& text);

// The text for a message, on one line: control characters become blanks, and of a text of more than
// 200 characters the first 200 and "..." remain.
std::string excerpt(std::string const& text);

// The pieces between the separators, each trimmed; one empty piece for an empty text.
std::vector<std::string> split(std::string const& text, char separator);

// "'a', 'b', 'c'"; "none" if there are none.
std::string quotedNames(std::vector<std::string> const& names);

// "'a', 'b' or 'c'"
std::string quotedAlternatives(std::vector<std::string> const& names);

// The number that the whole text represents, if it represents one. It is finite; an exponent is
// allowed, other letters are not.
std::optional<double> readNumber(std::string const& text);
std::optional<int> readInteger(std::string const& text);
} // namespace asperity
