#include <string>

#include "gvd/error.hpp"
#include "io/writers/single_precision.hpp"
#include "support/catch.hpp"

namespace gvd::test_single_precision {

using namespace test;

Mesh triangle(double size, double shift) {
  return Mesh({{shift, 0, 0}, {shift + size, 0, 0}, {shift, size, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
}

std::string refusal(const Mesh& mesh) {
  try {
    io::check_single_precision(mesh, "STL");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::unwritable_output);
    return error.what();
  }
  return "";
}

TEST_CASE("meshes that 32-bit floats hold are taken") {
  for (const double size : {1e-30, 1e-3, 1.0, 1e38}) CHECK(refusal(triangle(size, 0)).empty());
  CHECK(refusal(triangle(1, 1e6)).empty());
}

TEST_CASE("a coordinate beyond a float's range is refused") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal(triangle(1e39, 0)), Contains("STL holds 32-bit floats") && Contains("too large"));
  CHECK_THAT(refusal(triangle(-1e39, 0)), Contains("too large"));
}

TEST_CASE("a mesh smaller than the step of floats is refused") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal(triangle(1, 1e9)),
             Contains("smaller than the step between two of them") && Contains("choose PLY"));
  CHECK_THAT(refusal(triangle(1e-40, 0)), Contains("smaller than the step between two of them"));
}

}  // namespace gvd::test_single_precision
