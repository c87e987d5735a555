#pragma once

#include "surfaces/files/BinaryFile.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace asperity::geometry
{
// A file of VTK's XML format: its tags, and its arrays as text, in base64 or appended as they are,
// also compressed by zlib. Only what such files have of XML is read, since appended data are no
// XML. All functions throw InputError, which starts with where().
class VtkXml
{
public:
  struct Tag
  {
    std::string name; // "/Points" for its end
    std::map<std::string, std::string> attributes;
    std::size_t end = 0; // of the byte behind it

    std::string attribute(std::string const& key, std::string const& without = "") const;
  };

  // type: "UnstructuredGrid", which the file must have.
  VtkXml(std::string const& file_name, std::string const& type);

  // The next tag from a place on; without a name at the end and where appended data begin.
  Tag next(std::size_t at) const;
  std::vector<double> valuesOf(Tag const& data_array) const;

  void require(bool condition, std::string const& message) const; // "has no cells"
  std::string const& where() const { return where_; }             // "Mesh file 'NAME'"

private:
  void findAppended();
  void readFileTag(Tag const& tag);
  std::vector<double> fromText(std::size_t at, std::string const& name) const;
  std::string bytes(std::size_t at, bool is_appended, std::size_t count,
                    std::string const& name) const;
  std::uint64_t countAt(std::string const& header, std::size_t place) const;
  std::string plain(std::size_t at, bool is_appended, std::string const& name) const;
  std::string inflated(std::size_t at, bool is_appended, std::string const& name) const;
  template <class Number>
  std::vector<double> numbers(std::string const& data) const;
  std::vector<double> fromBinary(std::string const& data, std::string const& type,
                                 std::string const& name) const;

  std::string where_, text_;
  std::size_t appended_ = std::string::npos; // where appended data begin
  bool is_base64_ = false, is_compressed_ = false;
  std::size_t size_of_count_ = 4; // [bytes]
  ByteOrder order_ = ByteOrder::little;
};
} // namespace asperity::geometry
