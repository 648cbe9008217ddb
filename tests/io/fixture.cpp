#include "io/fixture.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "support/meshes.hpp"

namespace gvd::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The grid's positions, shifted by numbers that need all 17 digits.
Mesh make_surface() {
  const Mesh grid = make_grid(4, 3);
  std::vector<Vec3> positions = grid.positions();
  std::vector<std::array<VertexId, 3>> faces;
  for (Vec3& p : positions) p = p / 3 + Vec3(0.1, 1e-7 / 7, 1e5 / 3);
  for (int f = 0; f < grid.face_count(); ++f) faces.push_back(grid.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

Diagram make_diagram(const Mesh& mesh) {
  Diagram diagram;
  diagram.generators = {vertex_point(mesh, VertexId(0)), make_surface_point(FaceId(5), {0.1, 0.2, 0.7}),
                        edge_point(HalfedgeId(40), 1.0 / 3)};
  diagram.vertex_label.resize(mesh.positions().size());
  diagram.vertex_distance.resize(mesh.positions().size(), kInfinity);
  for (int v = 0; v + 1 < mesh.vertex_count(); ++v) {
    diagram.vertex_label[VertexId(v)] = GeneratorId(v % 3);
    diagram.vertex_distance[VertexId(v)] = v / 7.0;
  }
  const SurfacePoint centre = make_surface_point(FaceId(7), {0.25, 0.25, 0.5});
  diagram.branch_points.push_back(
      {centre, position(mesh, centre), {GeneratorId(0), GeneratorId(1), GeneratorId(2)}, 2.0 / 3});
  const BranchPointId branch(0);
  const SurfacePoint end = edge_point(HalfedgeId(0), 0.5), middle = edge_point(HalfedgeId(21), 0.25);
  diagram.bisectors.push_back(
      {GeneratorId(0), GeneratorId(1), false, {branch, BranchPointId()}, {centre, middle, end}});
  diagram.bisectors.push_back({GeneratorId(1), GeneratorId(2), false, {BranchPointId(), branch}, {middle, centre}});
  const std::vector<SurfacePoint> ring{edge_point(HalfedgeId(30), 0.5), edge_point(HalfedgeId(31), 0.5),
                                       edge_point(HalfedgeId(32), 0.5)};
  diagram.bisectors.push_back({GeneratorId(2), GeneratorId(2), true, {}, ring});
  diagram.cells.push_back({GeneratorId(0), 0.5, 1, 1, 1, {GeneratorId(1)}});
  diagram.cells.push_back({GeneratorId(1), 1.0 / 3, 1, 2, 2, {GeneratorId(0), GeneratorId(2)}});
  diagram.cells.push_back({GeneratorId(2), 0.25, 0, 1, 2, {GeneratorId(1)}});
  diagram.length = 4.5;
  diagram.report.unresolved_ends = 2;
  return diagram;
}

}  // namespace

Labelled::Labelled() : mesh(make_surface()), diagram(make_diagram(mesh)) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    face_label.push_back(GeneratorId(f % 4 == 3 ? -1 : 2 - f % 4));
    face_parent.push_back(FaceId(f / 2));
  }
}

LabelledMesh Labelled::view() const {
  LabelledMesh view{mesh};
  view.face_label = &face_label;
  view.face_parent = &face_parent;
  view.vertex_label = &diagram.vertex_label;
  view.vertex_distance = &diagram.vertex_distance;
  view.diagram = &diagram;
  return view;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "gvd-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("no file " + path.string());
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

Rgb color_in(const LabelledMesh& mesh, GeneratorId label) {
  return label.valid() ? region_colors(mesh).at(label.index()) : kUnlabelledColor;
}

std::string to_bytes(const LabelledMesh& mesh, MeshFormat format) {
  std::ostringstream out;
  write_mesh(out, mesh, format);
  return out.str();
}

template <class T>
T take(const std::string& bytes, std::size_t& offset) {
  if (offset + sizeof(T) > bytes.size()) throw std::runtime_error("the file ends too early");
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  offset += sizeof(T);
  return value;
}
template float take(const std::string&, std::size_t&);
template double take(const std::string&, std::size_t&);
template std::int32_t take(const std::string&, std::size_t&);
template std::int64_t take(const std::string&, std::size_t&);
template std::uint8_t take(const std::string&, std::size_t&);
template std::uint16_t take(const std::string&, std::size_t&);
template std::uint32_t take(const std::string&, std::size_t&);
template std::uint64_t take(const std::string&, std::size_t&);

}  // namespace gvd::test
