#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace asperity::tnnmg::detail
{
// Returns, in one line, the part of a long Trilinos error message that helps a user.
std::string complaint(std::string const& thrown);

// Implements MueLuCorrection::requireAccepted.
void tryParameters(Teuchos::ParameterList const& parameters);
} // namespace asperity::tnnmg::detail
