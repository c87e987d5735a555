#include "FuzzTarget.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  asperity::fuzz::start(*argc, *argv);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
  asperity::fuzz::checkInput(std::string(reinterpret_cast<char const*>(data), size));
  return 0;
}
