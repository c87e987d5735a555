#include "MeshSamples.hpp"
#include "SharedFolder.hpp"

#include "hdf5/Handle.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"
#include "mesh/file/detail/PartitionFormat.hpp"
#include "mesh/generation/BoxMesh.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <hdf5.h>

#include <fstream>
#include <functional>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
// Collective, as a new communicator is.
RCP<const Communicator> world() { return rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)); }

std::string onRankZero(std::string text)
{
  auto size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

// HDF5's name of a number, or of the numbers in a row.
hid_t nativeType(double) { return H5T_NATIVE_DOUBLE; }
hid_t nativeType(int) { return H5T_NATIVE_INT; }
hid_t nativeType(long long) { return H5T_NATIVE_LLONG; }
hid_t nativeType(std::uint64_t) { return H5T_NATIVE_UINT64; }
template <class Number, std::size_t N>
hid_t nativeType(std::array<Number, N> const&)
{
  return nativeType(Number());
}

template <class Row>
std::vector<Row> read(hid_t file, std::string const& path)
{
  const h5::Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const h5::Handle space(H5Dget_space(dataset.get()), H5Sclose);
  hsize_t sizes[2] = {0, 0};
  H5Sget_simple_extent_dims(space.get(), sizes, nullptr);
  std::vector<Row> rows(sizes[0]);
  const hid_t type = nativeType(Row());
  EXPECT_GE(H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
  return rows;
}

template <class Row>
void overwrite(hid_t file, std::string const& path, std::vector<Row> const& rows)
{
  const h5::Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const hid_t type = nativeType(Row());
  EXPECT_GE(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
}

void setAttribute(hid_t file, char const* name, int value)
{
  const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
  EXPECT_GE(H5Awrite(attribute, H5T_NATIVE_INT, &value), 0);
  H5Aclose(attribute);
}

// A box of two parts or more, as many as there are ranks; the last rank finds the damage where only
// one can.
class DamagedPartition : public SharedFolder
{
protected:
  // With a fault through its middle.
  GlobalMesh<3> box() const
  {
    auto mesh = boxMesh({{1.0, 1.0, 2.0}, {4, 3, 6}, {0.0, 0.0, 0.0}});
    addFaults<3>(mesh, {{"fault", [](Point<3> const& x) { return x[0] == 0.5; }}});
    splitFaults(mesh, "test");
    return mesh;
  }
  int numRanks() const { return world()->getSize(); }
  std::string name() const { return file("box.h5"); }

  void write(GlobalMesh<3> const& mesh, int num_parts) const
  {
    onFirstRank([&] {
      writeParts(mesh, partitionVertices(mesh, num_parts, {"bottom", 4}), num_parts, {"bottom", 4},
                 name());
    });
  }

  // Every rank throws, with the same message, and HDF5 prints nothing.
  template <int Dim = 3>
  void expectRefused(std::vector<std::string> const& pieces) const
  {
    ::testing::internal::CaptureStderr();
    const auto message = test::refusal([&] { readPart<Dim>(name(), world()); });
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    test::expectParts(message, pieces);
    test::expectParts(message, {"Mesh file '" + name() + "'"});
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message, onRankZero(message));
  }

  void change(std::function<void(hid_t)> const& work) const
  {
    onFirstRank([&] {
      const hid_t id = H5Fopen(name().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
      ASSERT_GE(id, 0);
      work(id);
      H5Fclose(id);
    });
  }

  void expectChangeRefused(std::function<void(hid_t)> const& work,
                           std::vector<std::string> const& pieces) const
  {
    write(box(), numRanks());
    change(work);
    expectRefused(pieces);
    test::expectRefusal([&] { readParts<3>(name()); }, {"Mesh file '" + name() + "'"});
    MPI_Barrier(MPI_COMM_WORLD);
  }

  // Changes the rows of a dataset, the last of which belong to the last part.
  template <class Row>
  void expectDatasetRefused(std::string const& path,
                            std::function<void(std::vector<Row>&)> const& work,
                            std::vector<std::string> const& pieces) const
  {
    expectChangeRefused(
      [&](hid_t file) {
        auto rows = read<Row>(file, path);
        work(rows);
        overwrite(file, path, rows);
      },
      pieces);
  }

  // Changes the rows of the last part and gives them the right checksum, as a program would write
  // it that errs.
  template <class Row>
  void expectRowsRefused(std::string const& array,
                         std::function<void(std::vector<Row>&)> const& work,
                         std::vector<std::string> const& pieces) const
  {
    const int last = numRanks() - 1;
    expectChangeRefused(
      [&](hid_t file) {
        const auto offsets = read<long long>(file, array + "/offsets");
        auto all = read<Row>(file, array + "/values");
        auto checksums = read<std::uint64_t>(file, array + "/checksums");
        const auto first = all.begin() + offsets[static_cast<std::size_t>(last)];
        std::vector<Row> rows(first, all.end());
        work(rows);
        std::copy(rows.begin(), rows.end(), first);
        checksums.back() = detail::partChecksum(seed_, array, last, rows);
        overwrite(file, array + "/values", all);
        overwrite(file, array + "/checksums", checksums);
      },
      pieces);
  }

  void rememberSeed()
  {
    write(box(), numRanks());
    seed_ = detail::seedOf(partitionSummary(name()));
    MPI_Barrier(MPI_COMM_WORLD);
  }

private:
  std::uint64_t seed_ = 0;
};

std::string lastPart() { return "part " + std::to_string(world()->getSize() - 1); }
} // namespace

TEST_F(DamagedPartition, IsReadWhileItIsWhole)
{
  write(box(), numRanks());
  EXPECT_NO_THROW(readPart<3>(name(), world()));
}

TEST_F(DamagedPartition, MissingOrForeign)
{
  expectRefused({"does not exist"});
  onFirstRank([&] { std::ofstream(name()) << "This is no HDF5 file.\n"; });
  expectRefused({"cannot be opened as an HDF5 file"});
  onFirstRank([&] { writeMesh(cube(), name()); });
  expectRefused({"no partitioned mesh", "'asperity-mesh'", "asperity-mesh partition makes one"});
}

TEST_F(DamagedPartition, OfAnotherDimensionOrVersion)
{
  write(box(), numRanks());
  expectRefused<2>({"dimension 3, not 2"});
  expectChangeRefused([](hid_t file) { setAttribute(file, "version", 1); },
                      {"version 1", "reads version 2",
                       "asperity-mesh partition MESH.h5 --parts " + std::to_string(numRanks())});
  expectChangeRefused([](hid_t file) { setAttribute(file, "dimension", 4); }, {"= 4 is neither"});
  expectChangeRefused([](hid_t file) { setAttribute(file, "num_parts", 0); }, {"num_parts", "= 0"});
}

TEST_F(DamagedPartition, ForAnotherNumberOfRanks)
{
  write(box(), numRanks() + 6);
  const auto wanted = std::to_string(numRanks());
  expectRefused({"partitioned for " + std::to_string(numRanks() + 6) + " ranks", "has " + wanted,
                 "asperity-mesh partition " + name() + " --parts " + wanted + " --output " +
                   file("box_" + wanted + ".h5")});
}

TEST_F(DamagedPartition, Truncated)
{
  for (double share : {0.95, 0.5, 0.02}) {
    write(box(), numRanks());
    onFirstRank([&] {
      const auto size = static_cast<double>(std::filesystem::file_size(name()));
      std::filesystem::resize_file(name(), static_cast<std::uintmax_t>(share * size));
    });
    expectRefused({"truncated"});
  }
}

// HDF5 finds nothing wrong with these files.
TEST_F(DamagedPartition, ChangedInOnePlace)
{
  const auto expect_array_refused = [&](std::string const& array, auto const& row) {
    using Row = std::decay_t<decltype(row)>;
    expectDatasetRefused<Row>(array + "/values", [&](auto& rows) { rows.back() = row; },
                              {lastPart(), "'" + array + "'", "checksum"});
  };
  expect_array_refused("/num_owned", 5);
  expect_array_refused("/vertices", Point<3>{1.0, 1.0, 2.125});
  expect_array_refused("/global_ids", 3LL);
  expect_array_refused("/cells", Mesh<3>::Cell{0, 1, 2, 3});
  expect_array_refused("/cell_regions", 1);
  expect_array_refused("/boundaries/bottom/facets", Mesh<3>::Facet{0, 1, 2});
  expect_array_refused("/splits", std::array<int, 3>{7, 3, 1});
  expectDatasetRefused<std::uint64_t>(
    "/cells/checksums", [](auto& checksums) { ++checksums.back(); }, {"'/cells'", "checksum"});
  expectDatasetRefused<long long>("/cells/offsets", [](auto& offsets) { ++offsets.back(); },
                                  {"'/cells' has no valid offsets", lastPart()});
  expectDatasetRefused<long long>("/vertices/offsets", [](auto& offsets) { offsets.front() = -1; },
                                  {"'/vertices' has no valid offsets", "part 0"});
}

TEST_F(DamagedPartition, WithoutADataset)
{
  for (char const* path :
       {"/cells", "/vertices/values", "/boundaries/top/facets/values", "/splits"}) {
    expectChangeRefused([&](hid_t file) { H5Ldelete(file, path, H5P_DEFAULT); },
                        {path, "is missing, damaged or of another shape"});
  }
  expectChangeRefused([](hid_t file) { H5Ldelete(file, "/cells/offsets", H5P_DEFAULT); },
                      {"'/cells' has no valid offsets"});
  expectChangeRefused([](hid_t file) { H5Ldelete(file, "/boundaries", H5P_DEFAULT); },
                      {"no group '/boundaries'"});
  expectChangeRefused([](hid_t file) { H5Ldelete(file, "/boundaries/top", H5P_DEFAULT); },
                      {"checksum"});
  expectChangeRefused([](hid_t file) { H5Ldelete(file, "/faults", H5P_DEFAULT); }, {"checksum"});
  expectChangeRefused([](hid_t file) { H5Ldelete(file, "/boundaries/fault", H5P_DEFAULT); },
                      {"fault 'fault' is not among the boundaries"});
}

// Arrays of another mesh with the same numbers of everything, and with their own checksums.
TEST_F(DamagedPartition, PutTogetherFromTwoMeshes)
{
  auto other = box();
  other.vertices.back()[0] += 0.125;
  write(other, numRanks());
  onFirstRank([&] { std::filesystem::rename(name(), file("other.h5")); });
  expectChangeRefused(
    [&](hid_t file_id) {
      const hid_t other_id = H5Fopen(file("other.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
      H5Ldelete(file_id, "/cells", H5P_DEFAULT);
      EXPECT_GE(H5Ocopy(other_id, "/cells", file_id, "/cells", H5P_DEFAULT, H5P_DEFAULT), 0);
      H5Fclose(other_id);
    },
    {"'/cells'", "checksum", "put together"});
}

// Checksums are right, but what they seal is no mesh.
TEST_F(DamagedPartition, MadeByAProgramThatErrs)
{
  rememberSeed();
  using Cell = Mesh<3>::Cell;
  expectRowsRefused<Cell>("/cells",
                          [](auto& cells) { std::swap(cells.back()[0], cells.back()[1]); },
                          {lastPart(), "is inverted"});
  expectRowsRefused<Cell>("/cells", [](auto& cells) { cells.back()[2] = 1000; },
                          {lastPart(), "a vertex outside [0, "});
  expectRowsRefused<int>("/cell_regions", [](auto& regions) { regions.back() = 1; },
                         {lastPart(), "has region 1, outside [0, 1)"});
  expectRowsRefused<GlobalOrdinal>("/global_ids", [](auto& ids) { std::swap(ids[0], ids[1]); },
                                   {lastPart(), "do not ascend"});
  expectRowsRefused<Point<3>>("/vertices",
                              [](auto& vertices) { vertices.back()[1] = std::nan(""); },
                              {lastPart(), "no finite coordinates"});
  using Row = std::array<int, 3>;
  expectRowsRefused<Row>("/splits", [](auto& pairs) { pairs.back()[0] = 1000; },
                         {lastPart(), "the pair of vertices 1000 and", "ascending numbers"});
  expectRowsRefused<Row>("/splits", [](auto& pairs) { --pairs.back()[1]; },
                         {lastPart(), "a pair at a fault, are not at one place"});
  expectRowsRefused<Mesh<3>::Facet>("/boundaries/fault/facets",
                                    [](auto& facets) { facets.back()[0] = 0; },
                                    {lastPart(), "a facet of fault 'fault' has vertex"});
  expectRowsRefused<int>("/num_owned", [](auto& num_owned) { num_owned.back() = 0; },
                         {lastPart(), "0 owned vertices"});
}
