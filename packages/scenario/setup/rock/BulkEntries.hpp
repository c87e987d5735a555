#pragma once

// Names of entries of the deck's list `Bulk` that its declaration and its readers share.
namespace asperity::scenario::bulk_entries
{
// Elastic constants of which any two determine the others.
inline constexpr char const* bulk_modulus = "Bulk Modulus";
inline constexpr char const* shear_modulus = "Shear Modulus";
inline constexpr char const* poissons_ratio = "Poisson's Ratio";
inline constexpr char const* law = "Law";
inline constexpr char const* regions = "Regions";
} // namespace asperity::scenario::bulk_entries
