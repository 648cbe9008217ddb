// Files of objects: as the commands write them, by the extension.

#include <fmt/format.h>

#include <string>

#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/object.hpp"

namespace gvd {

void write_object(const std::filesystem::path& path, const Object& object, const Progress& progress) {
  const std::string name = path.string();
  const Content content = object.content();
  if (content == Content::nothing) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("{}: a {} has no file; write what it consists of", name, object.kind()));
  }
  const Format* const format = find_output(format_extension(path));
  if (format == nullptr || !has_any(format->carries, content)) {
    throw Error(ErrorCode::invalid_option, fmt::format("{}: the extension must be one of {}", name,
                                                       list_extensions(output_extensions(content), "or")));
  }
  object.check_file({name, format});
  const OwnWriters own = object.own_writers();
  const auto writer = own.find(format->extensions.front());
  writer != own.end() ? write_file(path, writer->second, progress)
                      : write_mesh(path, object.labelled().value(), progress);
}

}  // namespace gvd
