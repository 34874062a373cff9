#include "solver/base/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {

namespace {

/// Returns 0 or the system's error number.  A full disk may show up only when the file is closed.
int writeBytes(const std::filesystem::path& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

std::filesystem::path temporaryName(const std::filesystem::path& file) {
  std::filesystem::path temporary = file;
  temporary += ".part";
  return temporary;
}

void writeWholeFile(const std::filesystem::path& file, std::string_view bytes) {
  const std::filesystem::path temporary = temporaryName(file);
  int error = writeBytes(temporary, bytes);
  if (error == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  throw ComputationError(joined("cannot write ", file.string(), ": ", std::strerror(error)));
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace ease
