#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace asperity::tnnmg::detail
{
// Of the pages that Trilinos throws, what tells a user something, in one line.
std::string complaint(std::string const& thrown);

// MueLuCorrection::requireAccepted
void tryParameters(Teuchos::ParameterList const& parameters);
} // namespace asperity::tnnmg::detail
