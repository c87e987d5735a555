#include "measuring/CountedProducts.hpp"

#include <Kokkos_Core.hpp>

#include <cstdlib>
#include <string_view>

namespace
{
long long products = 0;

void countRegion(char const* name)
{
  products += std::string_view(name) == "Tpetra::CrsMatrix::localApply" ? 1 : 0;
}
} // namespace

void CountedProducts::prepare() { setenv("TPETRA_USE_KOKKOS_PROFILING", "1", 1); }

CountedProducts::CountedProducts()
{
  products = 0;
  Kokkos::Tools::Experimental::set_push_region_callback(countRegion);
}

CountedProducts::~CountedProducts()
{
  Kokkos::Tools::Experimental::set_push_region_callback(nullptr);
}

long long CountedProducts::count() const { return products; }
