#pragma once

#include "io/Output.hpp"

namespace asperity::io
{
// Additional text files in a form that other people's tools read. A text format is a word of the
// choice `Text Format` in the deck's list `Output`, and has a list of the same name there:
//   ASPERITY_REGISTER(TextFormatRegistry, "SEAS", Seas)
class TextFormat
{
public:
  static constexpr char const* registered_as = "text format";
  virtual ~TextFormat() = default;

  virtual Teuchos::RCP<const Teuchos::ParameterList> validParameters() const = 0;

  // As Output::files.
  virtual std::vector<std::string> files() const = 0;

  // An output that is called after all others of the run and may read what they offer.
  // `parameters` has been completed and validated. Collective.
  virtual std::unique_ptr<Output> make(Teuchos::ParameterList const& parameters,
                                       OutputContext const& context,
                                       Offers const& offers) const = 0;
};

using TextFormatRegistry = Registry<TextFormat>;
} // namespace asperity::io
