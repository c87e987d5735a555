#pragma once

// Names of entries of the deck's list `Bulk` that its declaration and its readers share.
namespace asperity::scenario::bulk_entries
{
inline constexpr char const* density = "Density";
// Elastic constants of which any two determine the others.
inline constexpr char const* bulk_modulus = "Bulk Modulus";
inline constexpr char const* shear_modulus = "Shear Modulus";
inline constexpr char const* poissons_ratio = "Poisson's Ratio";
// Instead of elastic constants, with the density.
inline constexpr char const* p_wave_speed = "P-Wave Speed";
inline constexpr char const* s_wave_speed = "S-Wave Speed";
inline constexpr char const* law = "Law";
inline constexpr char const* regions = "Regions";
} // namespace asperity::scenario::bulk_entries
