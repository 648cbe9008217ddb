// Reads a file and unpacks it for the readers of the formats.
#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {

std::string read_file_bytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (has_placeholder_mark(name)) {
    throw Error(ErrorCode::unreadable_input,
                printable(name, name.size()) + ": the name has a control character; rename the file");
  }
  const auto refuse = [&](std::string_view message) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name, message));
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("there is no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse("this is a directory; give a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("the file can't be opened; check its permissions");
  const std::uintmax_t size = std::filesystem::file_size(path, error);  // fails for a pipe
  std::string bytes = read_to_end(file, error ? 0 : size);
  if (file.bad()) refuse("the file can't be read to its end");
  unpack(bytes, name);
  return bytes;
}

}  // namespace gvd
