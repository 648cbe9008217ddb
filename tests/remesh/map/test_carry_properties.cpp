// Properties of an input on its remesh: interpolated where they can be, else those of the nearest corner. Texture
// coordinates: of one chart for each face, stretched at seams and never across them.
#include <algorithm>
#include <cmath>

#include "gvd/carry_properties.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_carry_properties {

/// A sphere as from a file without a defect.
CheckedMesh make_input() {
  const Mesh sphere = test::make_sphere(3);
  PolygonSoup soup;
  soup.positions = sphere.positions();
  for (std::int32_t f = 0; f < sphere.face_count(); ++f) {
    for (const VertexId v : sphere.vertices(FaceId(f))) soup.corners.push_back(v.value());
    soup.close_polygon();
  }
  return build_mesh(soup);
}

/// A property of the vertices: a function of their positions.
template <class Function>
MeshProperty of_vertices(const CheckedMesh& input, const char* name, NumberType type, Function function) {
  MeshProperty property{name, type, true, {}};
  for (const Vec3& p : input.mesh.positions()) property.values.push_back(function(p));
  return property;
}

std::vector<MeshProperty> normals(const CheckedMesh& input) {
  return {of_vertices(input, "nx", NumberType::float32, [](const Vec3& p) { return p.x(); }),
          of_vertices(input, "ny", NumberType::float32, [](const Vec3& p) { return p.y(); }),
          of_vertices(input, "nz", NumberType::float32, [](const Vec3& p) { return p.z(); })};
}

/// Values at the generators.
std::vector<MeshProperty> carry(const CheckedMesh& input, const std::vector<MeshProperty>& properties,
                                const RemeshResult& result) {
  RemeshMap map;
  map.origins = IdVector<VertexId, SurfacePoint>(result.generators);
  return carry_properties(input, properties, result, map);
}

RemeshResult make_remesh(const CheckedMesh& input) {
  return remesh(input.mesh, test::random_generators(input.mesh, 60, 4));
}

TEST_CASE("carry: a linear function has its value at each generator") {
  const CheckedMesh input = make_input();
  const RemeshResult result = make_remesh(input);
  const auto height = [](const Vec3& p) { return 3 * p.z() - p.x() + 1; };
  const auto carried = carry(input, {of_vertices(input, "h", NumberType::float64, height)}, result);
  REQUIRE(carried.size() == 1);
  CHECK(carried[0].name == "h");
  CHECK(carried[0].type == NumberType::float64);
  REQUIRE(carried[0].values.size() == result.generators.size());
  for (std::size_t i = 0; i < carried[0].values.size(); ++i) {
    CHECK(carried[0].values[i] == Approx(height(position(input.mesh, result.generators[i]))).margin(1e-12));
  }
}

TEST_CASE("carry: labels are not mixed, colours are") {
  const CheckedMesh input = make_input();
  const RemeshResult result = make_remesh(input);
  const auto half = [](const Vec3& p) { return p.z() > 0 ? 200.0 : 0.0; };
  const auto carried = carry(
      input,
      {of_vertices(input, "part", NumberType::uint8, half), of_vertices(input, "diffuse_red", NumberType::uint8, half)},
      result);
  REQUIRE(carried.size() == 2);
  const auto is_mixed = [](double value) { return value > 1e-9 && value < 200 - 1e-9; };
  CHECK(std::none_of(carried[0].values.begin(), carried[0].values.end(), is_mixed));
  CHECK(std::any_of(carried[0].values.begin(), carried[0].values.end(), [](double value) { return value == 200; }));
  CHECK(std::any_of(carried[1].values.begin(), carried[1].values.end(), is_mixed));
}

TEST_CASE("carry: normals have length 1") {
  const CheckedMesh input = make_input();
  const auto carried = carry(input, normals(input), make_remesh(input));
  REQUIRE(carried.size() == 3);
  for (std::size_t i = 0; i < carried[0].values.size(); ++i) {
    CHECK(std::hypot(carried[0].values[i], carried[1].values[i], carried[2].values[i]) == Approx(1));
  }
}

TEST_CASE("carry: a generator at a vertex has its values, whatever those of the neighbours are") {
  const CheckedMesh input = make_input();
  std::vector<SurfacePoint> generators;
  for (int i = 0; i < 30; ++i) generators.push_back(vertex_point(input.mesh, VertexId(20 * i)));
  MeshProperty property{"value", NumberType::float64, true, {}};
  for (int v = 0; v < input.mesh.vertex_count(); ++v) property.values.push_back(v % 20 == 0 ? v : std::nan(""));
  const auto carried = carry(input, {property}, remesh(input.mesh, generators));
  for (std::size_t i = 0; i < 30; ++i) CHECK(carried[0].values[i] == 20.0 * static_cast<double>(i));
}

TEST_CASE("carry: a face has the value of the face in which its branch point is") {
  const CheckedMesh input = make_input();
  const RemeshResult result = make_remesh(input);
  MeshProperty number{"number", NumberType::int32, false, {}};
  for (int f = 0; f < input.mesh.face_count(); ++f) number.values.push_back(f);
  const auto carried = carry(input, {number}, result);
  REQUIRE(carried.size() == 1);
  CHECK(!carried[0].of_vertices);
  REQUIRE(carried[0].values.size() == static_cast<std::size_t>(result.mesh.face_count()));
  for (std::size_t f = 0; f < result.face_points.size(); ++f) {
    CHECK(carried[0].values[f] == result.face_points[f].face.value());
  }
}

TEST_CASE("carry: a property that has no value for some elements is left out") {
  const CheckedMesh input = make_input();
  const RemeshResult result = make_remesh(input);
  CHECK(carry(input, {{"short", NumberType::float32, true, {1, 2, 3}}}, result).empty());
  CHECK(carry(input, {{"short", NumberType::float32, false, {1, 2, 3}}}, result).empty());
}

TEST_CASE("carry: a vertex has the values at its origin, which is not always the generator") {
  const CheckedMesh input = make_input();
  const RemeshResult result = make_remesh(input);
  const RemeshMap map = map_to_remesh(input.mesh, result);
  const auto height = [](const Vec3& p) { return 3 * p.z() - p.x() + 1; };
  const auto carried = carry_properties(input, {of_vertices(input, "h", NumberType::float64, height)}, result, map);
  REQUIRE(carried.size() == 1);
  for (std::size_t i = 0; i < carried[0].values.size(); ++i) {
    const SurfacePoint& origin = map.origins[VertexId(i)];
    CHECK(carried[0].values[i] == Approx(height(position(input.mesh, origin))).margin(1e-12));
  }
}

TEST_CASE("carry: lists are those of the nearest corner, and of the polygon") {
  const CheckedMesh input = make_input();
  const RemeshResult result = make_remesh(input);
  MeshProperty ids{"ids", NumberType::int32, true, {}, NumberType::uint8, {0}};
  for (int v = 0; v < input.mesh.vertex_count(); ++v) {
    for (int i = 0; i < v % 3; ++i) ids.values.push_back(v);
    ids.first_value.push_back(ids.values.size());
  }
  MeshProperty weights{"weights", NumberType::float32, false, {}, NumberType::uint8, {0}};
  for (int f = 0; f < input.mesh.face_count(); ++f) {
    weights.values.insert(weights.values.end(), {0.5 * f, 1.0 * f});
    weights.first_value.push_back(weights.values.size());
  }
  const auto carried = carry(input, {ids, weights}, result);
  REQUIRE(carried.size() == 2);
  REQUIRE(carried[0].element_count() == result.generators.size());
  for (std::size_t i = 0; i < result.generators.size(); ++i) {
    const SurfacePoint& at = result.generators[i];
    const auto largest = std::max_element(at.bary.begin(), at.bary.end()) - at.bary.begin();
    const int v = input.mesh.vertices(at.face)[largest].value();
    REQUIRE(carried[0].first_value[i + 1] - carried[0].first_value[i] == static_cast<std::size_t>(v % 3));
    for (std::size_t k = carried[0].first_value[i]; k < carried[0].first_value[i + 1]; ++k) {
      CHECK(carried[0].values[k] == v);
    }
  }
  REQUIRE(carried[1].element_count() == result.face_points.size());
  CHECK(carried[1].values[1] == result.face_points[0].face.value());
}

/// A flat square of 12 x 12 units, as from a file without a defect.
CheckedMesh make_square() {
  const Mesh grid = test::make_grid(12, 12);
  PolygonSoup soup;
  soup.positions = grid.positions();
  for (std::int32_t f = 0; f < grid.face_count(); ++f) {
    for (const VertexId v : grid.vertices(FaceId(f))) soup.corners.push_back(v.value());
    soup.close_polygon();
  }
  return build_mesh(soup);
}

/// Coordinates by a function of a corner's position and of its face's centre.
template <class Function>
std::vector<Uv> make_texture(const Mesh& mesh, Function function) {
  std::vector<Uv> texture;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& vertices = mesh.vertices(FaceId(f));
    const Vec3 centre = (mesh.position(vertices[0]) + mesh.position(vertices[1]) + mesh.position(vertices[2])) / 3;
    for (const VertexId v : vertices) texture.push_back(function(mesh.position(v), centre));
  }
  return texture;
}

struct Case {
  CheckedMesh input = make_square();
  RemeshResult result = remesh(input.mesh, test::random_generators(input.mesh, 40, 2));
  RemeshMap map = map_to_remesh(input.mesh, result);

  template <class Function>
  std::vector<Uv> carry_texture(Function function) {
    input.appearance.texture = make_texture(input.mesh, function);
    return carry_appearance(input, result, map).texture;
  }

  Vec3 origin(std::size_t corner) const {
    const HalfedgeId h(corner);
    return position(input.mesh, map.origins[result.mesh.from(h)]);
  }
};

TEST_CASE("carry texture: linear coordinates without a seam are those at the origins") {
  Case square;
  const auto carried = square.carry_texture([](const Vec3& p, const Vec3&) { return Uv{p.x() / 12, p.y() / 12 + 1}; });
  REQUIRE(carried.size() == static_cast<std::size_t>(square.result.mesh.halfedge_count()));
  for (std::size_t i = 0; i < carried.size(); ++i) {
    CHECK(carried[i][0] == Approx(square.origin(i).x() / 12).margin(1e-12));
    CHECK(carried[i][1] == Approx(square.origin(i).y() / 12 + 1).margin(1e-12));
  }
}

TEST_CASE("carry texture: a face beside a seam has coordinates of one side only, up to the seam") {
  Case square;
  // The right half lies elsewhere in the texture.
  const auto carried = square.carry_texture([](const Vec3& p, const Vec3& centre) {
    return Uv{centre.x() < 6 ? p.x() : 100 + p.x(), p.y()};
  });
  int across = 0;
  for (std::size_t f = 0; 3 * f < carried.size(); ++f) {
    const bool right = position(square.input.mesh, square.result.face_points[f]).x() > 6;
    for (std::size_t i = 3 * f; i < 3 * f + 3; ++i) {
      const double x = square.origin(i).x();
      across += right != (x > 6);
      const double in_chart = right ? 100 + std::max(x, 6.0) : std::min(x, 6.0);
      CHECK(carried[i][0] == Approx(in_chart).margin(1e-9));
      CHECK(carried[i][1] == Approx(square.origin(i).y()).margin(1e-9));
    }
  }
  CHECK(across > 0);
}

TEST_CASE("carry texture: where the input has none, the remesh has none") {
  Case square;
  const auto carried = square.carry_texture([](const Vec3& p, const Vec3& centre) {
    return centre.x() < 6 ? Uv{p.x(), p.y()} : kNoTexture;
  });
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const bool right = position(square.input.mesh, square.result.face_points[i / 3]).x() > 6;
    CHECK(std::isfinite(carried[i][0]) == !right);
  }
}

TEST_CASE("carry materials: a face has that of the face of its branch point") {
  Case square;
  Appearance& given = square.input.appearance;
  for (std::int32_t f = 0; f < square.input.mesh.face_count(); ++f) given.material.push_back(f % 3 - 1);
  given.materials = {"a", "b"};
  given.material_files = {"c.mtl"};
  const Appearance carried = carry_appearance(square.input, square.result, square.map);
  REQUIRE(carried.material.size() == square.result.face_points.size());
  for (std::size_t f = 0; f < carried.material.size(); ++f) {
    CHECK(carried.material[f] == square.result.face_points[f].face.value() % 3 - 1);
  }
  CHECK(carried.materials == given.materials);
  CHECK(carried.material_files == given.material_files);
  CHECK(carried.texture.empty());
}

}  // namespace gvd::test_carry_properties
