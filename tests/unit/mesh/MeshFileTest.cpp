#include "MeshSamples.hpp"

#include "mesh/file/MeshFile.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <hdf5.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <utility>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
// A folder of its own for each rank, or one for all of them.
class MeshFile : public ::testing::Test
{
protected:
  void SetUp() override
  {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    folder_ = std::filesystem::temp_directory_path() /
              ("asperity-mesh-file-" + std::to_string(getpid()) + "-" + std::to_string(rank));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(std::string const& name) const { return (folder_ / name).string(); }

  // The square's file with a change, made by HDF5 itself; reading it must fail and print nothing.
  void expectRefused(std::function<void(hid_t)> const& change,
                     std::vector<std::string> pieces) const
  {
    const std::string name = file("changed.h5");
    writeMesh(square(), name);
    const hid_t id = H5Fopen(name.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(id, 0);
    change(id);
    H5Fclose(id);
    expectRefusedFile(name, std::move(pieces));
  }

  template <int Dim = 2>
  void expectRefusedFile(std::string const& name, std::vector<std::string> pieces) const
  {
    pieces.push_back("Mesh file '" + name + "'");
    ::testing::internal::CaptureStderr();
    test::expectRefusal([&] { readMesh<Dim>(name); }, pieces);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  }

private:
  std::filesystem::path folder_;
};

void replace(hid_t file, char const* path, std::vector<hsize_t> const& sizes,
             std::vector<double> const& values, hid_t type)
{
  H5Ldelete(file, path, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, path, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(dataset);
  H5Sclose(space);
}

void setAttribute(hid_t file, char const* name, int value)
{
  const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
  ASSERT_GE(H5Awrite(attribute, H5T_NATIVE_INT, &value), 0);
  H5Aclose(attribute);
}
} // namespace

TEST_F(MeshFile, ReturnsWhatWasWritten)
{
  const auto wedge = wedgeMesh();
  writeMesh(wedge, file("wedge.h5"));
  EXPECT_EQ(meshDimension(file("wedge.h5")), 2);
  expectEqual(readMesh<2>(file("wedge.h5")), wedge);
  EXPECT_FALSE(std::filesystem::exists(file("wedge.h5.part")));

  auto solid = cube();
  solid.boundaries["no facets"] = {};
  orientFacets(solid);
  writeMesh(solid, file("cube.h5"));
  EXPECT_EQ(meshDimension(file("cube.h5")), 3);
  expectEqual(readMesh<3>(file("cube.h5")), solid);
}

TEST_F(MeshFile, KeepsThePeriod)
{
  auto mesh = boxMesh({{1.0, 1.0, 1.0}, {1, 3, 4}, {}});
  makePeriodic(mesh, 1, "bottom", "top");
  makePeriodic(mesh, 2, "front", "back");
  orientFacets(mesh);
  writeMesh(mesh, file("box.h5"));
  expectEqual(readMesh<3>(file("box.h5")), mesh);
  expectRefused(
    [](hid_t id) {
      const hsize_t size = 3;
      const hid_t space = H5Screate_simple(1, &size, nullptr);
      H5Aclose(H5Acreate2(id, "period", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT));
      H5Sclose(space);
    },
    {"'period'", "2 numbers"});
}

TEST_F(MeshFile, OrientsFacets)
{
  auto mesh = square();
  mesh.boundaries["top"] = {{3, 2}};
  writeMesh(mesh, file("square.h5"));
  expectEqual(readMesh<2>(file("square.h5")), square());
}

TEST_F(MeshFile, ReadsOtherTypesOfNumbersAndStrings)
{
  writeMesh(square(), file("square.h5"));
  const hid_t id = H5Fopen(file("square.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  replace(id, "/vertices", {4, 2}, {0, 0, 1, 0, 1, 1, 0, 1}, H5T_IEEE_F32BE);
  replace(id, "/cells", {2, 3}, {0, 1, 2, 0, 2, 3}, H5T_STD_U64LE);
  H5Ldelete(id, "/region_names", H5P_DEFAULT);
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, 12);
  const hsize_t size = 2;
  const hid_t space = H5Screate_simple(1, &size, nullptr);
  const hid_t names =
    H5Dcreate2(id, "/region_names", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(names, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, "right of it\0left of it\0\0");
  H5Dclose(names);
  H5Sclose(space);
  H5Tclose(type);
  H5Fclose(id);
  expectEqual(readMesh<2>(file("square.h5")), square());
}

TEST_F(MeshFile, RefusesMissingAndForeignFiles)
{
  expectRefusedFile(file("none.h5"), {"does not exist"});
  std::ofstream(file("text.h5")) << "This is no HDF5 file.\n";
  expectRefusedFile(file("text.h5"), {"cannot be opened as an HDF5 file"});
  std::ofstream(file("empty.h5")).flush();
  expectRefusedFile(file("empty.h5"), {"cannot be opened as an HDF5 file"});
  H5Fclose(H5Fcreate(file("other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expectRefusedFile(file("other.h5"), {"is no mesh", "'format'"});
  test::expectRefusal([&] { meshDimension(file("other.h5")); }, {"is no mesh"});
}

TEST_F(MeshFile, RefusesTruncatedFiles)
{
  writeMesh(wedgeMesh(), file("cut.h5"));
  const auto size = static_cast<double>(std::filesystem::file_size(file("cut.h5")));
  for (double share : {0.9, 0.5, 0.01}) {
    std::filesystem::resize_file(file("cut.h5"), static_cast<std::uintmax_t>(share * size));
    expectRefusedFile(file("cut.h5"), {"truncated"});
  }
}

TEST_F(MeshFile, RefusesAnotherDimensionOrVersion)
{
  writeMesh(square(), file("square.h5"));
  expectRefusedFile<3>(file("square.h5"), {"dimension 2, not 3"});
  expectRefused([](hid_t id) { setAttribute(id, "version", 2); }, {"version 2", "version 1"});
  expectRefused([](hid_t id) { setAttribute(id, "dimension", 4); }, {"= 4 is neither 2 nor 3"});
}

TEST_F(MeshFile, NamesTheDatasetThatIsWrong)
{
  for (char const* path : {"/vertices", "/cells", "/cell_regions", "/region_names"}) {
    expectRefused([&](hid_t id) { H5Ldelete(id, path, H5P_DEFAULT); },
                  {"has no dataset '" + std::string(path) + "'"});
  }
  expectRefused([](hid_t id) { H5Ldelete(id, "/boundaries", H5P_DEFAULT); },
                {"has no group '/boundaries'"});
  expectRefused([](hid_t id) { H5Ldelete(id, "/boundaries/top/facets", H5P_DEFAULT); },
                {"has no dataset '/boundaries/top/facets'"});
  expectRefused(
    [](hid_t id) { replace(id, "/vertices", {8}, std::vector<double>(8), H5T_IEEE_F64LE); },
    {"'/vertices' does not have the shape (n, 2)"});
  expectRefused(
    [](hid_t id) {
      replace(id, "/cells", {2, 3}, {0, 1, 2, 0, 2, 3}, H5T_IEEE_F64LE);
    },
    {"'/cells' does not consist of integers"});
  expectRefused(
    [](hid_t id) {
      replace(id, "/region_names", {2}, {0, 1}, H5T_STD_I32LE);
    },
    {"'/region_names' is not a list of strings"});
}

TEST_F(MeshFile, RefusesWhatIsNoMesh)
{
  const auto with_cells = [](std::vector<double> const& cells) {
    return [=](hid_t id) { replace(id, "/cells", {2, 3}, cells, H5T_STD_I32LE); };
  };
  expectRefused(with_cells({0, 1, 2, 0, 2, 4}), {"cell 1 has vertex 4, outside [0, 4)"});
  expectRefused(with_cells({0, 1, 2, 0, 2, -1}), {"cell 1 has vertex -1"});
  expectRefused(with_cells({0, 1, 2, 0, 3, 2}), {"cell 1", "(0, 0), (0, 1), (1, 1)", "inverted"});
  expectRefused(
    [](hid_t id) {
      replace(id, "/cell_regions", {2}, {0, 7}, H5T_STD_I32LE);
    },
    {"cell 1 has region 7"});
  expectRefused(
    [](hid_t id) {
      replace(id, "/boundaries/top/facets", {1, 2}, {1, 3}, H5T_STD_I32LE);
    },
    {"'top'", "is not a facet of any cell"});
  // Numbers beyond 32 bits do not wrap around into the allowed range.
  expectRefused(
    [](hid_t id) {
      replace(id, "/cells", {2, 3}, {4294967296.0, 1, 2, 0, 2, 3}, H5T_STD_I64LE);
    },
    {"cell 0 has vertex 2147483647"});
}

TEST_F(MeshFile, SaysThatItCannotWrite)
{
  ::testing::internal::CaptureStderr();
  test::expectRefusal([&] { writeMesh(square(), file("no folder/square.h5")); },
                      {"no folder/square.h5", "cannot be written", "folder"});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  auto mesh = square();
  mesh.boundaries["a/b"] = {{0, 1}};
  test::expectRefusal([&] { writeMesh(mesh, file("square.h5")); }, {"'a/b'", "name of a boundary"});
  EXPECT_FALSE(std::filesystem::exists(file("square.h5")));
}

// The file of rank 0 is not there for the others; all return the same or throw the same.
TEST_F(MeshFile, IsReadOnRankZeroForAll)
{
  const Teuchos::MpiComm<int> world(MPI_COMM_WORLD);
  auto periodic = boxMesh({{1.0, 1.0, 1.0}, {1, 3, 1}, {}});
  makePeriodic(periodic, 1, "bottom", "top");
  orientFacets(periodic);
  if (world.getRank() == 0) {
    writeMesh(square(), file("square.h5"));
    writeMesh(periodic, file("periodic.h5"));
  }
  expectEqual(readMesh<3>(file("periodic.h5"), world), periodic);
  expectEqual(readMesh<2>(file("square.h5"), world), square());
  test::expectRefusal([&] { readMesh<3>(file("square.h5"), world); }, {"dimension 2, not 3"});
  test::expectRefusal([&] { readMesh<2>(file("none.h5"), world); }, {"none.h5' does not exist"});
}
