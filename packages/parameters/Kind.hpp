#pragma once

#include "registry/Registry.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <string>

namespace asperity
{
// A kind of thing that a deck chooses by the name of its list, and how it is made from the list and
// what it works with. A class derived from it says in `registered_as` what messages call it.
template <class Product_, class Context_>
class Kind
{
public:
  using Product = Product_;
  using Context = Context_;
  virtual ~Kind() = default;

  virtual Teuchos::RCP<const Teuchos::ParameterList> validParameters() const = 0;
  virtual std::string meaning() const = 0; // a sentence for the list of parameters
  // `parameters` has been completed and validated. Collective.
  virtual std::unique_ptr<Product> make(Teuchos::ParameterList const& parameters,
                                        Context const& context) const = 0;
};

// The kind of a class that has static validParameters(), static meaning() and a constructor
// (ParameterList const&, Context const&).
template <class Base, class Type>
class KindOf : public Base
{
public:
  Teuchos::RCP<const Teuchos::ParameterList> validParameters() const override
  {
    return Type::validParameters();
  }
  std::string meaning() const override { return Type::meaning(); }
  std::unique_ptr<typename Base::Product> make(Teuchos::ParameterList const& parameters,
                                               typename Base::Context const& context) const override
  {
    return std::make_unique<Type>(parameters, context);
  }
};
} // namespace asperity
