#include "scenario/fields/LockedFields.hpp"

#include "base/Errors.hpp"
#include "dynamics/observables/LockedResponse.hpp"
#include "fem/motions/FreeMotions.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace asperity::scenario
{
namespace
{
using Response = RCP<Vector> (dynamics::LockedResponse::*)(dynamics::State const&);

// The solver of all responses, made when the first is wanted.
template <int Dim>
class LockedBody
{
public:
  explicit LockedBody(Problem<Dim> const& problem) : problem_(problem) {}

  dynamics::LockedResponse& response(std::string const& field)
  {
    if (!response_) {
      requireHeld(field);
      response_.emplace(problem_.model.body, problem_.surface(), problem_.solver);
    }
    return *response_;
  }

private:
  void requireHeld(std::string const& field) const
  {
    auto const locked = dynamics::lockedAt(problem_.surface(), problem_.model.body);
    std::vector<int> held(locked.numOwnedDofs(), 0);
    for (const int dof : locked.held.owned()) {
      held[dof] = 1;
    }
    auto const free = fem::freeMotions(problem_.mesh(), problem_.components(),
                                       *locked.near_null_space, held, problem_.communicator);
    ASPERITY_REQUIRE(free.empty(), "Asperity / Output: the field "
                                     << field
                                     << " does not exist, because nothing holds the body when it "
                                        "moves "
                                     << free.front()
                                     << " while its fault is locked. Leave the field out, or add a "
                                        "condition on a boundary that stops this motion.");
  }

  Problem<Dim> const& problem_;
  std::optional<dynamics::LockedResponse> response_;
};

// One response, solved once for each time at which it is written.
template <int Dim>
class ResponseInTime
{
public:
  ResponseInTime(std::shared_ptr<LockedBody<Dim>> body, std::string field, Response response)
      : body_(std::move(body))
      , field_(std::move(field))
      , response_(response)
  {
  }

  Vector const& at(dynamics::State const& state)
  {
    if (time_ != state.time) {
      displacement_ = (body_->response(field_).*response_)(state);
      time_ = state.time;
    }
    return *displacement_;
  }

private:
  std::shared_ptr<LockedBody<Dim>> body_;
  std::string field_;
  Response response_;
  std::optional<dynamics::DyadicTime::Ticks> time_;
  RCP<Vector> displacement_;
};

template <int Dim>
void add(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
         Domains const& domains, io::OutputField field,
         std::shared_ptr<ResponseInTime<Dim>> const& response)
{
  field.unit = "m";
  field.components = problem.components();
  for (auto const& [name, domain] : domains) {
    if (name == "fault") {
      continue;
    }
    field.domain = name;
    field.values = [&problem, &view, &vertices = domain.vertices,
                    response](std::vector<double>& values) {
      constexpr bool with_ghosts = false;
      values = dynamics::VertexMotion(problem.model.body, problem.discretisation.frames(), vertices,
                                      with_ghosts)(response->at(*view.state));
    };
    registry.add(field);
  }
}
} // namespace

template <int Dim>
void registerLockedResponse(io::FieldRegistry& registry, Problem<Dim> const& problem,
                            RunView const& view, Domains const& domains)
{
  auto const body = std::make_shared<LockedBody<Dim>>(problem);
  auto const offer = [&](char const* name, std::string const& cause, Response response) {
    add(registry, problem, view, domains,
        {name,
         "",
         "Displacement along the axes that follows from " + cause +
           " alone: the elastic response to it while the fault is locked.",
         "",
         0,
         {}},
        std::make_shared<ResponseInTime<Dim>>(body, name, response));
  };
  if (!problem.model.body.matrices.branches.empty()) {
    offer("viscous_displacement", "the flow of Maxwell's and Burgers' rock",
          &dynamics::LockedResponse::toFlow);
  }
  if (problem.model.body.cells) {
    offer("inelastic_displacement", "the inelastic strain of rock that yields or creeps",
          &dynamics::LockedResponse::toInelasticStrain);
  }
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template void registerLockedResponse(io::FieldRegistry&, Problem<Dim> const&, RunView const&,    \
                                       Domains const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
