#include "gmsh/GmshSession.hpp"

#include "base/Errors.hpp"

#include <gmsh.h>

#include <exception>

namespace asperity::geometry
{
GmshSession::GmshSession(bool is_loud, std::vector<std::string> const& arguments)
{
  std::vector<std::string> texts = {"gmsh"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  for (auto& text : texts) {
    words.push_back(text.data());
  }
  constexpr bool read_configuration = false;
  gmsh::initialize(static_cast<int>(words.size()), words.data(), read_configuration);
  gmsh::option::setNumber("General.Terminal", is_loud ? 1 : 0);
}

GmshSession::~GmshSession() { gmsh::finalize(); }

void GmshSession::open(std::string const& file_name, std::string const& where) const
{
  const auto error = errorOfGmsh([&] { gmsh::open(file_name); });
  ASPERITY_REQUIRE(error.empty(), where << " cannot be read by Gmsh: " << error << ".");
}

std::string errorOfGmsh(std::function<void()> const& call)
{
  try {
    call();
  } catch (InputError const&) {
    throw; // an error of this program, from a function that Gmsh calls
  } catch (std::string const& reason) {
    return reason;
  } catch (std::exception const& error) {
    return error.what();
  }
  return "";
}

char const* entityName(int dimension)
{
  constexpr char const* names[] = {"Point", "Curve", "Surface", "Volume"};
  return names[dimension];
}
} // namespace asperity::geometry
