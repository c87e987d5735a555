#pragma once

#include <string>

namespace asperity::fuzz
{
// The name of a file of this process, in memory where the system has such a place. It is not made
// yet, and is removed with the object.
class Scratch
{
public:
  explicit Scratch(std::string const& name);
  ~Scratch();
  Scratch(Scratch const&) = delete;
  Scratch& operator=(Scratch const&) = delete;

  std::string const& path() const { return path_; }
  void write(std::string const& bytes) const;

private:
  std::string path_;
};
} // namespace asperity::fuzz
