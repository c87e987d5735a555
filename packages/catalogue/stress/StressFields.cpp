#include "catalogue/stress/StressFields.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/stress/CellStress.hpp"

#include <memory>
#include <optional>

namespace asperity::catalogue
{
namespace
{
// Stress and strain in some cells, as their vertices move.
template <int Dim>
class ObservedStress
{
public:
  ObservedStress(StressedBody<Dim> const& body, std::vector<int> const& cells, bool are_few,
                 Communicator const& comm)
      : cells_(cells)
      , stress_(body.mesh, body.components, body.materials, cells, body.branches, body.patches)
      , motions_(body.observe(stress_.vertices(), are_few))
      , is_viscous_(maxOverRanks(stress_.isViscous() ? 1 : 0, comm) > 0)
      , yielded_(body.yielded)
  {
    for (const int cell : cells) {
      materials_.push_back(body.materials[cell]);
    }
  }

  YieldedStrain yielded() const { return yielded_(cells_); }

  std::vector<double> strain() const { return stress_.strain(motions_.now(false).displacement); }

  std::vector<double> stress() const { return observed(motions_.now(is_viscous_)); }

  // Stress is linear in the motion.
  std::vector<double> stressSinceStart() const
  {
    auto motion = motions_.now(is_viscous_);
    auto const start = motions_.at_start(is_viscous_);
    subtract(start.displacement, motion.displacement);
    subtract(start.velocity, motion.velocity);
    for (std::size_t k = 0; k < motion.branches.size(); ++k) {
      subtract(start.branches[k], motion.branches[k]);
    }
    return observed(motion);
  }

private:
  std::vector<double> observed(VertexFields const& motion) const
  {
    auto stress = stress_.stress(motion.displacement, motion.velocity, motion.branches);
    if (yielded_) {
      fem::subtractStress(materials_, yielded_(cells_).strain, stress);
    }
    return stress;
  }

  static void subtract(std::vector<double> const& then, std::vector<double>& now)
  {
    for (std::size_t i = 0; i < now.size(); ++i) {
      now[i] -= then[i];
    }
  }

  std::vector<int> cells_;
  fem::CellStress<Dim> stress_;
  VertexFieldSource motions_;
  bool is_viscous_; // on any rank: evaluating velocities is collective
  std::function<YieldedStrain(std::vector<int> const&)> yielded_;
  std::vector<fem::Material> materials_; // (cells)
};

// The stress in the elements of a domain; that of all elements is made when it is wanted.
template <int Dim>
class DomainStress
{
public:
  DomainStress(StressedBody<Dim> const& body, io::OutputDomain const& domain)
      : body_(body)
      , domain_(domain)
  {
  }

  ObservedStress<Dim> const& everywhere()
  {
    if (!everywhere_) {
      everywhere_.emplace(body_, cells(), false, *domain_.comm);
    }
    return *everywhere_;
  }

  ObservedStress<Dim> at(std::vector<std::size_t> const& elements) const
  {
    auto const all = cells();
    std::vector<int> chosen;
    for (const std::size_t element : elements) {
      chosen.push_back(all[element]);
    }
    return {body_, chosen, true, *domain_.comm};
  }

private:
  // (num_owned_elements) the cell that each one is, or that it bounds.
  std::vector<int> cells() const
  {
    if (domain_.nodes_per_element == Dim + 1) {
      return domain_.numbers_in_mesh;
    }
    auto const beside = fem::cellsBeside(body_.mesh, body_.surface);
    std::vector<int> result;
    for (const int facet : domain_.numbers_in_mesh) {
      result.push_back(beside[facet]);
    }
    return result;
  }

  StressedBody<Dim> body_;
  io::OutputDomain const& domain_;
  std::optional<ObservedStress<Dim>> everywhere_;
};

// evaluate(ObservedStress) fills the field.
template <int Dim, class Evaluate>
void add(io::FieldRegistry& registry, io::OutputField field,
         std::shared_ptr<DomainStress<Dim>> const& stress, Evaluate const& evaluate)
{
  field.centring = io::Centring::elements;
  field.values = [stress, evaluate](std::vector<double>& values) {
    values = evaluate(stress->everywhere());
  };
  field.at = [stress, evaluate](std::vector<std::size_t> const& elements) {
    return io::OutputField::Values(
      [of_elements = stress->at(elements), evaluate](std::vector<double>& values) {
        values = evaluate(of_elements);
      });
  };
  registry.add(std::move(field));
}

void requireLoaded(std::string const& name, fem::CoulombPlane const& plane, int components)
{
  ASPERITY_REQUIRE(plane.isLoaded(components),
                   "Asperity / Output / Coulomb Planes / "
                     << name
                     << ": no stress of this model acts along its rake, so that the Coulomb "
                        "stress change would be zero. In antiplane models take a rake of 90 or "
                        "-90; in plane strain one of 0 or 180, or a friction above 0.");
}
} // namespace

template <int Dim>
void registerStressFields(io::FieldRegistry& registry, io::OutputDomain const& domain,
                          StressedBody<Dim> const& body,
                          std::map<std::string, fem::CoulombPlane> const& planes)
{
  using Observed = ObservedStress<Dim>;
  auto const stress = std::make_shared<DomainStress<Dim>>(body, domain);
  const int components = body.components;
  auto const tensor = [&](std::string const& name, std::string const& unit,
                          std::string const& meaning, auto const& evaluate) {
    auto const& names = fem::tensorComponents(components);
    io::OutputField field{name, unit, meaning, domain.name, static_cast<int>(names.size()), {}};
    field.component_names = names;
    add(registry, std::move(field), stress, evaluate);
  };
  auto const number = [&](std::string const& name, std::string const& unit,
                          std::string const& meaning, auto const& evaluate) {
    add(registry, {name, unit, meaning, domain.name, 1, {}}, stress, evaluate);
  };

  tensor("stress", "Pa",
         "Elastic and viscous stress in each element, positive in tension; without the deck's "
         "Shear Traction and Normal Stress.",
         [](Observed const& observed) { return observed.stress(); });
  tensor("strain", "", "Strain in each element, positive in extension.",
         [](Observed const& observed) { return observed.strain(); });
  if (body.yielded) {
    tensor("inelastic_strain", "", "Strain of each element that remains without stress.",
           [](Observed const& observed) { return observed.yielded().strain; });
    number("inelastic_shear", "",
           "Accumulated inelastic shear strain in each element, the integral of sqrt(2 e' : e').",
           [](Observed const& observed) { return observed.yielded().shear; });
  }
  for (auto const& [variable, first, width] : body.history) {
    auto const values = [name = std::string(variable.name)](Observed const& observed) {
      return observed.yielded().history.at(name);
    };
    if (width > 1) {
      tensor(variable.name, variable.unit, variable.meaning, values);
    } else {
      number(variable.name, variable.unit, variable.meaning, values);
    }
  }
  for (auto const& [name, plane] : planes) {
    requireLoaded(name, plane, components);
    number(coulombField(name), "Pa",
           "Change of the Coulomb stress since the start of the run on the plane " + name +
             ", in each element; positive is nearer to failure.",
           [components, plane = plane](Observed const& observed) {
             return plane.stress(observed.stressSinceStart(), components);
           });
  }
}

template void registerStressFields(io::FieldRegistry&, io::OutputDomain const&,
                                   StressedBody<2> const&,
                                   std::map<std::string, fem::CoulombPlane> const&);
template void registerStressFields(io::FieldRegistry&, io::OutputDomain const&,
                                   StressedBody<3> const&,
                                   std::map<std::string, fem::CoulombPlane> const&);
} // namespace asperity::catalogue
