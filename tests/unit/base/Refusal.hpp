#pragma once

#include "base/Errors.hpp"

#include <Teuchos_Array.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity::test
{
// The message of the error that the call must throw.
template <class Error = InputError, class Call>
std::string refusal(Call&& call)
{
  try {
    call();
  } catch (Error const& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

inline void expectParts(std::string const& message, std::vector<std::string> const& parts)
{
  for (auto const& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  }
}

// Expects that the call throws such an error, whose message has all the parts.
template <class Error = InputError, class Call>
void expectRefusal(Call&& call, std::vector<std::string> const& parts)
{
  expectParts(refusal<Error>(call), parts);
}

template <class T>
Teuchos::Array<T> array(std::vector<T> const& values)
{
  return values;
}
} // namespace asperity::test
