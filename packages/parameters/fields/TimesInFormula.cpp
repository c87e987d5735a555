#include "parameters/fields/TimesInFormula.hpp"

#include "base/Errors.hpp"
#include "parameters/fields/Expression.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace asperity
{
namespace
{
using Parts = std::vector<FormulaPart>;

Parts partsWithoutBlanks(std::string const& formula)
{
  auto parts = formulaParts(formula);
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [](FormulaPart const& part) {
                               return part.text.find_first_not_of(" \t\n\r") == std::string::npos;
                             }),
              parts.end());
  return parts;
}

std::string textOf(Parts const& parts, std::size_t begin, std::size_t end)
{
  std::string text;
  for (auto i = begin; i < end; ++i) {
    text += parts[i].text;
  }
  return text;
}

// The operand of a comparison that has no operators of lower rank: from the part `begin` on, in
// steps of 1 or -1.
std::string operandFrom(Parts const& parts, std::ptrdiff_t begin, int step)
{
  const std::string opening = step > 0 ? "(" : ")", closing = step > 0 ? ")" : "(";
  std::string operand;
  int depth = 0;
  for (auto i = begin; i >= 0 && i < static_cast<std::ptrdiff_t>(parts.size()); i += step) {
    auto const& text = parts[static_cast<std::size_t>(i)].text;
    depth += text == opening ? 1 : text == closing ? -1 : 0;
    if (depth < 0 || (depth == 0 && std::string("&|?:,<>=!").find(text) != std::string::npos)) {
      break;
    }
    operand = step > 0 ? operand + text : text + operand;
  }
  return operand;
}

std::optional<double> constant(std::string const& formula)
{
  if (formula.empty()) {
    return std::nullopt;
  }
  try {
    auto const values = Expression::constants(formula, "a time");
    return values ? std::optional(values->front()) : std::nullopt;
  } catch (InputError const&) { // the text is no formula, but a name as "wall-t"
    return std::nullopt;
  }
}

// Whether the first part is a parenthesis that the last one closes.
bool isEnclosed(Parts const& parts)
{
  int depth = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    depth += parts[i].text == "(" ? 1 : parts[i].text == ")" ? -1 : 0;
    if (depth == 0 && i + 1 < parts.size()) {
      return false;
    }
  }
  return parts.size() > 1 && parts.front().text == "(";
}

// sign t + offset, with a sign of 1 or -1
struct ShiftedTime
{
  double sign, offset;
  double whenEqualTo(double value) const { return (value - offset) / sign; }
};

// The shift and the sign of "t", "t - 60", "(60 - t)" and the like; nullopt for other parts.
std::optional<ShiftedTime> shiftedTime(Parts parts)
{
  while (isEnclosed(parts)) {
    parts = Parts(parts.begin() + 1, parts.end() - 1);
  }
  const auto size = parts.size();
  const auto is = [&](std::size_t place, char const* text) {
    return place < size && parts[place].text == text;
  };
  if (is(0, "t") && size == 1) {
    return ShiftedTime{1, 0};
  }
  if (is(0, "t") && (is(1, "+") || is(1, "-"))) {
    auto const offset = constant("0" + textOf(parts, 1, size));
    return offset ? std::optional(ShiftedTime{1, *offset}) : std::nullopt;
  }
  if (size > 2 && is(size - 1, "t") && (is(size - 2, "+") || is(size - 2, "-"))) {
    auto const offset = constant(textOf(parts, 0, size - 2));
    return offset ? std::optional(ShiftedTime{is(size - 2, "+") ? 1. : -1., *offset})
                  : std::nullopt;
  }
  return std::nullopt;
}

// When the text, a function of t, is equal to the value.
std::vector<double> timesWhen(std::string const& text, double value)
{
  auto parts = partsWithoutBlanks(text);
  while (isEnclosed(parts)) {
    parts = Parts(parts.begin() + 1, parts.end() - 1);
  }
  const Parts argument(parts.begin() + (parts.empty() ? 0 : 1), parts.end());
  if (!parts.empty() && parts.front().text == "abs" && isEnclosed(argument)) {
    auto const inside = shiftedTime(argument);
    return inside ? std::vector<double>{inside->whenEqualTo(-value), inside->whenEqualTo(value)}
                  : std::vector<double>{};
  }
  auto const shifted = shiftedTime(parts);
  return shifted ? std::vector<double>{shifted->whenEqualTo(value)} : std::vector<double>{};
}
} // namespace

std::vector<double> timesComparedIn(std::string const& formula)
{
  auto const parts = partsWithoutBlanks(formula);
  std::vector<double> times;
  const auto size = static_cast<std::ptrdiff_t>(parts.size());
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    const bool is_order = parts[i].text == "<" || parts[i].text == ">";
    if (!is_order) {
      continue;
    }
    const auto right = i + 1 < size && parts[i + 1].text == "=" ? i + 2 : i + 1;
    const std::string sides[] = {operandFrom(parts, i - 1, -1), operandFrom(parts, right, 1)};
    for (const int side : {0, 1}) {
      if (auto const value = constant(sides[1 - side])) {
        auto const found = timesWhen(sides[side], *value);
        times.insert(times.end(), found.begin(), found.end());
      }
    }
  }
  return times;
}

std::vector<double> timesShiftedIn(std::string const& formula)
{
  auto const parts = partsWithoutBlanks(formula);
  std::vector<double> times;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].text != "t") {
      continue;
    }
    const auto place = static_cast<std::ptrdiff_t>(i);
    auto const sum = operandFrom(parts, place - 1, -1) + "t" + operandFrom(parts, place + 1, 1);
    auto const shifted = shiftedTime(partsWithoutBlanks(sum));
    if (shifted && shifted->offset != 0) {
      times.push_back(shifted->whenEqualTo(0));
    }
  }
  return times;
}
} // namespace asperity
