// The table of formats: its names lead to one row each, contents are recognised, and files hold what their rows say.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/read_soup.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"

namespace gvd::test_formats {

using namespace test;

/// A labelled mesh with everything that a file of a mesh may hold.
struct Everything : Labelled {
  Everything() {
    curves.push_back({"path_0", {Vec3(0, 0, 0), Vec3(1, 0, 0)}, {1, 0}});
    properties.push_back({"quality", NumberType::float64, true, std::vector<double>(mesh.positions().size(), 0.5)});
    numbers.push_back({"region", IdVector<FaceId, std::int32_t>(std::size_t(mesh.face_count()), 7)});
    for (const HalfedgeId h : mesh.halfedges()) appearance.texture.push_back({h.value() / 64.0, 0.25});
    appearance.materials = {"skin"};
    appearance.material.assign(std::size_t(mesh.face_count()), 0);
    materials_only.materials = appearance.materials;
    materials_only.material = appearance.material;
    texture_only.texture = appearance.texture;
  }

  /// All of it, or all but one kind of content.
  LabelledMesh view(Content without = Content::nothing) const {
    LabelledMesh all = Labelled::view();
    all.curves = &curves;
    all.properties = &properties;
    all.face_numbers = &numbers;
    all.appearance = &appearance;
    switch (without) {
      case Content::face_labels:
        all.face_label = nullptr;
        break;
      case Content::vertex_labels:
        all.vertex_label = nullptr;
        break;
      case Content::face_numbers:
        all.face_parent = nullptr;
        all.face_numbers = nullptr;
        break;
      case Content::distances:
        all.vertex_distance = nullptr;
        break;
      case Content::curves:
        all.curves = nullptr;
        all.no_bisectors = true;
        break;
      case Content::texture:
        all.appearance = &materials_only;
        break;
      case Content::materials:
        all.appearance = &texture_only;
        break;
      case Content::properties:
        all.properties = nullptr;
        break;
      case Content::diagram:
        all.diagram = nullptr;
        break;
      default:
        break;
    }
    return all;
  }

  std::vector<MeshCurve> curves;
  std::vector<MeshProperty> properties;
  std::vector<FaceNumbers> numbers;
  Appearance appearance, materials_only, texture_only;
};

/// The bytes of all files of a mesh in one format; nothing where it refuses a mesh that lacks what it holds.
std::optional<std::string> written(const LabelledMesh& mesh, const Format& format) {
  const TemporaryFolder folder;
  try {
    write_mesh(folder / ("a." + format.extensions.front()), mesh);
  } catch (const Error& error) {
    REQUIRE(error.code() == ErrorCode::invalid_option);
    return std::nullopt;
  }
  std::string bytes;
  for (const std::string& name : folder.names()) bytes += name + '\n' + read_bytes(folder / name);
  return bytes;
}

/// The greatest distance of a corner from where it was.
double farthest_move(const Mesh& mesh, const PolygonSoup& soup) {
  REQUIRE(soup.polygon_count() == std::size_t(mesh.face_count()));
  double farthest = 0;
  for (const FaceId f : mesh.faces()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& read = soup.positions[std::size_t(soup.polygon(f.index())[i])];
      farthest = std::max(farthest, (read - mesh.position(mesh.vertices(f)[i])).norm());
    }
  }
  return farthest;
}

TEST_CASE("formats: each name leads to one row, and rows are in the order of their numbers") {
  std::set<std::string> outputs, inputs, names;
  for (const Format& format : formats()) {
    INFO(format.name);
    CHECK(&format_row(format.id) == &format);
    CHECK(names.insert(std::string(format.name)).second);
    for (const std::string& extension : format.extensions) {
      if (format.is_output()) {
        CHECK(outputs.insert(extension).second);
        CHECK(find_output("." + extension) == &format);
        CHECK(format_extension("folder/a." + extension) == format.extensions.front());
      }
      if (format.read != nullptr) CHECK(inputs.insert(extension).second);
    }
    for (const std::string& extension : format.input_extensions) {
      CHECK(inputs.insert(extension).second);
      CHECK(format_from_extension("a." + extension + ".gz") == format.id);
    }
    if (format.read != nullptr) {
      CHECK_FALSE(format.title.empty());
      CHECK(value_in(input_format_names(), format.name) == format.id);
      CHECK(format.is_content != nullptr);
    }
    CHECK(parse_output_format(format.name).has_value() == (format.write != nullptr));
  }
  CHECK(find_output("vtk") == nullptr);
  CHECK_FALSE(parse_output_format("npy").has_value());  // commands write it
}

TEST_CASE("formats: a written mesh is recognised by its content, and read back as precisely as the row says") {
  const Labelled labelled;
  const Mesh& mesh = labelled.mesh;
  const double step = std::numeric_limits<float>::epsilon(), diagonal = mesh.bbox_diagonal();
  REQUIRE(mesh.largest_coordinate() > 1e4 * diagonal);  // far from the origin
  for (const Format& format : formats()) {
    if (format.write == nullptr || !has_any(format.carries, Content::surface)) continue;
    INFO(format.name);
    const std::string bytes = to_bytes({mesh}, format.id);
    const auto found = detect_format(bytes, "");
    REQUIRE(found == (format.read != nullptr ? format.id : MeshFormat::off));  // COFF is read as OFF
    CHECK(std::ranges::count_if(formats(), [&](const Format& other) {
            return other.is_content != nullptr && other.is_content(bytes);
          }) == 1);
    const double move = farthest_move(mesh, parse_soup(bytes, *found, "file"));
    if (has_any(format.carries, Content::doubles)) {
      CHECK(move == 0);
    } else if (has_any(format.carries, Content::place)) {
      CHECK((move > 0 && move < step * diagonal));
    } else {
      CHECK((move > step * diagonal && move < step * mesh.largest_coordinate()));
    }
    CHECK((measure_position_loss(mesh, format.id).farthest_move > 0) == (move > 0));
    const std::string labelled_bytes = to_bytes(labelled.view(), format.id);
    const auto labelled_format = detect_format(labelled_bytes, "");
    CHECK(labelled_format == found);
    CHECK(parse_soup(labelled_bytes, *found, "file").polygon_count() == std::size_t(mesh.face_count()));
  }
}

TEST_CASE("formats: a file changes with what its row says that it carries, and with nothing else") {
  const Everything all;
  for (const Format& format : formats()) {
    if (format.write == nullptr) continue;
    const auto with_all = written(all.view(), format);
    REQUIRE(with_all.has_value());
    for (const Content content :
         {Content::face_labels, Content::vertex_labels, Content::face_numbers, Content::distances, Content::curves,
          Content::texture, Content::materials, Content::properties, Content::diagram}) {
      INFO(format.name << ": " << name_in(kContentNames, content));
      const auto without = written(all.view(content), format);
      const bool carries = has_any(format.carries, content), differs = without != with_all;
      if (carries) CHECK(differs);
      // Labels and the diagram choose the colours; and with the diagram its bisectors go.
      const bool is_label = content == Content::face_labels || content == Content::vertex_labels;
      const Content effects = content == Content::diagram ? Content::colors | Content::curves
                              : is_label                  ? Content::colors
                                                          : Content::nothing;
      if (!carries && !has_any(format.carries, effects)) CHECK_FALSE(differs);
    }
  }
}

TEST_CASE("formats: a file has other colours for other neighbours where its row says that it carries colours") {
  const Labelled labelled;
  Diagram crowded = labelled.diagram;  // more cells, so that others are taken first
  for (int i = 3; i < 8; ++i) {
    crowded.cells.push_back({GeneratorId(i), 1, 1, 1, 0, {}});
    for (int j = 0; j < i; ++j) crowded.cells[GeneratorId(i)].neighbours.push_back(GeneratorId(j));
  }
  LabelledMesh mesh = labelled.view(), other = mesh;
  mesh.no_bisectors = other.no_bisectors = true;
  other.diagram = &crowded;
  const GeneratorId seen(0);
  REQUIRE_FALSE(region_colors(mesh)[seen.index()] == region_colors(other)[seen.index()]);
  for (const Format& format : formats()) {
    if (format.write == nullptr || has_any(format.carries, Content::diagram)) continue;
    INFO(format.name);
    CHECK((written(mesh, format) != written(other, format)) == has_any(format.carries, Content::colors));
  }
}

TEST_CASE("formats: a binary STL is one whatever its header says, but for the marks of others") {
  const auto stl_with = [](std::string header) {
    header.resize(80, ' ');
    return header + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  };
  for (const char* header : {"v 0 0 0", "OFF", "solid", "P 1 2 3 4 5 6\n", "{\"asset\":1}", "anything"}) {
    INFO(header);
    CHECK(detect_format(stl_with(header), "a.obj") == MeshFormat::stl);
  }
  CHECK(detect_format(stl_with("ply\n"), "a.stl") == MeshFormat::ply);
  CHECK(detect_format("# vtk DataFile Version 3.0\nv 1 2 3\nASCII\n", "a.obj") == MeshFormat::vtk);
}

TEST_CASE("formats: sentences list what holds something") {
  CHECK(only_formats(Content::texture) == "only .ply, .obj and .glb hold");
  CHECK(only_formats(Content::materials) == "only .obj holds");
  CHECK(only_formats(Content::materials, {"--view"}) == "only .obj and --view hold");
  CHECK(list_extensions(output_extensions(Content::distances, Content::surface), "or") == ".shape.gii or .curv");
  CHECK(list_extensions({"ply"}, "or") == ".ply");
  CHECK(list_extensions({}, "or").empty());
  CHECK(output_extensions(Content::vertex_labels, Content::surface) == std::vector<std::string>{"label.gii", "annot"});
}

TEST_CASE("formats: what is read only is not written, and the other way round") {
  const Labelled labelled;
  CHECK_THROWS_WITH(to_bytes(labelled.view(), MeshFormat::vtk),
                    "a mesh can't be written as .vtk; choose .ply, .obj, .off, .coff, .stl, .vtp, .vtu, .glb, "
                    ".surf.gii or .fs");
  CHECK_THROWS_WITH(parse_soup("1,2", MeshFormat::csv, "a.csv"),
                    "a.csv: no mesh is read from .csv; name another format");
}

}  // namespace gvd::test_formats
