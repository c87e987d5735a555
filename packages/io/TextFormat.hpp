#pragma once

#include "io/Output.hpp"

namespace asperity::io
{
// Files in text besides the others, in a form that somebody else's tools read. A text format is a
// word of the choice `Text Format` in the deck's list `Output`, and has the list of that name:
//   ASPERITY_REGISTER(TextFormatRegistry, "SEAS", Seas)
class TextFormat
{
public:
  virtual ~TextFormat() = default;

  virtual Teuchos::RCP<const Teuchos::ParameterList> validParameters() const = 0;

  // As Output has them.
  virtual std::vector<std::string> files() const = 0;

  // An output that is called after all others of the run and may read what they offer.
  // `parameters` has been completed and validated. Collective.
  virtual std::unique_ptr<Output> make(Teuchos::ParameterList const& parameters,
                                       OutputContext const& context,
                                       Offers const& offers) const = 0;
};

using TextFormatRegistry = Registry<TextFormat>;
} // namespace asperity::io
