#include "io/generator_fixture.hpp"

namespace gvd::test {

GeneratorList parse(const std::string& text, GeneratorFormat format) { return parse_generators(text, format, "list"); }

double uniform(std::mt19937& random) { return double(random()) / double(std::mt19937::max()); }

SurfacePoint random_point(const Mesh& mesh, std::mt19937& random) {
  const FaceId face(random() % static_cast<unsigned>(mesh.face_count()));
  const double u = uniform(random), v = uniform(random) * (1 - u);
  return make_surface_point(face, random() % 4 == 0 ? std::array{u, 1 - u, 0.0} : std::array{u, v, 1 - u - v});
}

}  // namespace gvd::test
