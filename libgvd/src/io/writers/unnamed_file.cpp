#include "io/writers/unnamed_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace gvd::detail {
namespace {

namespace fs = std::filesystem;

/// The way to a file that only its descriptor leads to.
std::string path_of(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

}  // namespace

std::FILE* open_unnamed([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
  constexpr mode_t kAll = 0666;  // less those of the umask, as for every new file
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kAll);
  if (descriptor < 0) return nullptr;
  const bool reachable = ::access(path_of(descriptor).c_str(), F_OK) == 0;  // not without /proc
  std::FILE* const file = reachable ? ::fdopen(descriptor, "wb") : nullptr;
  if (file == nullptr) ::close(descriptor);
  return file;
#else
  return nullptr;
#endif
}

bool give_name(std::FILE* unnamed, const fs::path& name) {
  const std::string path = path_of(::fileno(unnamed));
  if (::linkat(AT_FDCWD, path.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
  if (errno == EEXIST) return false;
  // Some file systems in user space link no file that had no name before.
  std::error_code failed;
  if (fs::copy_file(path, name, failed)) return true;
  if (failed != std::errc::file_exists) ::unlink(name.c_str());
  errno = failed.value();
  return false;
}

}  // namespace gvd::detail
