#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace asperity
{
// The user's input is at fault; the message says what, where, the allowed range and what to try.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// A solve failed in a way that smaller steps did not cure.
class SolveError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// What a run has computed is of no use, and no restart repairs it: it would go on after what is
// lost.
class UselessRun : public SolveError
{
public:
  using SolveError::SolveError;
};

// A file of the run cannot be written or cannot be read back, because the disk is full or the file
// is damaged. Neither the deck nor a solve is at fault.
class OutputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace asperity

// ASPERITY_REQUIRE(dt > 0, "Time Stepping / Largest Step = " << dt << " is outside (0, inf).")
#define ASPERITY_REQUIRE(condition, message)                                                       \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      std::ostringstream asperity_message;                                                         \
      asperity_message << message;                                                                 \
      throw ::asperity::InputError(asperity_message.str());                                        \
    }                                                                                              \
  } while (false)

// Checks a condition that can only be violated by an error in the program, not in the user's input.
#define ASPERITY_ASSERT(condition)                                                                 \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      std::ostringstream asperity_message;                                                         \
      asperity_message << __FILE__ << ':' << __LINE__ << ": internal error, " #condition           \
                       << " does not hold. Please report it with the deck.";                       \
      throw std::logic_error(asperity_message.str());                                              \
    }                                                                                              \
  } while (false)
