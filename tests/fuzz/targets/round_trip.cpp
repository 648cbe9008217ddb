#include "fuzz/targets/round_trip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/targets/require.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"

namespace gvd::fuzz {
namespace {

bool same_bits(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  }
  return true;
}

void check_appearance(const Appearance& appearance, std::size_t corners, std::size_t polygons) {
  require(appearance.texture.empty() || appearance.texture.size() == corners, "a corner has no texture coordinates");
  require(appearance.material.empty() || appearance.material.size() == polygons, "a polygon has no material");
  const auto count = static_cast<std::int64_t>(appearance.materials.size());
  for (const std::int32_t m : appearance.material) require(m >= -1 && m < count, "a material has no name");
}

void check_soup(const PolygonSoup& soup) {
  require(soup.polygon_count() > 0, "a soup without polygons");
  require(soup.first_corner.front() == 0 && soup.first_corner.back() == soup.corners.size(), "corners are lost");
  require(std::is_sorted(soup.first_corner.begin(), soup.first_corner.end()), "polygons overlap");
  for (const Vec3& p : soup.positions) require(p.allFinite(), "a coordinate is not finite");
  const auto count = static_cast<std::int64_t>(soup.positions.size());
  for (const std::int32_t v : soup.corners) require(v >= 0 && v < count, "an index is out of range");
  check_appearance(soup.appearance, soup.corners.size(), soup.polygon_count());
}

/// The faces round each vertex must form one fan: as many faces as can be reached from one of them through edges at the
/// vertex.
void check_fans(const std::vector<std::array<std::int32_t, 3>>& faces, std::int32_t vertices) {
  // Per vertex the edge opposite to it in each face; a fan is a path or a cycle of these edges.
  std::vector<std::map<std::int32_t, std::int32_t>> next(static_cast<std::size_t>(vertices));
  for (const auto& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto& links = next[f[i]];
      require(links.emplace(f[(i + 1) % 3], f[(i + 2) % 3]).second, "two faces run through an edge in one direction");
    }
  }
  for (const auto& links : next) {
    require(!links.empty(), "a vertex has no face");
    std::map<std::int32_t, std::int32_t> previous;
    for (const auto& [from, to] : links) {
      require(previous.emplace(to, from).second, "two faces run through an edge in one direction");
    }
    std::int32_t first = links.begin()->first;
    for (std::size_t i = 0; i < links.size() && previous.count(first) > 0; ++i) first = previous[first];
    std::size_t reached = 0;
    for (auto it = links.find(first); it != links.end() && reached < links.size(); it = links.find(it->second)) {
      ++reached;
    }
    require(reached == links.size(), "the faces round a vertex form more than one fan");
  }
}

void check_mesh(const Mesh& mesh) {
  require(mesh.face_count() > 0, "a mesh without faces");
  std::vector<std::array<std::int32_t, 3>> faces;
  for (FaceId f(0); f.value() < mesh.face_count(); f = FaceId(f.value() + 1)) {
    const auto& [a, b, c] = mesh.vertices(f);
    require(a != b && b != c && c != a, "a face with a repeated corner");
    faces.push_back({a.value(), b.value(), c.value()});
  }
  check_fans(faces, mesh.vertex_count());
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) {
    const double length = mesh.length(EdgeId(e));
    require(length > 0 && std::isfinite(length), "an edge without a length");
  }
}

void check_maps(const CheckedMesh& checked, const PolygonSoup& soup) {
  require(checked.mesh_vertex.size() == soup.positions.size(), "an input vertex has no entry");
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const VertexId to = checked.mesh_vertex[v];
    require(!to.valid() || to.value() < checked.mesh.vertex_count(), "an input vertex leads out of the mesh");
    if (to.valid()) require(checked.mesh.position(to) == soup.positions[v], "a repair has moved a vertex");
  }
  require(static_cast<std::int32_t>(checked.input_polygon.size()) == checked.mesh.face_count(),
          "a face has no polygon");
  for (const std::int32_t p : checked.input_polygon) {
    require(p >= 0 && static_cast<std::size_t>(p) < soup.polygon_count(), "a face has no polygon");
  }
  for (const std::string& message : checked.defects.messages) {
    require(message.find_first_of("\r\n") == message.npos, "a message of several lines: " + message);
  }
}

void require_same(const Mesh& a, const Mesh& b) {
  require(a.vertex_count() == b.vertex_count() && a.face_count() == b.face_count(), "other numbers of elements");
  for (VertexId v(0); v.value() < a.vertex_count(); v = VertexId(v.value() + 1)) {
    require(same_bits(a.position(v), b.position(v)), fmt::format("vertex {} has moved", v.value()));
  }
  for (FaceId f(0); f.value() < a.face_count(); f = FaceId(f.value() + 1)) {
    require(a.vertices(f) == b.vertices(f), fmt::format("face {} has other corners", f.value()));
  }
}

std::string write(const CheckedMesh& checked, MeshFormat format, bool ascii) {
  LabelledMesh labelled{checked.mesh};
  labelled.appearance = &checked.appearance;
  labelled.ascii_ply = ascii;
  std::ostringstream out;
  write_mesh(out, labelled, format);
  return std::move(out).str();
}

/// Texture coordinates in files may be 32-bit floats. A face with a corner without any, or beyond floats, has none.
void require_same(const Mesh& mesh, const Appearance& a, const Appearance& b) {
  const auto has_texture = [&](const Appearance& appearance, FaceId f) {
    const auto corner = [&](int i) { return appearance.texture[Mesh::halfedge(f, i).index()]; };
    const auto fits = [&](int i) {
      constexpr double kMost = std::numeric_limits<float>::max();
      return std::abs(corner(i)[0]) <= kMost && std::abs(corner(i)[1]) <= kMost;
    };
    return !appearance.texture.empty() && fits(0) && fits(1) && fits(2);
  };
  for (const FaceId f : mesh.faces()) {
    require(has_texture(a, f) == has_texture(b, f), "a face has lost its texture coordinates");
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (!has_texture(a, f)) break;
      const auto &before = a.texture[h.index()], &after = b.texture[h.index()];
      const auto is_near = [&](std::size_t k) { return static_cast<float>(before[k]) == static_cast<float>(after[k]); };
      require(is_near(0) && is_near(1), "a corner has other texture coordinates");
    }
    const auto material = [&](const Appearance& appearance) {
      const std::int32_t m = appearance.material.empty() ? -1 : appearance.material[f.index()];
      return m < 0 ? std::string() : appearance.materials[static_cast<std::size_t>(m)];
    };
    if (!b.material.empty()) require(material(a) == material(b), "a face has another material");
  }
}

void check_written(const CheckedMesh& checked, MeshFormat format, bool ascii) {
  const Mesh& mesh = checked.mesh;
  // What a repair leaves of a mesh may be smaller than a mesh may be.
  const bool may_be_refused = mesh.bbox_diagonal() < 2 * kSmallestExtent;
  attempt({may_be_refused ? ErrorCode::precondition : ErrorCode::invalid_option}, [&] {
    const PolygonSoup soup = parse_soup(write(checked, format, ascii), format, "the written file");
    const CheckedMesh again = build_mesh(soup, DefectPolicy::error);
    require_same(mesh, again.mesh);
    if (has_any(format_row(format).carries, Content::texture)) require_same(mesh, checked.appearance, again.appearance);
  });
}

/// Writes the triangles in a format with 32-bit floats, and compares the corners.
void check_written_floats(const CheckedMesh& checked, MeshFormat format) {
  const Mesh& mesh = checked.mesh;
  std::string bytes;
  if (!attempt({ErrorCode::unwritable_output}, [&] { bytes = write(checked, format, false); })) return;
  PolygonSoup soup;
  attempt({}, [&] { soup = parse_soup(bytes, format, "the written file"); });
  require(soup.polygon_count() == static_cast<std::size_t>(mesh.face_count()), "other numbers of triangles");
  for (std::size_t f = 0; f < soup.polygon_count(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 wanted = mesh.position(mesh.vertices(FaceId(f))[i]).cast<float>().cast<double>();
      // A node's transform turns -0 into 0.
      require(wanted == soup.positions[soup.polygon(f)[i]], "a corner has moved");
    }
  }
}

void check_policy(const PolygonSoup& soup, DefectPolicy policy, MeshFormat format) {
  CheckedMesh checked;
  if (!attempt({ErrorCode::precondition}, [&] { checked = build_mesh(soup, policy); })) return;
  check_mesh(checked.mesh);
  check_maps(checked, soup);
  check_appearance(checked.appearance, 3 * checked.input_polygon.size(), checked.input_polygon.size());
  if (policy != DefectPolicy::repair) return;
  if (format_row(format).write == nullptr) return;
  if (!has_any(format_row(format).carries, Content::doubles)) return check_written_floats(checked, format);
  check_written(checked, format, false);
  if (format == MeshFormat::ply) check_written(checked, format, true);
}

/// Properties: there is one for each element of the soup, or a value for each entry of a list.
void check_properties(const std::string& bytes, MeshFormat format) {
  std::vector<MeshProperty> found;
  if (!attempt({ErrorCode::unreadable_input}, [&] { found = parse_mesh_properties(bytes, format, "input"); })) return;
  for (const MeshProperty& property : found) {
    if (!property.count_type) continue;
    require(!property.first_value.empty() && property.first_value.front() == 0, "a list has no beginning");
    require(property.first_value.back() == property.values.size(), "values of lists are lost");
    require(std::is_sorted(property.first_value.begin(), property.first_value.end()), "lists overlap");
  }
}

}  // namespace

void check_reading(const std::uint8_t* data, std::size_t size, MeshFormat format) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto detected = detect_format(bytes, "input");
  PolygonSoup soup;
  const bool is_read = attempt({ErrorCode::unreadable_input, ErrorCode::precondition},
                               [&] { soup = parse_soup(bytes, format, "input"); });
  if (!is_read) return;
  check_soup(soup);
  check_properties(bytes, format);
  const bool is_packed = bytes.starts_with("\x1f\x8b");
  if (format == MeshFormat::ply && !is_packed)
    require(detected == MeshFormat::ply, "a PLY is taken for something else");
  for (const DefectPolicy policy : {DefectPolicy::error, DefectPolicy::repair, DefectPolicy::largest}) {
    check_policy(soup, policy, format);
  }
}

}  // namespace gvd::fuzz
