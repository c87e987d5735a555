#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace asperity
{
// A formula in x, y, z [m] and t [s], evaluated by muParser: + - * / ^, comparisons, && ||, c ? a :
// b, pi, e, muParser's functions (sin, tanh, exp, ln, min, max, ...) and floor, ceil, erf, erfc,
// if(c, a, b). One host thread at a time.
class Expression
{
public:
  // InputError with `path`, muParser's message and the position of the mistake.
  Expression(std::string const& text, std::string const& path);
  ~Expression();
  Expression(Expression const&) = delete;
  Expression& operator=(Expression const&) = delete;

  // The result is not checked; it may be infinite or NaN.
  double operator()(std::array<double, 3> const& x, double t) const;

  // In the order of the alphabet.
  static std::vector<std::string> functionNames();
  // Functions, coordinates and constants: names that have a meaning here.
  static std::vector<std::string> reservedNames();

  bool dependsOnSpace() const;
  bool dependsOnTime() const;
  std::string const& text() const { return text_; }

private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string text_;
};
} // namespace asperity
