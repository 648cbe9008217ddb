#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/writers/json_text.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_json_text {

using namespace test;

/// What `print` prints.
template <class Print>
std::string printed(Print print) {
  std::ostringstream stream;
  io::ByteWriter out(stream);
  print(out);
  out.finish();
  return stream.str();
}

std::string lines_of(const std::vector<int>& items) {
  return printed([&](io::ByteWriter& out) { io::print_lines(out, items, [&](int i) { out.print("{}", i); }); });
}

std::string array_of(const std::vector<int>& items) {
  return printed([&](io::ByteWriter& out) { io::print_array(out, items, [&](int i) { out.print("{}", i); }); });
}

TEST_CASE("a number has its shortest digits; infinity and NaN are null") {
  using Double = std::numeric_limits<double>;
  CHECK(io::json_number(0.1) == "0.1");
  CHECK(io::json_number(3) == "3");
  CHECK(io::json_number(1e-7) == "1e-07");
  for (const double value : {Double::infinity(), -Double::infinity(), Double::quiet_NaN()}) {
    CHECK(io::json_number(value) == "null");
  }
  for (const double value : {1.0 / 3, Double::max(), Double::denorm_min(), -0.0}) {
    CHECK(nlohmann::json::parse(io::json_number(value)).get<double>() == value);
  }
}

TEST_CASE("a surface point has its face, its coordinates and its position") {
  const Mesh mesh = make_grid(2, 2);
  const SurfacePoint point = make_surface_point(FaceId(3), {0.25, 0.25, 0.5});
  const auto json =
      nlohmann::ordered_json::parse(printed([&](io::ByteWriter& out) { io::print_point(out, mesh, point); }));
  const Vec3 p = position(mesh, point);
  CHECK(json.dump() ==
        nlohmann::ordered_json({{"face", 3}, {"bary", {0.25, 0.25, 0.5}}, {"position", {p.x(), p.y(), 0}}}).dump());
}

TEST_CASE("an array is printed on one line, or with a line for each item") {
  CHECK(lines_of({}) == "[]");
  CHECK(lines_of({1}) == "[\n  1\n]");
  CHECK(lines_of({1, 2}) == "[\n  1,\n  2\n]");
  CHECK(array_of({}) == "[]");
  CHECK(array_of({1}) == "[1]");
  CHECK(array_of({1, 2}) == "[1,2]");
}

}  // namespace gvd::test_json_text
