#pragma once

#include <array>
#include <string>

namespace asperity
{
// A unit of measurement: powers of m, kg, s and K, times a factor.
class Unit
{
public:
  // Symbols with powers, and a slash before each one that divides: "km", "g/cm^3", "Pa s", "mm/a",
  // "W/m/K"; "-", "1" or nothing is the unit of pure numbers. Symbols are m, g, s, K, Pa, N, J, W,
  // Hz, min, h, d and a (365.25 d), those up to Hz and a with prefixes. InputError with `path` for
  // another one.
  Unit(std::string const& text, std::string const& path);

  // Powers of ten act on the decimal: 2.67 g/cm^3 is the same double as 2670 kg/m^3.
  double toSi(double value) const;

  bool isPureNumber() const { return powers_ == std::array<int, 4>{}; }
  // Of m, kg, s and K.
  std::array<int, 4> const& powers() const { return powers_; }

private:
  void multiply(std::string const& factor, int sign, std::string const& path);

  std::string text_;
  std::array<int, 4> powers_{};
  int power_of_ten_ = 0;
  double numerator_ = 1, denominator_ = 1; // of the factor beside the power of ten
};
} // namespace asperity
