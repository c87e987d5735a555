#pragma once

// Counts what this rank multiplies sparse matrices (Tpetra's K, M, C and Z) with vectors while it
// lives, by the regions of Kokkos' profiling that Tpetra opens around them. The V-cycles have
// kernels of their own. One at a time.
class CountedProducts
{
public:
  // To be called before Tpetra is used, which otherwise opens no regions.
  static void prepare();

  CountedProducts();
  ~CountedProducts();
  CountedProducts(CountedProducts const&) = delete;
  CountedProducts& operator=(CountedProducts const&) = delete;

  long long count() const;
};
