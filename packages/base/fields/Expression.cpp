#include "base/fields/Expression.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <muParser.h>

#include <cmath>

namespace asperity
{
struct Expression::Parser
{
  mu::Parser parser;
  double x = 0.0, y = 0.0, z = 0.0, t = 0.0;
  bool uses_space = false, uses_time = false;

  Parser()
  {
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineVar("z", &z);
    parser.DefineVar("t", &t);
    parser.DefineConst("pi", 3.14159265358979323846);
    parser.DefineConst("e", 2.71828182845904523536);
    parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
    parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
    parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
    parser.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
    parser.DefineFun("if", [](double c, double a, double b) { return c != 0.0 ? a : b; });
  }
};

namespace
{
std::string joined(std::vector<std::string> const& words)
{
  std::string text;
  for (auto const& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

// muParser takes a single = for an assignment, which changes what comes after it.
void refuseAssignment(std::string const& text, std::string const& path)
{
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::string("<>=!").find(text[i]) != std::string::npos && text[i + 1] == '=') {
      ++i; // a comparison
    } else {
      ASPERITY_REQUIRE(text[i] != '=', path << " = '" << excerpt(text) << "' has a single = ("
                                            << "character " << i + 1 << ", before '"
                                            << excerpt(text.substr(i))
                                            << "'). Write == to compare.");
    }
  }
}

[[noreturn]] void refuse(std::string const& text, std::string const& path,
                         mu::ParserError const& error)
{
  const auto position = static_cast<std::size_t>(error.GetPos());
  std::ostringstream message;
  message << path << " = '" << excerpt(text)
          << "' is no valid expression: " << excerpt(error.GetMsg());
  if (position < text.size()) {
    message << " (character " << position + 1 << ", before '" << excerpt(text.substr(position))
            << "')";
  }
  message << " It may use x, y, z, t, pi, e, the deck's Names, + - * / ^, comparisons, && || !, "
             "c ? a : b, and the functions "
          << joined(Expression::functionNames()) << ".";
  throw InputError(message.str());
}
} // namespace

Expression::Expression(std::string const& text, std::string const& path)
    : parser_(std::make_unique<Parser>())
    , text_(text)
{
  refuseAssignment(text, path);
  try {
    parser_->parser.SetExpr(text);
    parser_->parser.Eval(); // GetUsedVar alone accepts unknown names
    for (auto const& variable : parser_->parser.GetUsedVar()) {
      (variable.first == "t" ? parser_->uses_time : parser_->uses_space) = true;
    }
    int results = 0;
    parser_->parser.Eval(results);
    ASPERITY_REQUIRE(results == 1, path << " = '" << excerpt(text) << "' has " << results
                                        << " values; write 1.5 rather than 1,5.");
  } catch (mu::ParserError const& error) {
    refuse(text, path, error);
  }
}

Expression::~Expression() = default;

std::vector<std::string> Expression::functionNames()
{
  std::vector<std::string> names;
  const Parser with_all;
  for (auto const& function : with_all.parser.GetFunDef()) {
    names.push_back(function.first);
  }
  return names;
}

std::vector<std::string> Expression::reservedNames()
{
  auto names = functionNames();
  for (char const* name : {"x", "y", "z", "t", "pi", "e"}) {
    names.emplace_back(name);
  }
  return names;
}

double Expression::operator()(std::array<double, 3> const& x, double t) const
{
  parser_->x = x[0];
  parser_->y = x[1];
  parser_->z = x[2];
  parser_->t = t;
  return parser_->parser.Eval();
}

bool Expression::dependsOnSpace() const { return parser_->uses_space; }

bool Expression::dependsOnTime() const { return parser_->uses_time; }
} // namespace asperity
