#include "io/generators/read_list_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::detail {

std::string read_list_file(const std::filesystem::path& path, std::string_view what) {
  const auto refuse = [&](std::string_view message) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", path.string(), message));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(fmt::format("is a directory; name a list of {}", what));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(fmt::format("{}; name a list of {}", std::strerror(errno), what));
  std::string content = read_to_end(file);
  if (file.bad()) refuse("could not be read to its end");
  return content;
}

}  // namespace gvd::detail
