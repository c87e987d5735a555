#pragma once

// Counts the products of sparse matrices (Tpetra's K, M, C and Z) with vectors on this rank during
// its lifetime, by the regions of Kokkos' profiling that Tpetra opens around them. Products in
// V-cycles do not count: they have kernels of their own. Only one object may exist at a time.
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
