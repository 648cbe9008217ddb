// Files of objects: as the commands write them, by the extension.

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "gvd/io/format.hpp"
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
    scenes = is_diagram ? std::vector{make_view_scene("Regions", mesh->surface(), *diagram)} : make_region_scenes(*mesh);
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
  list.option(
      "region_materials", Flag{&options.region_materials},
      {.help = "In .obj, give each region a material, in place of the materials that the mesh was read with"});
}

namespace {

/// Calls write_own(writer) for a format that is the object's own, or write_surface(mesh, format). `shown`: for messages.
template <class WriteOwn, class WriteSurface>
void write_by_extension(const std::string& shown, const std::string& extension, const Object& object,
                        const FileOptions& options, const WriteOwn& write_own, const WriteSurface& write_surface) {
  const bool is_whole = options.part.empty();
  OwnWriters own = is_whole ? object.own_writers() : object.part_writers(options.part);
  if (!is_whole && own.empty()) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("{{option:part}}: a {} has no part {}", object.kind(), gvd::quoted(options.part)));
  }
  std::optional<LabelledMesh> mesh = is_whole ? object.labelled() : std::nullopt;
  if (mesh) own.try_emplace("html", [&](std::ostream& out) { out << object.page(options); });
  if (const auto writer = own.find(extension); writer != own.end()) return write_own(writer->second);
  if (mesh) {
    mesh->no_bisectors = options.no_curves;
    mesh->ascii_ply = options.ascii_ply;
    mesh->region_materials = options.region_materials;
  }
  const Format* const format = find_output(extension);
  if (mesh && format != nullptr && format->write != nullptr) return write_surface(*mesh, format->id);
  std::vector<std::string> known;
  for (const auto& [name, writer] : own) known.push_back(name);
  for (const Format& row : formats()) {
    if (mesh && row.write != nullptr && !own.contains(row.extensions.front())) known.push_back(row.extensions.front());
  }
  throw Error(ErrorCode::invalid_option,
              known.empty()
                  ? fmt::format("{}: a {} has no file; write what it consists of", shown, object.kind())
                  : fmt::format("{}: the extension must be one of .{}", shown, fmt::join(known, ", .")));
}

}  // namespace

void write_object(const std::filesystem::path& path, const Object& object, const FileOptions& options,
                  const Progress& progress) {
  write_by_extension(
      path.string(), format_extension(path), object, options, [&](const auto& writer) { write_file(path, writer, progress); },
      [&](const LabelledMesh& mesh, MeshFormat) { write_mesh(path, mesh, progress); });
}

std::string file_bytes(const std::string& format, const Object& object, const FileOptions& options) {
  std::ostringstream out;
  const std::string bare = format.starts_with('.') ? format.substr(1) : format;
  write_by_extension(
      gvd::quoted(format), format_extension("file." + bare), object, options, [&](const auto& writer) { writer(out); },
      [&](const LabelledMesh& mesh, MeshFormat id) { write_mesh(out, mesh, id); });
  return std::move(out).str();
}

}  // namespace gvd
