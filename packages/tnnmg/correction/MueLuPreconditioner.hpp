#pragma once

#include "tnnmg/correction/Preconditioner.hpp"
#include "tnnmg/hierarchy/MueLuHierarchy.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// MueLu's own cycle, in double precision: the reference for OwnPreconditioner. Its matrix is
// that of the last set-up, Z + H without the couplings of nodes that are removed or stiff, that is,
// whose friction exceeds their block B of Z. A node that is stiff now has (B + H)^-1 instead of the
// cycle, so that no stiff node holds a coarse function.
class MueLuPreconditioner final : public Preconditioner
{
public:
  // P: the prolongators, from that of level 1 on; muelu: the complete list of the cycle.
  MueLuPreconditioner(std::vector<RCP<const CrsMatrix>> P, Teuchos::ParameterList muelu,
                      RCP<const CrsMatrix> Z, std::shared_ptr<const MultigridNodes> nodes);

  void setup() override;
  void rebuild() override;
  std::size_t bytes() const override;

  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

private:
  RCP<const CrsMatrix> withHessians() const;

  std::vector<RCP<const CrsMatrix>> P_;
  Teuchos::ParameterList muelu_;
  MueLuHierarchy cycle_;
};
} // namespace asperity::tnnmg::detail
