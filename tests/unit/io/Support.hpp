#pragma once

#include "base/Types.hpp"
#include "mesh/Mesh.hpp"
#include "unit/base/Refusal.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultComm.hpp>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace asperity::test
{
inline RCP<const Communicator> world() { return Teuchos::DefaultComm<int>::getComm(); }

// A new folder, the same on all ranks, removed at the end.
class TemporaryDirectory
{
public:
  TemporaryDirectory()
  {
    char name[] = "/tmp/asperity_io_XXXXXX";
    if (world()->getRank() == 0 && ::mkdtemp(name) == nullptr) {
      throw std::runtime_error("no temporary directory");
    }
    Teuchos::broadcast(*world(), 0, static_cast<int>(sizeof name), name);
    path_ = name;
  }
  ~TemporaryDirectory()
  {
    world()->barrier();
    if (world()->getRank() == 0) {
      std::filesystem::remove_all(path_);
    }
  }
  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path operator/(std::string const& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

inline std::string contents(std::filesystem::path const& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void write(std::filesystem::path const& file, std::string const& text)
{
  if (world()->getRank() == 0) {
    std::ofstream(file, std::ios::binary) << text;
  }
  world()->barrier();
}

// Runs on rank 0 between two barriers.
template <class Work>
void onRankZero(Work const& work)
{
  world()->barrier();
  if (world()->getRank() == 0) {
    work();
  }
  world()->barrier();
}

inline bool contains(std::string const& text, std::string const& part)
{
  return text.find(part) != std::string::npos;
}

// A strip of unit height over 0 <= x <= 1: num_base vertices on the boundary `base` (y = 0), as
// many on `surface` (y = 1), spacing growing with x: x_i = (i / (num_base - 1))^2. Global ids run
// against x, and the ranks own the vertices by turns, so that no order agrees with another by
// accident.
Mesh<2> stripMesh(int num_base);
// The strip sheared, so that its base dips to the right, from (0, 0) to (1, -1).
Mesh<2> dippingStrip(int num_base);
// The strip turned, so that its base is the line from (0, -1) up to (0, 0).
Mesh<2> uprightStrip(int num_base);

// x of the base vertex i, counted from x = 0.
inline double stripPosition(int i, int num_base)
{
  const double s = static_cast<double>(i) / (num_base - 1);
  return s * s;
}
} // namespace asperity::test
