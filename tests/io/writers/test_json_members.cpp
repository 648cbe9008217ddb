#include <nlohmann/json.hpp>
#include <sstream>

#include "gvd/error.hpp"
#include "io/writers/byte_writer.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_json_members {

TEST_CASE("an open diagram becomes an object with one more member") {
  const Mesh mesh = test::make_grid(1, 1);
  std::ostringstream text;
  io::ByteWriter out(text);
  io::print_open_diagram(out, mesh, compute_diagram(mesh, {vertex_point(mesh, VertexId(0))}));
  out.text(",\"more\":1}");
  out.finish();
  const auto json = nlohmann::ordered_json::parse(text.str());
  CHECK(json["schema"] == "gvd-diagram/1");
  CHECK(json["cells"].size() == 1);
  CHECK(json.back() == 1);
}

TEST_CASE("a mesh has an element a line, and its doubles come back") {
  const Mesh mesh({{0, 1.0 / 3, 1e-300}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  std::ostringstream text;
  io::ByteWriter out(text);
  io::print_mesh_members(out, mesh);
  out.finish();
  CHECK(text.str() == "\"vertices\":[\n[0,0.3333333333333333,1e-300],\n[1,0,0],\n[0,1,0]],\n\"faces\":[\n[0,1,2]]");
}

TEST_CASE("a stream that has failed is an error at the end") {
  std::ostringstream text;
  io::ByteWriter good(text), failed(text);
  CHECK_NOTHROW(good.finish());
  text.setstate(std::ios::badbit);
  CHECK_THROWS_AS(failed.finish(), Error);
}

}  // namespace gvd::test_json_members
