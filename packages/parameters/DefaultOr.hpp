#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace asperity
{
// Stands in place of a default: the deck has to give the parameter.
struct Required
{
};
inline constexpr Required required{};

// Stands in place of a default: the deck may leave the parameter out, and then isParameter(name) is
// false.
struct Optional
{
};
inline constexpr Optional optional{};

// A default value, `required` or `optional`; made from whatever converts to T.
template <class T>
class DefaultOr
{
public:
  DefaultOr(Required) : is_required_(true) {}
  DefaultOr(Optional) {}
  template <class U, class = std::enable_if_t<std::is_convertible_v<U, T>>>
  DefaultOr(U&& value) : value_(std::forward<U>(value))
  {
  }

  bool isRequired() const { return is_required_; }
  std::optional<T> const& value() const { return value_; }

private:
  bool is_required_ = false;
  std::optional<T> value_;
};

// Default of a field: a number or an expression in x, y, z, t.
struct FieldValue : std::variant<double, std::string>
{
  FieldValue(double number) : variant(number) {}
  FieldValue(std::string const& expression) : variant(expression) {}
  FieldValue(char const* expression) : variant(std::string(expression)) {}
};
} // namespace asperity
