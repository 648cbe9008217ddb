// Writes objects to files, as the commands do, by the extension.

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <utility>
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
    // With the diagram's own labels, cut faces are drawn as pieces.
    const bool is_diagram = mesh->face_label == &diagram->face_label;
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

namespace {

/// Refuses options that have no effect in a file of this format.
void check_options(const FileOptions& options, const Format* format) {
  const auto needs = [format](bool is_given, const char* option, bool (*serves)(const Format&),
                              const std::string& why) {
    if (!is_given || (format != nullptr && serves(*format))) return;
    throw Error(ErrorCode::invalid_option, fmt::format("\1{0}\2: {1}; write one or leave \1{0}\2 out", option, why));
  };
  needs(
      options.no_curves, "no_curves", [](const Format& f) { return has_any(f.carries, Content::curves); },
      only_formats(Content::curves) + " curves");
  needs(
      options.region_materials, "region_materials",
      [](const Format& f) { return has_any(f.carries, Content::materials); },
      only_formats(Content::materials) + " materials");
  needs(
      options.ascii_ply, "ascii_ply", [](const Format& f) { return f.id == MeshFormat::ply; }, "no .ply is written");
}

/// A file of an object in memory, or at a path.
struct ObjectFile {
  std::string name;       ///< for messages
  std::string extension;  ///< without the dot
  std::function<void(const std::function<void(std::ostream&)>&)> write;
  std::function<void(const LabelledMesh&, const Format&)> write_surface;
};

void write_to(const ObjectFile& target, const Object& object, const FileOptions& options) {
  const auto& [name, extension, write, write_surface] = target;
  const Format* const format = options.part.empty() ? find_output(extension) : nullptr;
  if (!options.part.empty()) {
    check_options(options, nullptr);
    const OwnWriters own = object.part_writers(options.part);
    const auto writer = own.find(extension);
    if (own.empty()) {
      throw Error(ErrorCode::invalid_option,
                  fmt::format("\1part\2: a {} has no part {}", object.kind(), gvd::quoted(options.part)));
    }
    if (writer != own.end()) return write(writer->second);
    std::vector<std::string> known;
    for (const auto& [one, writes] : own) known.push_back(one);
    throw Error(ErrorCode::invalid_option,
                fmt::format("{}: the extension must be one of {}", name, list_extensions(known, "or")));
  }
  const Content content = object.content();
  if (content == Content::nothing) {
    throw Error(
        ErrorCode::invalid_option,
        fmt::format("{}: a {} can't be written to a file; use its figures and arrays instead", name, object.kind()));
  }
  if (extension == "html") {
    check_options(options, nullptr);
    return write([&](std::ostream& out) { out << object.page(options); });
  }
  if (format == nullptr || !has_any(format->carries, content)) {
    throw Error(ErrorCode::invalid_option, fmt::format("{}: the extension must be one of {}", name,
                                                       list_extensions(output_extensions(content), "or")));
  }
  check_options(options, format);
  object.check_file({name, format});
  const OwnWriters own = object.own_writers();
  const auto writer = own.find(format->extensions.front());
  if (writer != own.end()) return write(writer->second);
  LabelledMesh mesh = object.labelled().value();
  mesh.no_bisectors = options.no_curves;
  mesh.ascii_ply = options.ascii_ply;
  mesh.region_materials = options.region_materials;
  write_surface(mesh, *format);
}

}  // namespace

void write_object(const std::filesystem::path& path, const Object& object, const FileOptions& options,
                  const Progress& progress) {
  write_to({path.string(), format_extension(path), [&](const auto& write) { write_file(path, write, progress); },
            [&](const LabelledMesh& mesh, const Format&) { write_mesh(path, mesh, progress); }},
           object, options);
}

std::string file_bytes(const std::string& format, const Object& object, const FileOptions& options) {
  std::ostringstream out;
  const std::string bare = format.starts_with('.') ? format.substr(1) : format;
  write_to({gvd::quoted(format), format_extension("file." + bare), [&](const auto& write) { write(out); },
            [&](const LabelledMesh& mesh, const Format& row) { write_mesh(out, mesh, row.id); }},
           object, options);
  return std::move(out).str();
}

}  // namespace gvd
