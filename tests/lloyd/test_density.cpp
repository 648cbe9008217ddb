#include <algorithm>
#include <cmath>

#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/lloyd.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_density {

TEST_CASE("density: values of vertices are linear in faces, values of faces constant") {
  const Mesh mesh = test::make_sphere(1);
  std::vector<double> of_vertices, of_faces;
  for (std::size_t i = 0; i < mesh.positions().size(); ++i) of_vertices.push_back(1 + 0.5 * static_cast<double>(i));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) of_faces.push_back(2 + f);
  const Density linear = make_vertex_density(mesh, of_vertices), constant = make_face_density(mesh, of_faces);
  const FaceId face(7);
  const auto& [a, b, c] = mesh.vertices(face);
  CHECK(linear.at(face, {0.2, 0.3, 0.5}) ==
        Approx(0.2 * of_vertices[a.index()] + 0.3 * of_vertices[b.index()] + 0.5 * of_vertices[c.index()]));
  CHECK(constant.at(face, {0.2, 0.3, 0.5}) == Approx(9));
  CHECK(Density{}.at(face, {0.2, 0.3, 0.5}) == 1);
}

TEST_CASE("density: wrong numbers of values, and values that are no weights, are refused") {
  const Mesh mesh = test::make_sphere(1);
  CHECK_THROWS_AS(make_vertex_density(mesh, {1, 2}), Error);
  CHECK_THROWS_AS(make_face_density(mesh, {1, 2}), Error);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    std::vector<double> values(static_cast<std::size_t>(mesh.face_count()), 1);
    values[3] = bad;
    CHECK_THROWS_AS(make_face_density(mesh, values), Error);
  }
  LloydOptions options;
  options.density = make_face_density(test::make_sphere(0), std::vector<double>(20, 1));
  CHECK_THROWS_AS(relax_generators(mesh, test::random_generators(mesh, 3, 1), options), Error);
}

TEST_CASE("density: a uniform one changes nothing, and its unit does not matter") {
  const Mesh mesh = test::make_bumpy_sphere(2, 1);
  const auto start = test::random_generators(mesh, 9, 2);
  LloydOptions options;
  options.max_iterations = 8;
  const LloydStages exact{.early_approximation = false};
  const LloydResult plain = relax_generators(mesh, start, options, exact);
  options.density = make_vertex_density(mesh, std::vector<double>(mesh.positions().size(), 4));
  const LloydResult heavy = relax_generators(mesh, start, options, exact);
  // Rounded weights lead to steps that differ a little.
  CHECK(heavy.final_energy == Approx(4 * plain.final_energy).epsilon(1e-4));
}

TEST_CASE("density: cells are smaller where it is large") {
  const Mesh mesh = test::make_sphere(3);
  std::vector<double> values;
  for (const Vec3& p : mesh.positions()) values.push_back(p.z() > 0 ? 16 : 1);
  LloydOptions options;
  options.density = make_vertex_density(mesh, values);
  const LloydResult result = relax_generators(mesh, test::random_generators(mesh, 40, 1), options);
  int above = 0;
  for (const SurfacePoint& p : result.generators) above += position(mesh, p).z() > 0;
  // In the limit the numbers go with the root of the density: 4 to 1.
  CHECK(above >= 29);
  CHECK(above <= 35);
}

}  // namespace gvd::test_density
