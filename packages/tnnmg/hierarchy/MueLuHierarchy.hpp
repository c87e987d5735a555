#pragma once

#include "base/Types.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// MueLu's hierarchy of a matrix, which is its level 0; no other class includes MueLu. Throws
// SolveError where MueLu fails; std::bad_alloc is passed on. All is collective.
class MueLuHierarchy
{
public:
  // muelu: a complete list in MueLu's own spelling.
  MueLuHierarchy(RCP<const CrsMatrix> const& A, RCP<const MultiVector> const& near_null_space,
                 Teuchos::ParameterList const& muelu);
  // With the prolongators given, from that of level 1 on; MueLu aggregates nothing.
  MueLuHierarchy(RCP<const CrsMatrix> const& A, std::vector<RCP<const CrsMatrix>> const& P,
                 Teuchos::ParameterList const& muelu);
  ~MueLuHierarchy();
  MueLuHierarchy(MueLuHierarchy&&) noexcept;
  MueLuHierarchy& operator=(MueLuHierarchy&&) noexcept;

  int numLevels() const;
  RCP<const CrsMatrix> prolongator(int level) const; // to the level above, from level 1 on
  RCP<const CrsMatrix> matrix(int level) const;
  // The near null space of a level between the first and the last, if the list has "reuse: type" =
  // "RP".
  RCP<const MultiVector> nearNullSpace(int level) const;

  // One cycle for A z = r that begins with z = 0.
  void apply(MultiVector const& r, MultiVector& z) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace asperity::tnnmg::detail
