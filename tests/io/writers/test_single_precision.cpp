// Meshes far from the origin: a GLB keeps their place, formats with doubles keep them, and the loss of others is told.

#include <cmath>
#include <nlohmann/json.hpp>

#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "io/fixture.hpp"
#include "io/writers/format_writers.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_single_precision {

using namespace test;

/// A bumpy field of 30 x 20 quads with edges of 0.1, at a place as in a survey.
Mesh make_field(const Vec3& place) {
  const Mesh grid = make_grid(30, 20);
  std::vector<Vec3> positions;
  for (const Vec3& p : grid.positions()) {
    positions.push_back(place + Vec3(0.1 * p.x(), 0.1 * p.y(), 0.03 * std::sin(p.x() * p.y())));
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (const FaceId f : grid.faces()) faces.push_back(grid.vertices(f));
  return {std::move(positions), std::move(faces)};
}

const Vec3 kSurvey(431234.37, 5412345.81, 212.6);

/// The JSON chunk of a GLB.
nlohmann::json description(const std::string& glb) {
  std::size_t offset = 12;
  const auto length = take<std::uint32_t>(glb, offset);
  return nlohmann::json::parse(glb.substr(20, length));
}

double area_of(const PolygonSoup& soup) {
  double area = 0;
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    const auto at = [&](std::size_t i) { return soup.positions[std::size_t(soup.polygon(p)[i])]; };
    area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
  }
  return area;
}

TEST_CASE("a GLB far from the origin has its place as the translation of all nodes, and comes back to local rounding") {
  const Mesh mesh = make_field(kSurvey);
  const Diagram diagram = compute_diagram(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(600))});
  IdVector<FaceId, GeneratorId> label;
  for (const FaceId f : mesh.faces()) label.push_back(diagram.vertex_label[mesh.vertices(f)[0]]);
  const LabelledMesh view = label_mesh(mesh, diagram, label);
  const std::string bytes = to_bytes(view, MeshFormat::glb);
  const nlohmann::json nodes = description(bytes)["nodes"];
  REQUIRE(nodes.size() == 2);
  CHECK(nodes[0]["translation"] == nodes[1]["translation"]);
  for (const double number : nodes[0]["translation"]) CHECK(number == double(float(number)));

  const TemporaryFolder folder;
  write_bytes(folder / "a.glb", bytes);
  const PolygonSoup soup = read_soup(folder / "a.glb");
  // Every corner is within a float's rounding at the size of the mesh, and a double's at its place.
  const double rounding = mesh.bbox_diagonal() * 0x1p-24 + mesh.largest_coordinate() * 0x1p-52;
  REQUIRE(soup.corners.size() == std::size_t(mesh.halfedge_count()));
  for (const HalfedgeId h : mesh.halfedges()) {
    const Vec3& read = soup.positions[std::size_t(soup.corners[h.index()])];
    REQUIRE((read - mesh.position(mesh.from(h))).cwiseAbs().maxCoeff() <= rounding);
  }
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  CHECK(area_of(soup) == Approx(area).epsilon(1e-6));
  CHECK(!measure_position_loss(mesh, MeshFormat::glb).is_notable);
  // What was read is written with the same place.
  const Mesh again = build_mesh(soup, DefectPolicy::repair, "a.glb").mesh;
  CHECK(io::glb_translation(again) == io::glb_translation(mesh));
}

TEST_CASE("a GLB near the origin has no translation") {
  const auto triangle = [](double at) {
    return Mesh({{at, 0, 0}, {at - 3, 0, 0}, {at, 4, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  };
  CHECK(io::glb_translation(triangle(80)).isZero(0));  // 16 diagonals
  CHECK(io::glb_translation(triangle(-76)).isZero(0));
  CHECK(io::glb_translation(triangle(81)) == Vec3(80, 0, 0));
  CHECK(io::glb_translation(triangle(-90)) == Vec3(-92, 0, 0));
  CHECK(!description(to_bytes(LabelledMesh{triangle(80)}, MeshFormat::glb))["nodes"][0].contains("translation"));
  for (const NamedMesh& named : small_family()) CHECK(io::glb_translation(named.mesh).isZero(0));
}

TEST_CASE("the translation of a GLB is a float at any size and place") {
  for (const double size : {1e-300, 1e-30, 1e-3, 1.0, 1e20}) {
    for (const double place : {1e-20, 1.0, 431234.37, 1e15, 1e30}) {
      CAPTURE(size, place);
      if (place + size == place) continue;  // doubles can't hold such a mesh
      const Mesh mesh({{place, place, 0}, {place + size, place, 0}, {place, place + size, 0}},
                      {{VertexId(0), VertexId(1), VertexId(2)}});
      const Vec3 translation = io::glb_translation(mesh);
      CHECK(translation == translation.cast<float>().cast<double>());
      CHECK(io::largest_local_coordinate(mesh, translation) <= mesh.largest_coordinate());
    }
  }
}

TEST_CASE("formats with doubles keep every bit of a mesh far from the origin") {
  const Mesh mesh = make_field(kSurvey);
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.coff", "a.vtp", "a.vtu"}) {
    CAPTURE(name);
    write_mesh(folder / name, LabelledMesh{mesh});
    if (std::string_view(name) == "a.vtu") continue;  // written, and read by others
    const std::string read_name = std::string_view(name) == "a.coff" ? "b.off" : name;
    if (read_name != name) write_bytes(folder / read_name, read_bytes(folder / name));
    CHECK(read_soup(folder / read_name).positions == mesh.positions());
    const PositionLoss loss = measure_position_loss(mesh, output_format(folder / name));
    CHECK(loss.farthest_move == 0);
    CHECK(loss.collapsed_faces == 0);
    CHECK(!loss.is_notable);
  }
}

TEST_CASE("the loss of 32-bit floats: how far vertices move, and the faces that collapse, as a reader finds them") {
  const Mesh mesh = make_field(kSurvey);
  const TemporaryFolder folder;
  write_mesh(folder / "a.stl", LabelledMesh{mesh});
  const PolygonSoup soup = read_soup(folder / "a.stl");
  double moved = 0;
  std::int64_t collapsed = 0;
  for (const FaceId f : mesh.faces()) {
    std::array<Vec3, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = soup.positions[std::size_t(soup.polygon(f.index())[i])];
      moved = std::max(moved, (at[i] - mesh.position(mesh.vertices(f)[i])).norm());
    }
    collapsed += (at[1] - at[0]).cross(at[2] - at[0]).norm() == 0;
  }
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::gii, MeshFormat::fs}) {
    const PositionLoss loss = measure_position_loss(mesh, format);
    CHECK(loss.is_notable);
    CHECK(loss.farthest_move == Approx(moved));
    CHECK(loss.farthest_move > 0.2);
    CHECK(loss.collapsed_faces == collapsed);
    CHECK(loss.collapsed_faces > 10);
  }
}

TEST_CASE("the loss of 32-bit floats is not told of ordinary meshes") {
  for (const NamedMesh& named : small_family()) {
    CAPTURE(named.name);
    for (const MeshFormat format : {MeshFormat::stl, MeshFormat::glb, MeshFormat::gii}) {
      CHECK(!measure_position_loss(named.mesh, format).is_notable);
    }
  }
  // A brain or a tooth in the coordinates of its scanner.
  CHECK(!measure_position_loss(make_field({120, -300, 45}), MeshFormat::stl).is_notable);
}

}  // namespace gvd::test_single_precision
