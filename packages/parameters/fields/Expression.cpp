#include "parameters/fields/Expression.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/fields/TableFunction.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace asperity
{
struct Expression::Parser
{
  // mean(formula), of which muParser sees a variable.
  struct Mean
  {
    Expression formula;
    double value = 0;
  };

  // A function of a table, as muParser calls it. While a text is read, its value is 0: muParser
  // evaluates it at the origin then, where a table may have no value.
  struct Call
  {
    TableFunction const* function;
    bool const* is_read;

    static double at(void* call, double argument)
    {
      auto const& self = *static_cast<Call const*>(call);
      return *self.is_read ? (*self.function)(argument) : 0;
    }
  };

  mu::Parser parser;
  Tables tables;
  std::vector<std::unique_ptr<Call>> calls;
  std::vector<std::unique_ptr<Mean>> means;
  double x = 0.0, y = 0.0, z = 0.0, t = 0.0;
  bool uses_space = false, uses_time = false, is_read = false;

  explicit Parser(Tables given = nullptr) : tables(std::move(given))
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
    parser.DefineFun("mean", [](double f) { return f; }); // for lists of functions
    parser.DefineFun("if", [](double c, double a, double b) { return c != 0.0 ? a : b; });
    if (tables) {
      for (auto const& [name, function] : tables->of_name) {
        calls.push_back(std::make_unique<Call>(Call{&function, &is_read}));
        parser.DefineFunUserData(name, &Call::at, calls.back().get(), false);
      }
    }
  }

  // The values at the origin at t = 0, one for each formula of the text.
  std::vector<double> read(std::string const& text, std::string const& path);
  std::vector<double> valuesOf(std::string const& text, std::string const& path);

  // The text with variables in the places of means, which have their lengths.
  std::string withoutMeans(std::string text, std::string const& path);
};

namespace
{
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

// The place of the parenthesis that closes the one at `open`; npos if there is none.
std::size_t closingOf(std::string const& text, std::size_t open)
{
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) {
      return i;
    }
  }
  return std::string::npos;
}

// Whether a text that is no expression looks like the name of a file: it ends like one, and has no
// operation and no space, or goes on behind that of an HDF5 file.
bool looksLikeFile(std::string const& text)
{
  for (std::string const inside : {".h5:", ".h5/", ".hdf5:", ".hdf5/"}) {
    if (text.find(inside) != std::string::npos) {
      return true;
    }
  }
  const auto point = text.find_last_of('.');
  if (point == std::string::npos || point + 1 == text.size() ||
      text.find_first_of(" \t\n+*^()<>=&|,?") != std::string::npos) {
    return false;
  }
  const std::string ending = text.substr(point + 1);
  return ending.size() <= 5 && std::isalpha(static_cast<unsigned char>(ending.front())) != 0 &&
         std::all_of(ending.begin(), ending.end(),
                     [](unsigned char letter) { return std::isalnum(letter) != 0; });
}

std::string textOf(Expression::Tables const& tables)
{
  std::vector<std::string> names;
  if (tables) {
    for (auto const& table : tables->of_name) {
      names.push_back(table.first);
    }
  }
  return names.empty() ? "" : ", and its Tables " + quotedNames(names);
}

[[noreturn]] void refuse(std::string const& text, std::string const& path,
                         Expression::Tables const& tables, mu::ParserError const& error)
{
  ASPERITY_REQUIRE(
    !looksLikeFile(text),
    path
      << " = '" << excerpt(text)
      << "' looks like the name of a file, and is no expression. A file is given as "
         "'file.h5:/dataset': an HDF5 dataset with one number for each vertex of the mesh. Files "
         "of other kinds are not read; write their numbers into such a dataset, or as an "
         "expression in x, y, z. A CSV file with a function of one variable stands in the list "
         "Tables of a deck, and the field is an expression that calls it.");
  const auto position = static_cast<std::size_t>(error.GetPos());
  std::ostringstream message;
  message << path << " = '" << excerpt(text)
          << "' is no valid expression: " << excerpt(error.GetMsg());
  if (position < text.size()) {
    message << " (character " << position + 1 << ", before '" << excerpt(text.substr(position))
            << "')";
  }
  message << " It may use x, y, z, t, pi, e, the deck's Names, " << Expression::operations()
          << textOf(tables) << ".";
  throw InputError(message.str());
}
} // namespace

std::string Expression::Parser::withoutMeans(std::string text, std::string const& path)
{
  std::size_t place = 0, behind_mean = 0;
  for (auto const& part : formulaParts(std::string(text))) {
    const std::size_t begin = place, after_name = place + part.text.size();
    place = after_name;
    const std::size_t open = text.find_first_not_of(' ', after_name);
    if (begin < behind_mean || part.text != "mean" || open == std::string::npos ||
        text[open] != '(') {
      continue;
    }
    const std::size_t end = closingOf(text, open);
    if (end == std::string::npos) {
      break; // muParser names the parenthesis that is missing
    }
    means.push_back(std::unique_ptr<Mean>(
      new Mean{Expression(text.substr(open + 1, end - open - 1), path, tables)}));
    auto name = "_" + std::to_string(means.size());
    parser.DefineVar(name, &means.back()->value);
    behind_mean = end + 1;
    name.resize(behind_mean - begin, ' ');
    text.replace(begin, name.size(), name);
  }
  return text;
}

std::vector<double> Expression::Parser::read(std::string const& text, std::string const& path)
{
  refuseAssignment(text, path);
  try {
    parser.SetExpr(withoutMeans(text, path));
    parser.Eval(); // GetUsedVar alone accepts unknown names
    for (auto const& variable : parser.GetUsedVar()) {
      uses_time = uses_time || variable.first == "t";
      uses_space = uses_space || (variable.first.size() == 1 && variable.first != "t");
    }
    for (auto const& mean : means) {
      uses_time = uses_time || mean->formula.dependsOnTime();
      uses_space = uses_space || mean->formula.dependsOnSpace();
    }
    return valuesOf(text, path);
  } catch (mu::ParserError const& error) {
    refuse(text, path, tables, error);
  }
}

std::vector<double> Expression::Parser::valuesOf(std::string const& text, std::string const& path)
{
  is_read = !uses_space && !uses_time; // the values of others do not count
  try {
    for (auto const& mean : means) {
      mean->value = is_read ? mean->formula({}, 0) : 0;
    }
    int count = 0;
    double const* values = parser.Eval(count);
    is_read = true;
    return {values, values + count};
  } catch (InputError const& error) { // of a table
    throw InputError(path + " = '" + excerpt(text) + "' has no value. " + error.what());
  }
}

Expression::Expression(std::string const& text, std::string const& path, Tables tables)
    : parser_(std::make_unique<Parser>(std::move(tables)))
    , text_(text)
    , path_(path)
{
  const auto results = parser_->read(text, path).size();
  ASPERITY_REQUIRE(results == 1, path << " = '" << excerpt(text) << "' has " << results
                                      << " values; write 1.5 rather than 1,5.");
}

std::optional<std::vector<double>>
Expression::constants(std::string const& text, std::string const& path, Tables const& tables)
{
  Parser parser(tables);
  auto values = parser.read(text, path);
  return parser.uses_space || parser.uses_time ? std::nullopt : std::optional(std::move(values));
}

Expression::~Expression() = default;

std::string Expression::operations()
{
  std::string text = "+ - * / ^, comparisons, && || !, c ? a : b, and the functions ";
  const Parser with_all;
  for (auto const& function : with_all.parser.GetFunDef()) {
    text += (text.back() == ' ' ? "" : ", ") + function.first;
  }
  return text;
}

void Expression::requireFreeName(std::string const& name, std::string const& path)
{
  auto const parts = formulaParts(name);
  ASPERITY_REQUIRE(parts.size() == 1 && parts.front().is_name,
                   path << ": '" << name << "' cannot be used in an expression. Use "
                        << "letters, digits and _, and begin with a letter.");
  const Parser with_all;
  auto const& functions = with_all.parser.GetFunDef();
  auto const& constants = with_all.parser.GetConst();
  auto const& variables = with_all.parser.GetVar();
  const bool is_taken =
    functions.count(name) > 0 || constants.count(name) > 0 || variables.count(name) > 0;
  ASPERITY_REQUIRE(!is_taken, path << ": '" << name << "' has a meaning in expressions already. "
                                   << "Take another name.");
}

double Expression::operator()(std::array<double, 3> const& x, double t) const
{
  const double all = 1;
  return (*this)(x, t, {&x, &all, 1});
}

double Expression::operator()(std::array<double, 3> const& x, double t, Patch const& patch) const
{
  for (auto const& mean : parser_->means) {
    // Relative to the first value, so that the mean of a constant is the constant.
    const double first = mean->formula(patch.places[0], t);
    mean->value = first;
    for (std::size_t k = 1; k < patch.size; ++k) {
      mean->value += patch.weights[k] * (mean->formula(patch.places[k], t) - first);
    }
  }
  parser_->x = x[0];
  parser_->y = x[1];
  parser_->z = x[2];
  parser_->t = t;
  try {
    return parser_->parser.Eval();
  } catch (InputError const& error) { // of a table
    throw InputError(path_ + " = '" + excerpt(text_) + "' has no value at " + placeText(x, t) +
                     ". " + error.what());
  }
}

TableFunction const* Expression::tableAlone() const
{
  auto text = trimmed(text_);
  auto open = text.find('(');
  while (open == 0 && closingOf(text, open) + 1 == text.size()) { // of a name's value
    text = trimmed(text.substr(1, text.size() - 2));
    open = text.find('(');
  }
  if (!parser_->tables || open == std::string::npos || closingOf(text, open) + 1 != text.size()) {
    return nullptr;
  }
  auto const& functions = parser_->tables->of_name;
  auto const found = functions.find(trimmed(text.substr(0, open)));
  return found == functions.end() ? nullptr : &found->second;
}

bool Expression::takesMeans() const { return !parser_->means.empty(); }

bool Expression::dependsOnSpace() const { return parser_->uses_space; }

bool Expression::dependsOnTime() const { return parser_->uses_time; }

std::string placeText(std::array<double, 3> const& x, double t)
{
  return "(x, y, z) = " + formatPoint({x.begin(), x.end()}) + " m, t = " + formatShort(t) + " s";
}

std::vector<FormulaPart> formulaParts(std::string const& text)
{
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto is_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  const char* const end = text.data() + text.size();
  std::vector<FormulaPart> parts;
  for (const char* begin = text.data(); begin != end; begin += parts.back().text.size()) {
    double value = 0;
    const char* const after_number =
      is_digit(*begin) || *begin == '.' ? std::from_chars(begin, end, value).ptr : begin;
    const char* const after_name = std::find_if_not(begin, end, is_of_name);
    if (after_number != begin) {
      parts.push_back({std::string(begin, after_number), true, false});
    } else if (after_name != begin) {
      const char* const next = std::find_if(after_name, end, [](char c) { return c != ' '; });
      parts.push_back({std::string(begin, after_name), false, next == end || *next != '('});
    } else {
      parts.push_back({std::string(1, *begin), false, false});
    }
  }
  return parts;
}
} // namespace asperity
