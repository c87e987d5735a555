#include "io/files/DurableFile.hpp"

#include "base/Errors.hpp"
#include "base/WriteFailure.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace asperity::io::detail
{
std::filesystem::path temporaryName(std::filesystem::path const& file)
{
  return file.string() + ".part";
}

void synchronise(std::filesystem::path const& file)
{
  const int descriptor = ::open(file.c_str(), O_RDONLY);
  const bool opened = descriptor >= 0;
  // Some file systems cannot synchronise folders and say EINVAL; that is not a failure to write.
  const bool written = opened && (::fsync(descriptor) == 0 || errno == EINVAL);
  const int error = errno;
  if (opened) {
    ::close(descriptor);
  }
  if (!written) {
    throw OutputError(file.string() + " cannot be written to the disk: " + std::strerror(error) +
                      (opened ? ". " + diskFullHint() : ". Has it been removed?"));
  }
}

void makeFolderOf(std::filesystem::path const& file)
{
  std::error_code error;
  std::filesystem::create_directory(file.parent_path(), error);
  if (error) {
    throw OutputError(file.parent_path().string() + " cannot be made: " + error.message() +
                      ". Has the output directory been removed?");
  }
}

void replace(std::filesystem::path const& file)
{
  std::error_code error;
  std::filesystem::rename(temporaryName(file), file, error);
  if (error) {
    throw OutputError(file.string() + " cannot be replaced: " + error.message() + ".");
  }
}

void replaceDurably(std::filesystem::path const& file)
{
  synchronise(temporaryName(file));
  replace(file);
  const auto folder = file.parent_path();
  synchronise(folder.empty() ? std::filesystem::path(".") : folder);
}
} // namespace asperity::io::detail
