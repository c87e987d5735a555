#include "parameters/fields/Unit.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

namespace asperity
{
namespace
{
struct Symbol
{
  char const* name;
  std::array<int, 4> powers; // of m, kg, s, K
  int power_of_ten;
  int factor;
  char const* prefixes;
};

constexpr char const* all_prefixes = "GMkmun";
constexpr Symbol symbols[] = {
  {"m", {1, 0, 0, 0}, 0, 1, "kcmun"},         {"g", {0, 1, 0, 0}, -3, 1, "kmun"},
  {"s", {0, 0, 1, 0}, 0, 1, "mun"},           {"K", {0, 0, 0, 1}, 0, 1, "m"},
  {"Pa", {-1, 1, -2, 0}, 0, 1, all_prefixes}, {"N", {1, 1, -2, 0}, 0, 1, all_prefixes},
  {"J", {2, 1, -2, 0}, 0, 1, all_prefixes},   {"W", {2, 1, -3, 0}, 0, 1, all_prefixes},
  {"Hz", {0, 0, -1, 0}, 0, 1, all_prefixes},  {"min", {0, 0, 1, 0}, 0, 60, ""},
  {"h", {0, 0, 1, 0}, 0, 3600, ""},           {"d", {0, 0, 1, 0}, 0, 86400, ""},
  {"a", {0, 0, 1, 0}, 0, 31557600, "Mk"},
};

int powerOfPrefix(char prefix)
{
  switch (prefix) {
  case 'G': return 9;
  case 'M': return 6;
  case 'k': return 3;
  case 'c': return -2;
  case 'm': return -3;
  case 'u': return -6;
  default: return -9; // n
  }
}

struct PrefixedSymbol
{
  Symbol const* symbol;
  int power_of_prefix;
};

// A whole symbol comes before one with a prefix: min is a minute.
std::optional<PrefixedSymbol> findSymbol(std::string const& name)
{
  for (auto const& symbol : symbols) {
    if (name == symbol.name) {
      return PrefixedSymbol{&symbol, 0};
    }
  }
  for (auto const& symbol : symbols) {
    const bool has_prefix = name.size() > 1 && name.substr(1) == symbol.name &&
                            std::string(symbol.prefixes).find(name[0]) != std::string::npos;
    if (has_prefix) {
      return PrefixedSymbol{&symbol, powerOfPrefix(name[0])};
    }
  }
  return std::nullopt;
}

double power(double base, int exponent)
{
  double result = 1;
  for (int i = 0; i < exponent; ++i) {
    result *= base;
  }
  return result;
}

// The number nearest to the decimal of the value with another power of ten: what a user writes in
// g/cm^3 becomes the same double as in kg/m^3.
double timesPowerOfTen(double value, int exponent)
{
  const auto decimal = formatNumber(value);
  const auto e = decimal.find('e');
  const int own = e == std::string::npos ? 0 : readInteger(decimal.substr(e + 1)).value_or(0);
  const auto product = readNumber(decimal.substr(0, e) + "e" + std::to_string(own + exponent));
  return product.value_or(value * std::pow(10., exponent));
}
} // namespace

Unit::Unit(std::string const& text, std::string const& path) : text_(trimmed(text))
{
  if (text_.empty() || text_ == "-") {
    return;
  }
  auto const quotients = split(text_, '/');
  for (std::size_t i = 0; i < quotients.size(); ++i) {
    auto const factors = split(quotients[i], ' ');
    ASPERITY_REQUIRE(i == 0 || factors.size() == 1,
                     path << ": the unit '" << excerpt(text_) << "' has a product after a slash. "
                          << "Write a slash before each symbol that divides, as in W/m/K.");
    const bool is_one = i == 0 && quotients[i] == "1"; // 1/s
    for (auto const& factor : is_one ? std::vector<std::string>() : factors) {
      multiply(factor, i == 0 ? 1 : -1, path);
    }
  }
}

void Unit::multiply(std::string const& factor, int sign, std::string const& path)
{
  const auto caret = factor.find('^');
  const auto found = findSymbol(factor.substr(0, caret));
  const auto exponent =
    caret == std::string::npos ? std::optional<int>(1) : readInteger(factor.substr(caret + 1));
  constexpr int largest = 9;
  ASPERITY_REQUIRE(found && exponent && *exponent != 0 && std::abs(*exponent) <= largest,
                   path << ": the unit '" << excerpt(text_) << "' is unknown"
                        << (factor == text_ ? "" : ", because of '" + excerpt(factor) + "'")
                        << ". Known are m, g, s, K, Pa, N, J, W, Hz, min, h, d and a (365.25 d), "
                           "with the prefixes G, M, k, c, m, u and n where they are common; powers "
                           "as in m^3, products as in 'Pa s', quotients as in kg/m^3.");
  const int count = sign * *exponent;
  auto const& symbol = *found->symbol;
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    powers_[k] += count * symbol.powers[k];
  }
  power_of_ten_ += count * (symbol.power_of_ten + found->power_of_prefix);
  (count > 0 ? numerator_ : denominator_) *= power(symbol.factor, std::abs(count));
}

double Unit::toSi(double value) const
{
  return timesPowerOfTen(value, power_of_ten_) * numerator_ / denominator_;
}
} // namespace asperity
