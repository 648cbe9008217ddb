// Files of objects: as the commands write them, by the extension.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/object.hpp"

namespace gvd {

void write_object(const std::filesystem::path& path, const Object& object, const Progress& progress) {
  const std::string extension = format_extension(path);
  const OwnWriters own = object.own_writers();
  if (const auto writer = own.find(extension); writer != own.end()) return write_file(path, writer->second, progress);
  const std::optional<LabelledMesh> mesh = object.labelled();
  const Format* const format = find_output(extension);
  if (mesh && format != nullptr && format->write != nullptr) return write_mesh(path, *mesh, progress);
  std::vector<std::string> known;
  for (const auto& [name, writer] : own) known.push_back(name);
  for (const Format& row : formats()) {
    if (mesh && row.write != nullptr && !own.contains(row.extensions.front())) known.push_back(row.extensions.front());
  }
  throw Error(ErrorCode::invalid_option,
              known.empty()
                  ? fmt::format("{}: a {} has no file; write what it consists of", path.string(), object.kind())
                  : fmt::format("{}: the extension must be one of .{}", path.string(), fmt::join(known, ", .")));
}

}  // namespace gvd
