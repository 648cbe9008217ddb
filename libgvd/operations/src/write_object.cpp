// Files of objects: as the commands write them, by the extension.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/io/view.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/object.hpp"
#include "gvd/option_list.hpp"
#include "gvd/text.hpp"

namespace gvd {

std::string Object::page(const FileOptions& options) const {
  const std::optional<LabelledMesh> mesh = labelled();
  if (!mesh) throw Error(ErrorCode::invalid_option, fmt::format("a {} has no page", kind()));
  ViewScene plain;
  plain.mesh = &mesh->mesh;
  std::vector<ViewScene> scenes{plain};
  if (const Diagram* const diagram = mesh->diagram; diagram != nullptr) {
    const bool is_diagram = mesh->face_label == &diagram->face_label;  // its cut faces have pieces, not labels
    scenes =
        is_diagram ? std::vector{make_view_scene("Regions", mesh->surface(), *diagram)} : make_region_scenes(*mesh);
  }
  ViewOptions view;
  view.title = options.title;
  return make_view_page(scenes, view);
}

void describe(OptionList& list, FileOptions& options) {
  list.group("Files");
  list.option("part", File{&options.part}, {.help = "Write a part that has a file of its own: points, map or path N"});
  list.option("title", File{&options.title}, {.help = "Title of a page"});
  list.option("no_curves", Flag{&options.no_curves},
              {.help = "Leave the bisectors out of " + list_extensions(output_extensions(Content::curves), "and")});
  list.option("ascii_ply", Flag{&options.ascii_ply}, {.help = "Write .ply as text instead of binary"});
  list.option("region_materials", Flag{&options.region_materials},
              {.help = "In .obj, give each region a material, in place of the materials that the mesh was read with"});
}

void write_object(const std::filesystem::path& path, const Object& object, const FileOptions& options,
                  const Progress& progress) {
  const std::string name = path.string();
  if (!options.part.empty()) {
    const OwnWriters own = object.part_writers(options.part);
    const auto writer = own.find(format_extension(path));
    if (own.empty()) {
      throw Error(ErrorCode::invalid_option,
                  fmt::format("\1part\2: a {} has no part {}", object.kind(), gvd::quoted(options.part)));
    }
    if (writer != own.end()) return write_file(path, writer->second, progress);
    std::vector<std::string> known;
    for (const auto& [extension, write] : own) known.push_back(extension);
    throw Error(ErrorCode::invalid_option,
                fmt::format("{}: the extension must be one of {}", name, list_extensions(known, "or")));
  }
  const Content content = object.content();
  if (content == Content::nothing) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("{}: a {} has no file; write what it consists of", name, object.kind()));
  }
  if (format_extension(path) == "html") {
    return write_file(
        path, [&](std::ostream& out) { out << object.page(options); }, progress);
  }
  const Format* const format = find_output(format_extension(path));
  if (format == nullptr || !has_any(format->carries, content)) {
    throw Error(ErrorCode::invalid_option, fmt::format("{}: the extension must be one of {}", name,
                                                       list_extensions(output_extensions(content), "or")));
  }
  object.check_file({name, format});
  const OwnWriters own = object.own_writers();
  const auto writer = own.find(format->extensions.front());
  if (writer != own.end()) return write_file(path, writer->second, progress);
  LabelledMesh mesh = object.labelled().value();
  mesh.no_bisectors = options.no_curves;
  mesh.ascii_ply = options.ascii_ply;
  mesh.region_materials = options.region_materials;
  write_mesh(path, mesh, progress);
}

}  // namespace gvd
