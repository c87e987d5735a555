#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"
#include "mesh/faults/SplitFaults.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

using namespace asperity::geometry;

// Small meshes in the formats of other programs (other_formats.py), damaged.
namespace
{
class DamagedMesh : public ::testing::Test
{
protected:
  void SetUp() override
  {
    folder_ =
      std::filesystem::temp_directory_path() / ("asperity-meshes-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    ::testing::internal::CaptureStdout(); // remarks on names
    ::testing::internal::CaptureStderr();
  }
  void TearDown() override
  {
    ::testing::internal::GetCapturedStdout();
    ::testing::internal::GetCapturedStderr();
    std::filesystem::remove_all(folder_);
  }

  static std::string content(std::string const& name)
  {
    std::ifstream file(std::string(ASPERITY_SMALL_MESHES) + "/" + name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  // Whether it can be read; if not, the message names the file.
  bool isRead(std::string const& name, std::string const& content) const
  {
    const auto path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << content;
    ReadOptions options;
    if (std::filesystem::path(name).extension() != ".exo" && name != "small.inp") {
      options.own["--array"] = {std::filesystem::path(name).extension() == ".vtk" ? "CellEntityIds"
                                                                                  : "group"};
    }
    try {
      const auto mesh = formatOf(path).format->read(path, options);
      std::visit([&](auto any) { asperity::mesh::splitFaults(any, "'" + path + "'"); }, mesh);
      return true;
    } catch (asperity::InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      return false;
    }
  }

  // Each byte in turn by others, and each length.
  void expectMeshOrMessage(std::string const& name) const
  {
    const auto whole = content(name);
    ASSERT_FALSE(whole.empty());
    ASSERT_TRUE(isRead(name, whole));
    std::size_t num_refused = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      num_refused += isRead(name, whole.substr(0, i)) ? 0 : 1;
      for (const char other : {'\xff', '9', '\0'}) {
        std::string damaged = whole;
        damaged[i] = other;
        num_refused += isRead(name, damaged) ? 0 : 1;
      }
    }
    EXPECT_GT(num_refused, whole.size() / 2);
  }

private:
  std::filesystem::path folder_;
};
} // namespace

TEST_F(DamagedMesh, Exodus) { expectMeshOrMessage("small.exo"); }
TEST_F(DamagedMesh, Abaqus) { expectMeshOrMessage("small.inp"); }
TEST_F(DamagedMesh, VtkAsText) { expectMeshOrMessage("text.vtk"); }
TEST_F(DamagedMesh, VtkAsBinary) { expectMeshOrMessage("binary.vtk"); }
TEST_F(DamagedMesh, VtuAsText) { expectMeshOrMessage("text.vtu"); }
TEST_F(DamagedMesh, VtuAppended) { expectMeshOrMessage("appended.vtu"); }

TEST_F(DamagedMesh, VtuCompressed)
{
  try {
    expectMeshOrMessage("packed.vtu");
  } catch (asperity::InputError const& error) { // a build without zlib
    EXPECT_NE(std::string(error.what()).find("zlib"), std::string::npos);
  }
}
