// Writes PLY, binary or text, with labels, distances, colours and the further properties of the input.
//
// VTK's reader drops every property except coordinates, normals, texture coordinates, colours and a face's `intensity`,
// which is one byte and gets the low byte of the label. Blender shows only the colours of vertices. meshio reads the
// properties of faces only from text; in a binary file it assumes that the lists of all faces are contiguous.
// Source: G. Turk, The PLY polygon file format, 1994. Integers of further properties are rounded and clamped to their
// types; distances are floats unless a float would turn one into infinity or 0, and texture coordinates unless floats
// would turn a face round in the texture, or one is beyond them: not all programs read doubles.
// Invariant: the header and the rows list the same properties in the same order.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

/// Whether a float would turn a finite distance into infinity (not reached) or 0 (a generator).
bool leaves_float(double distance) {
  using Float = std::numeric_limits<float>;
  return std::isfinite(distance) && distance != 0 && (distance > Float::max() || distance < Float::min());
}

bool needs_doubles(const LabelledMesh& mesh) {
  return mesh.vertex_distance != nullptr &&
         std::any_of(mesh.vertex_distance->begin(), mesh.vertex_distance->end(), leaves_float);
}

/// Whether floats turn a face round, or flatten it, in the texture.
bool do_floats_flip(const Uv* corners) {
  const auto side = [&](auto number) {
    const auto at = [&](int i) { return Vec2(number(corners[i][0]), number(corners[i][1])); };
    return orientation(at(0), at(1), at(2));
  };
  const int exact = side([](double x) { return x; });
  return exact != 0 && side([](double x) { return double(float(x)); }) != exact;
}

/// Whether a corner has texture coordinates.
bool is_known(const Uv& uv) { return std::isfinite(uv[0]) && std::isfinite(uv[1]); }

/// The type of texture coordinates. Corners without any have no voice.
NumberType texture_type(const LabelledMesh& mesh) {
  const std::vector<Uv>& texture = mesh.appearance->texture;
  for (std::size_t i = 0; i < texture.size(); i += 3) {
    const Uv* corners = texture.data() + i;
    if (!std::all_of(corners, corners + 3, is_known)) continue;
    if (!std::all_of(corners, corners + 3, fits_floats) || do_floats_flip(corners)) return NumberType::float64;
  }
  return NumberType::float32;
}

constexpr std::array<const char*, 8> kPlyTypes{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
const char* ply_name(NumberType type) { return kPlyTypes[static_cast<std::size_t>(type)]; }

void print_label_properties(ByteWriter& out) {
  out.text("property int label\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n");
}

/// The further properties of vertices, or of faces.
std::vector<const MeshProperty*> further_properties(const LabelledMesh& mesh, bool of_vertices) {
  std::vector<const MeshProperty*> found;
  if (mesh.properties == nullptr) return found;
  for (const MeshProperty& property : *mesh.properties) {
    if (property.of_vertices == of_vertices) found.push_back(&property);
  }
  return found;
}

void print_further_properties(ByteWriter& out, const LabelledMesh& mesh, bool of_vertices) {
  for (const MeshProperty* property : further_properties(mesh, of_vertices)) {
    if (property->count_type)
      out.print("property list {} {} {}\n", ply_name(*property->count_type), ply_name(property->type), property->name);
    if (!property->count_type) out.print("property {} {}\n", ply_name(property->type), property->name);
  }
}

void print_vertex_properties(ByteWriter& out, const LabelledMesh& mesh, bool doubles) {
  out.print("element vertex {}\n", mesh.mesh.vertex_count());
  out.text("property double x\nproperty double y\nproperty double z\n");
  if (mesh.vertex_distance != nullptr) out.print("property {} distance\n", doubles ? "double" : "float");
  if (mesh.vertex_label != nullptr) print_label_properties(out);
  print_further_properties(out, mesh, true);
}

void print_face_properties(ByteWriter& out, const LabelledMesh& mesh, NumberType texture) {
  out.print("element face {}\nproperty list uchar int vertex_indices\n", mesh.mesh.face_count());
  if (mesh.face_label != nullptr) print_label_properties(out);
  if (mesh.face_parent != nullptr) out.text("property int parent\n");
  if (mesh.face_label != nullptr) out.text("property uchar intensity\n");
  if (mesh.has_texture()) out.print("property list uchar {} texcoord\n", ply_name(texture));
  print_further_properties(out, mesh, false);
  if (mesh.face_numbers == nullptr) return;
  for (const FaceNumbers& numbers : *mesh.face_numbers) out.print("property int {}\n", numbers.name);
}

/// The further properties followed by the texture coordinates as the properties `s` and `t` of vertices, which more
/// programs read than coordinates of corners. Returns nothing if a vertex has several coordinates, a corner has none,
/// or the names are taken.
std::optional<std::vector<MeshProperty>> list_with_texture(const LabelledMesh& mesh, NumberType type) {
  if (!mesh.has_texture()) return std::nullopt;
  const std::size_t count = mesh.mesh.positions().size();
  std::array<MeshProperty, 2> pair{
      {{"s", type, true, std::vector<double>(count)}, {"t", type, true, std::vector<double>(count)}}};
  std::vector<char> is_seen(count, 0);
  for (const HalfedgeId h : mesh.mesh.halfedges()) {
    const Uv& uv = mesh.appearance->texture[h.index()];
    const std::size_t v = mesh.mesh.from(h).index();
    if (!is_known(uv) || (is_seen[v] != 0 && Uv{pair[0].values[v], pair[1].values[v]} != uv)) return std::nullopt;
    is_seen[v] = 1;
    for (std::size_t k = 0; k < 2; ++k) pair[k].values[v] = uv[k];
  }
  std::vector<MeshProperty> all = mesh.properties != nullptr ? *mesh.properties : std::vector<MeshProperty>();
  const auto is_taken = [](const MeshProperty& p) { return p.of_vertices && (p.name == "s" || p.name == "t"); };
  if (std::any_of(all.begin(), all.end(), is_taken)) return std::nullopt;
  std::move(pair.begin(), pair.end(), std::back_inserter(all));
  return all;
}

/// The nearest number of the type. For integers, NaN becomes 0.
template <class T>
T nearest(double value) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<T>(value);
  if (std::isnan(value)) return 0;
  using Limits = std::numeric_limits<T>;
  return static_cast<T>(std::clamp(std::round(value), double(Limits::min()), double(Limits::max())));
}

/// Writes the numbers of one element after the other, as bytes or as a line of text.
class Rows {
 public:
  Rows(ByteWriter& out, const ColoredMesh& mesh) : out_(out), mesh_(mesh), text_(mesh.ascii_ply) {}

  template <class T>
  void put(T value) {
    if (!text_) return out_.binary(value);
    out_.print("{}{}", empty_ ? "" : " ", value);
    empty_ = false;
  }

  void put_label(GeneratorId label) {
    const Rgb color = mesh_.color(label);
    put(label.value());
    put(color.red);
    put(color.green);
    put(color.blue);
  }

  void put_number(NumberType type, double value) {
    // In the order of NumberType.
    constexpr std::array kPut{&Rows::put_nearest<std::int8_t>,  &Rows::put_nearest<std::uint8_t>,
                              &Rows::put_nearest<std::int16_t>, &Rows::put_nearest<std::uint16_t>,
                              &Rows::put_nearest<std::int32_t>, &Rows::put_nearest<std::uint32_t>,
                              &Rows::put_nearest<float>,        &Rows::put_nearest<double>};
    (this->*kPut[static_cast<std::size_t>(type)])(value);
  }

  /// Writes the number of element i, or its list.
  void put_property(const MeshProperty& property, std::size_t i) {
    if (!property.count_type) return put_number(property.type, property.values[i]);
    const std::size_t first = property.first_value[i], last = property.first_value[i + 1];
    put_number(*property.count_type, double(last - first));
    for (std::size_t k = first; k < last; ++k) put_number(property.type, property.values[k]);
  }

  /// Writes the texture coordinates of a face's corners, or an empty list if one of them has none.
  void put_texture(const Uv* corners, NumberType type) {
    const bool has = std::all_of(corners, corners + 3, is_known);
    put(std::uint8_t(has ? 6 : 0));
    for (int i = 0; has && i < 3; ++i) {
      for (const double number : corners[i]) put_number(type, number);
    }
  }

  void end() {
    if (text_) out_.text("\n");
    empty_ = true;
  }

 private:
  template <class T>
  void put_nearest(double value) {
    put(nearest<T>(value));
  }

  ByteWriter& out_;
  const ColoredMesh& mesh_;
  bool text_;
  bool empty_ = true;
};

void write_vertices(Rows& rows, const LabelledMesh& mesh, bool doubles) {
  const auto further = further_properties(mesh, true);
  for (const VertexId v : mesh.mesh.vertices()) {
    const Vec3& p = mesh.mesh.position(v);
    for (int i = 0; i < 3; ++i) rows.put(p[i]);
    if (mesh.vertex_distance != nullptr) {
      const double distance = (*mesh.vertex_distance)[v];
      doubles ? rows.put(distance) : rows.put(float(distance));
    }
    if (mesh.vertex_label != nullptr) rows.put_label((*mesh.vertex_label)[v]);
    for (const MeshProperty* property : further) rows.put_property(*property, v.index());
    rows.end();
  }
}

void write_faces(Rows& rows, const LabelledMesh& mesh, NumberType texture) {
  const auto further = further_properties(mesh, false);
  for (const FaceId f : mesh.mesh.faces()) {
    rows.put(std::uint8_t{3});
    for (const VertexId v : mesh.mesh.vertices(f)) rows.put(v.value());
    if (mesh.face_label != nullptr) rows.put_label((*mesh.face_label)[f]);
    if (mesh.face_parent != nullptr) rows.put((*mesh.face_parent)[f].value());
    if (mesh.face_label != nullptr) rows.put(std::uint8_t((*mesh.face_label)[f].value()));
    if (mesh.has_texture()) rows.put_texture(mesh.appearance->texture.data() + 3 * f.index(), texture);
    for (const MeshProperty* property : further) rows.put_property(*property, f.index());
    if (mesh.face_numbers != nullptr) {
      for (const FaceNumbers& numbers : *mesh.face_numbers) rows.put(numbers.values[f]);
    }
    rows.end();
  }
}

}  // namespace

void write_ply(std::ostream& stream, const ColoredMesh& given) {
  ByteWriter out(stream);
  ColoredMesh mesh = given;
  const NumberType texture = given.has_texture() ? texture_type(given) : NumberType::float32;
  const auto with_texture = list_with_texture(given, texture);
  if (with_texture) {
    mesh.properties = &*with_texture;
    mesh.appearance = nullptr;
  }
  const bool doubles = needs_doubles(mesh);
  out.print("ply\nformat {} 1.0\n", mesh.ascii_ply ? "ascii" : "binary_little_endian");
  print_vertex_properties(out, mesh, doubles);
  print_face_properties(out, mesh, texture);
  out.text("end_header\n");
  Rows rows(out, mesh);
  write_vertices(rows, mesh, doubles);
  write_faces(rows, mesh, texture);
  out.finish();
}

}  // namespace gvd::io
