#pragma once

#include <array>
#include <memory>
#include <string>

namespace asperity
{
// A formula in x, y, z [m] and t [s], evaluated by muParser: + - * / ^, comparisons, && ||, c ? a :
// b, sin, tanh, exp, ln, min, max, ... and floor, ceil, if(c, a, b), pi, e. One host thread at a
// time.
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

  bool dependsOnSpace() const;
  bool dependsOnTime() const;
  std::string const& text() const { return text_; }

private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string text_;
};
} // namespace asperity
