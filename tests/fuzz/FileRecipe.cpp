#include "FileRecipe.hpp"

#include "base/Text.hpp"
#include "hdf5/File.hpp"

#include <algorithm>
#include <sstream>

namespace asperity::fuzz
{
namespace
{
// ROWS or ROWSxCOLUMNS, of as many numbers as a recipe may ask for.
h5::Shape shapeOf(std::string const& text)
{
  constexpr hsize_t most_numbers = 100000;
  h5::Shape shape;
  hsize_t size = 1;
  for (auto const& extent : split(text, 'x')) {
    const auto number = readInteger(extent);
    if (!number || *number < 0 || static_cast<hsize_t>(*number) > most_numbers) {
      throw h5::Error("no shape");
    }
    shape.push_back(static_cast<hsize_t>(*number));
    size *= std::max<hsize_t>(shape.back(), 1);
    if (size > most_numbers) {
      throw h5::Error("too large");
    }
  }
  return shape;
}

// Texts such as "nan" and "1e400" are numbers, too.
template <class Number>
void storeNumbers(h5::File& file, std::string const& path, h5::Shape const& shape,
                  std::istream& words)
{
  std::size_t size = 1;
  for (const hsize_t extent : shape) {
    size *= extent;
  }
  std::vector<Number> values(size);
  std::string word;
  for (std::size_t i = 0; i < size && words >> word; ++i) {
    if constexpr (std::is_floating_point_v<Number>) {
      values[i] = std::strtod(word.c_str(), nullptr);
    } else if constexpr (std::is_unsigned_v<Number>) {
      values[i] = std::strtoull(word.c_str(), nullptr, 10);
    } else {
      values[i] = static_cast<Number>(std::strtoll(word.c_str(), nullptr, 10));
    }
  }
  file.store(path, values.data(), shape);
}

void addDataset(h5::File& file, std::istream& words)
{
  std::string path, type, shape_text;
  words >> path >> type >> shape_text;
  const auto shape = shapeOf(shape_text);
  if (type == "int8") {
    storeNumbers<std::int8_t>(file, path, shape, words);
  } else if (type == "int32") {
    storeNumbers<std::int32_t>(file, path, shape, words);
  } else if (type == "int64") {
    storeNumbers<std::int64_t>(file, path, shape, words);
  } else if (type == "uint64") {
    storeNumbers<std::uint64_t>(file, path, shape, words);
  } else {
    storeNumbers<double>(file, path, shape, words);
  }
}

std::string rest(std::istream& words)
{
  std::string text;
  std::getline(words, text);
  return text.empty() ? text : text.substr(1);
}

void addAttribute(h5::File& file, std::istream& words)
{
  std::string name, type;
  words >> name >> type;
  if (type == "int") {
    file.setAttribute(name, std::int64_t(std::strtoll(rest(words).c_str(), nullptr, 10)));
  } else if (type == "reals") {
    std::vector<double> values;
    for (std::string word; words >> word;) {
      values.push_back(std::strtod(word.c_str(), nullptr));
    }
    file.setAttribute(name, values);
  } else {
    file.setAttribute(name, rest(words), h5::TextLength::fixed);
  }
}

void addLine(h5::File& file, std::string const& line)
{
  std::istringstream words(line);
  std::string kind, path;
  words >> kind;
  if (kind == "attribute") {
    addAttribute(file, words);
  } else if (kind == "group") {
    words >> path;
    file.createGroup(path);
  } else if (kind == "dataset") {
    addDataset(file, words);
  } else if (kind == "texts") {
    words >> path;
    file.createTexts(path, split(rest(words), '|'), h5::TextLength::fixed);
  }
}
} // namespace

bool isRecipe(std::string const& input) { return input.rfind("#recipe", 0) == 0; }

bool makeFile(std::string const& input, Scratch const& file)
{
  if (!isRecipe(input)) {
    file.write(input);
    return true;
  }
  const h5::Silence silence;
  std::istringstream lines(input);
  std::string line;
  std::getline(lines, line);
  const bool is_sealed = line.find("sealed") != std::string::npos;
  h5::File target =
    h5::File::create(file.path(), is_sealed ? h5::Layout::sealed : h5::Layout::plain);
  while (std::getline(lines, line)) {
    try {
      addLine(target, line);
    } catch (h5::Error const&) {
      continue; // two of one name, say
    }
  }
  try {
    target.close();
  } catch (h5::Error const&) {
    return false;
  }
  return true;
}
} // namespace asperity::fuzz
