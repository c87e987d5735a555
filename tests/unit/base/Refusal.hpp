#pragma once

#include "base/Errors.hpp"

#include <Teuchos_Array.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

#include <unistd.h>

namespace asperity::test
{
// The message of the InputError that the call must throw.
template <class Call>
std::string refusal(Call&& call)
{
  try {
    call();
  } catch (InputError const& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

inline void expectParts(std::string const& message, std::initializer_list<std::string> parts)
{
  for (auto const& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  }
}

template <class T>
Teuchos::Array<T> array(std::vector<T> const& values)
{
  return values;
}

// A directory of its own that is removed with its files.
class TemporaryDirectory
{
public:
  TemporaryDirectory()
  {
    static int count = 0;
    const std::string name =
      "asperity_" + std::to_string(::getpid()) + "_" + std::to_string(count++);
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(TemporaryDirectory const&) = delete;
  TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;

  std::string file(std::string const& name) const { return (path_ / name).string(); }

  std::string write(std::string const& name, std::string const& content) const
  {
    std::ofstream(file(name)) << content;
    return file(name);
  }

private:
  std::filesystem::path path_;
};
} // namespace asperity::test
