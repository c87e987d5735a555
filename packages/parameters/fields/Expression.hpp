#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
class TableFunction;
struct TableFunctions;

// A formula in x, y, z [m] and t [s], evaluated by muParser: + - * / ^, comparisons, && ||, c ? a :
// b, pi, e, muParser's functions (sin, tanh, exp, ln, min, max, ...) and floor, ceil, erf, erfc,
// if(c, a, b), mean(f), and functions that tables give. One host thread at a time.
class Expression
{
public:
  // Points around a place, and their weights, which sum to 1.
  struct Patch
  {
    std::array<double, 3> const* places; // (size) [m]
    double const* weights;               // (size)
    std::size_t size;
  };

  using Tables = std::shared_ptr<const TableFunctions>; // null: none

  // InputError with `path`, muParser's message and the position of the mistake.
  Expression(std::string const& text, std::string const& path, Tables tables = nullptr);
  ~Expression();
  Expression(Expression const&) = delete;
  Expression& operator=(Expression const&) = delete;

  // The result is not checked; it may be infinite or NaN. mean(f) is the mean of f over the patch,
  // without one f itself. InputError where a table has no value.
  double operator()(std::array<double, 3> const& x, double t) const;
  double operator()(std::array<double, 3> const& x, double t, Patch const& patch) const;

  // The values of formulas with commas between them, "2 * 3600, -max(1, 2)"; nullopt if one of them
  // depends on x, y, z or t. InputError as in the constructor.
  static std::optional<std::vector<double>>
  constants(std::string const& text, std::string const& path, Tables const& tables = nullptr);

  // "+ - * / ^, ..., and the functions abs, ...": what else a formula may use than names.
  static std::string operations();
  // InputError with `path` unless formulas can use the name for something of the deck: it is an
  // identifier, and no function, coordinate or constant has it.
  static void requireFreeName(std::string const& name, std::string const& path);

  // The table whose value the whole formula is, "vp(-z)"; null if it is anything else.
  TableFunction const* tableAlone() const;
  bool takesMeans() const;
  bool dependsOnSpace() const;
  bool dependsOnTime() const;
  std::string const& text() const { return text_; }

private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string text_, path_;
};

// "(x, y, z) = (1, 2, 3) m, t = 4 s", for messages.
std::string placeText(std::array<double, 3> const& x, double t);

// A part of a formula's text: a number, a name, or one other character.
struct FormulaPart
{
  std::string text;
  bool is_number = false;
  bool is_name = false; // of something else than a function
};

// All parts, in their order, of a text that need not be a correct formula.
std::vector<FormulaPart> formulaParts(std::string const& text);
} // namespace asperity
