#include "scenario/fields/BodyFields.hpp"

#include "catalogue/stress/StressFields.hpp"
#include "fem/inelastic/InelasticCells.hpp"

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

template <int Dim>
dynamics::VertexMotion vertexMotion(Problem<Dim> const& problem, RunView const& view,
                                    std::vector<int> const& vertices,
                                    std::shared_ptr<dynamics::RecoveryRows> const& rows = nullptr)
{
  constexpr bool with_ghosts = false;
  return {problem.model.body, problem.discretisation.frames(),
          vertices,           with_ghosts,
          view.condensation,  rows};
}

catalogue::VertexFields motionAt(dynamics::VertexMotion const& vertices,
                                 dynamics::State const& state, bool with_velocity)
{
  catalogue::VertexFields motion = {
    vertices(*state.u), with_velocity ? vertices(*state.v) : Values(), {}};
  for (auto const& branch : state.branches) {
    motion.branches.push_back(vertices(*branch));
  }
  return motion;
}

// Returns what local cells have yielded: zero in elastic cells, empty if no cell can yield.
template <int Dim>
std::function<catalogue::YieldedStrain(std::vector<int> const&)>
yieldedStrain(Problem<Dim> const& problem, RunView const& view)
{
  auto const cells = problem.model.body.cells;
  if (!cells) {
    return {};
  }
  return [rows = cells->sharing().rowsOfMesh(problem.mesh().cells.size()),
          columns = cells->history(), &view](std::vector<int> const& of_cells) {
    auto const strain = toHost(view.state->inelastic->strain);
    auto const shear = toHost(view.state->inelastic->shear);
    auto const history = toHost(view.state->inelastic->history);
    catalogue::YieldedStrain result;
    for (auto const& each : columns) {
      auto& values = result.history[each.variable.name];
      for (const int cell : of_cells) {
        for (int k = each.first; k < each.first + each.width; ++k) {
          values.push_back(rows[cell] < 0 ? 0 : history(rows[cell], k));
        }
      }
    }
    for (const int cell : of_cells) {
      for (int k = 0; k < strain.extent_int(1); ++k) {
        result.strain.push_back(rows[cell] < 0 ? 0 : strain(rows[cell], k));
      }
      result.shear.push_back(rows[cell] < 0 ? 0 : shear(rows[cell], 0));
    }
    return result;
  };
}
} // namespace

template <int Dim>
void registerMotion(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    io::OutputDomain const& domain)
{
  struct Motion
  {
    char const* name;
    char const* unit;
    char const* description;
    RCP<Vector> dynamics::State::*vector;
  };
  static const Motion motions[] = {
    {"displacement", "m", "Displacement along the axes.", &dynamics::State::u},
    {"velocity", "m/s", "Velocity along the axes.", &dynamics::State::v},
    {"acceleration", "m/s^2", "Acceleration along the axes.", &dynamics::State::a}};
  for (auto const& motion : motions) {
    auto const vector = motion.vector;
    io::OutputField field{motion.name,
                          motion.unit,
                          motion.description,
                          domain.name,
                          problem.components(),
                          [&problem, &view, &domain, vector](Values& values) {
                            values =
                              vertexMotion(problem, view, domain.vertices)(*(view.state->*vector));
                          }};
    if (view.recovery_rows) {
      field.at = [&problem, &view, &domain, vector](std::vector<std::size_t> const& places) {
        std::vector<int> vertices;
        for (const std::size_t place : places) {
          vertices.push_back(domain.vertices[place]);
        }
        return io::OutputField::Values(
          [&view, vector, at = vertexMotion(problem, view, vertices, view.recovery_rows)](
            Values& values) { values = at(*(view.state->*vector)); });
      };
    }
    registry.add(std::move(field));
  }
}

template <int Dim>
void registerStress(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    Domains const& domains, std::map<std::string, fem::CoulombPlane> const& planes)
{
  auto const observe = [&problem, &view](std::vector<int> const& vertices, bool are_few) {
    constexpr bool with_ghosts = true;
    auto const& frames = problem.discretisation.frames();
    const dynamics::VertexMotion now(problem.model.body, frames, vertices, with_ghosts,
                                     view.condensation, are_few ? view.recovery_rows : nullptr);
    const dynamics::VertexMotion initial(problem.model.body, frames, vertices, with_ghosts);
    return catalogue::VertexFieldSource{
      [=, &view](bool with_velocity) { return motionAt(now, *view.state, with_velocity); },
      [=, &problem](bool with_velocity) {
        return motionAt(initial, problem.model.initial, with_velocity);
      }};
  };
  const catalogue::StressedBody<Dim> body{problem.mesh(),
                                          problem.components(),
                                          problem.discretisation.rock.materials,
                                          problem.discretisation.rock.branches,
                                          problem.discretisation.patches,
                                          problem.discretisation.boundary.surface,
                                          observe,
                                          yieldedStrain(problem, view),
                                          problem.model.body.cells
                                            ? problem.model.body.cells->history()
                                            : std::vector<fem::HistoryColumns>()};
  for (auto const& [name, domain] : domains) {
    if (name != "fault") {
      catalogue::registerStressFields(registry, domain, body, planes);
    }
  }
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template void registerMotion(io::FieldRegistry&, Problem<Dim> const&, RunView const&,            \
                               io::OutputDomain const&);                                           \
  template void registerStress(io::FieldRegistry&, Problem<Dim> const&, RunView const&,            \
                               Domains const&, std::map<std::string, fem::CoulombPlane> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
