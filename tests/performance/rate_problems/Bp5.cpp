#include "performance/rate_problems/Bp5.hpp"

#include "dynamics/fault/FaultMotion.hpp"
#include "scenario/DeckReader.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::performance
{
RCP<ParameterList> bp5(int cell_size, std::vector<std::string> overrides)
{
  CommandLine line;
  line.deck = ASPERITY_DECKS "/bp5_qd.xml";
  line.overrides = std::move(overrides);
  line.overrides.push_back("TNNMG/Linear Correction=Multigrid");
  line.overrides.push_back("Mesh/Box/Cell Size Factor=" + std::to_string(cell_size));
  return scenario::readCompleteDeck(line);
}

void addFrictionForces(fem::FaultSurface const& surface, dynamics::FrictionProblem const& friction,
                       Vector const& v, Vector& b)
{
  const int num_nodes = surface.numNodes(), size = surface.numTangents();
  const BlockView at_nodes("v", num_nodes, size);
  const BlockView gradient("gradient", num_nodes, size);
  const HessianView hessian("hessian", num_nodes, size, size);
  const FlagView kinked("kinked", num_nodes);
  dynamics::gather(surface, v, at_nodes);
  friction.linearise(at_nodes, gradient, hessian, kinked);
  auto const values = b.getLocalViewHost(Tpetra::Access::ReadWrite);
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gradient);
  for (int node = 0; node < num_nodes; ++node) {
    for (int k = 0; k < size; ++k) {
      values(surface[node].dofs[k], 0) += host(node, k);
    }
  }
}
} // namespace asperity::performance
