#include <clocale>
#include <cmath>
#include <random>

#include "gvd/closest_point.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;
using Kind = GeneratorEntry::Kind;

namespace {

GeneratorList parse(const std::string& text, GeneratorFormat format = GeneratorFormat::text) {
  return parse_generators(text, format, "list");
}

std::string refusal(const std::function<void()>& work, ErrorCode code) {
  try {
    work();
  } catch (const Error& error) {
    CHECK(error.code() == code);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "nothing was refused";
}

double uniform(std::mt19937& random) { return double(random()) / double(std::mt19937::max()); }

SurfacePoint random_point(const Mesh& mesh, std::mt19937& random) {
  const FaceId face(static_cast<std::int64_t>(random() % static_cast<unsigned>(mesh.face_count())));
  const double u = uniform(random), v = uniform(random) * (1 - u);
  return make_surface_point(face, random() % 4 == 0 ? std::array{u, 1 - u, 0.0} : std::array{u, v, 1 - u - v});
}

}  // namespace

TEST_CASE("a text list holds vertices, faces with coordinates and positions") {
  const GeneratorList list = parse("\xef\xbb\xbf# three\r\n  17 \r\n\r\n3 0.25 0.5 .25 # a face\np 1e-1 -2 3");
  REQUIRE(list.entries.size() == 3);
  CHECK(list.entries[0].kind == Kind::vertex);
  CHECK(list.entries[0].index == 17);
  CHECK(list.entries[0].line == 2);
  CHECK(list.entries[1].kind == Kind::face);
  CHECK(list.entries[1].index == 3);
  CHECK(list.entries[1].values == std::array{0.25, 0.5, 0.25});
  CHECK(list.entries[2].kind == Kind::position);
  CHECK(list.entries[2].values == std::array{0.1, -2.0, 3.0});
  CHECK(list.entries[2].line == 5);
}

TEST_CASE("a csv list has the same fields, or named columns") {
  const GeneratorList plain = parse("17\n3, 0.25,0.5,0.25\np,1,2,3\n", GeneratorFormat::csv);
  REQUIRE(plain.entries.size() == 3);
  CHECK(plain.entries[2].values == std::array{1.0, 2.0, 3.0});
  const GeneratorList named =
      parse("id,x,y,z,face,b2,b1,b0,vertex\n0,1,2,3,,,,,\n1,,,,7,0.5,0.25,0.25,\n2,,,,,,,,9\n", GeneratorFormat::csv);
  REQUIRE(named.entries.size() == 3);
  CHECK(named.entries[0].kind == Kind::position);
  CHECK(named.entries[1].index == 7);
  CHECK(named.entries[1].values == std::array{0.25, 0.25, 0.5});
  CHECK(named.entries[2].kind == Kind::vertex);
  CHECK(named.entries[2].line == 4);
  CHECK(parse("\"vertex\"\n\"4\"\n", GeneratorFormat::csv).entries[0].index == 4);
}

TEST_CASE("a json list is the array of generators of any object") {
  const GeneratorList list = parse(R"({"schema": "gvd-diagram/1", "cells": [{"generators": [{"vertex": 1}]}],
    "generators": [{"face": 3, "bary": [0.25, 0.5, 0.25], "position": [9, 9, 9]},
                   {"vertex": 5},
                   {"position": [1, 2, 3]}]})",
                                   GeneratorFormat::json);
  REQUIRE(list.entries.size() == 3);
  CHECK(list.entries[0].index == 3);
  CHECK(list.entries[0].line == 2);
  CHECK(list.entries[1].kind == Kind::vertex);
  CHECK(list.entries[1].line == 3);
  CHECK(list.entries[2].values == std::array{1.0, 2.0, 3.0});
  CHECK(list.entries[2].line == 4);
}

TEST_CASE("a damaged list is refused with its name and line") {
  const auto message = [](const std::string& text, GeneratorFormat format) {
    return refusal([&] { parse(text, format); }, ErrorCode::unreadable_input);
  };
  using Catch::Matchers::StartsWith;
  for (const char* line : {"1.5", "-1", "x", "1 2", "1 2 3", "1 a b c", "p 1 2", "p 1 2 nan", "p 1 2 inf", "q 1 2 3",
                           "1 2 3 4 5", "0x10", "1,2,3", "99999999999999999999", "\x01\xff"}) {
    CAPTURE(line);
    CHECK_THAT(message(std::string("# ok\n4\n") + line + "\n5\n", GeneratorFormat::text), StartsWith("list:3: "));
  }
  CHECK_THAT(message("", GeneratorFormat::text), StartsWith("list:1: "));
  CHECK_THAT(message("# nothing\n\n", GeneratorFormat::csv), StartsWith("list:1: "));
  CHECK_THAT(message("name,other\n1,2\n", GeneratorFormat::csv), StartsWith("list:1: "));
  CHECK_THAT(message("vertex,other\n1\n", GeneratorFormat::csv), StartsWith("list:2: "));
  CHECK_THAT(message("vertex\n1\n,\n", GeneratorFormat::csv), StartsWith("list:3: "));
  CHECK_THAT(message("x,y,z\n1,2,3\n1,,3\n", GeneratorFormat::csv), StartsWith("list:3: "));
  CHECK_THAT(message(std::string(300, 'x'), GeneratorFormat::text), !Catch::Matchers::Contains(std::string(60, 'x')));
  for (const char* text :
       {"", "{", "[1]", "{}", "{\"generators\":3}", "{\"generators\":[]}", "{\"generators\":[3]}", "\xff\xfe{}"}) {
    CAPTURE(text);
    CHECK_THAT(message(text, GeneratorFormat::json), StartsWith("list:1: "));
  }
  for (const char* object : {"{}", "{\"face\":1}", "{\"face\":-1,\"bary\":[1,0,0]}", "{\"face\":1.5,\"bary\":[1,0,0]}",
                             "{\"face\":1,\"bary\":[1,0]}", "{\"face\":1,\"bary\":[1,0,\"0\"]}", "{\"vertex\":\"3\"}",
                             "{\"position\":[1,2,1e999]}", "{\"vertex\":18446744073709551615}"}) {
    CAPTURE(object);
    CHECK_THAT(message(std::string("{\"generators\":[\n{\"vertex\":1},\n") + object + "]}", GeneratorFormat::json),
               StartsWith("list:3: "));
  }
}

TEST_CASE("damaged bytes are refused, and never end the program") {
  const Mesh mesh = test::make_grid(3, 3);
  const std::vector<SurfacePoint> points{vertex_point(mesh, VertexId(3)),
                                         make_surface_point(FaceId(2), {0.1, 0.2, 0.7})};
  std::mt19937 random(2);
  for (const GeneratorFormat format : {GeneratorFormat::text, GeneratorFormat::csv, GeneratorFormat::json}) {
    const std::string whole = format_generators(mesh, points, format);
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
      std::string damaged = whole.substr(0, random() % 3 == 0 ? random() % whole.size() : whole.size());
      for (unsigned k = random() % 4; k > 0 && !damaged.empty(); --k) {
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      }
      try {
        resolve_generators(mesh, parse(damaged, format));
      } catch (const Error& error) {
        ++refused;
        REQUIRE((error.code() == ErrorCode::unreadable_input || error.code() == ErrorCode::precondition));
      }
    }
    CHECK(refused > 500);
  }
}

TEST_CASE("files that can't be read are refused") {
  CHECK_THAT(refusal([] { read_generators("/nonexistent/list.txt"); }, ErrorCode::unreadable_input),
             Catch::Matchers::Contains("No such file"));
  CHECK_THAT(refusal([] { read_generators("/tmp"); }, ErrorCode::unreadable_input),
             Catch::Matchers::Contains("is a directory"));
  CHECK(generator_format("a.JSON") == GeneratorFormat::json);
  CHECK(generator_format("a.csv") == GeneratorFormat::csv);
  CHECK(generator_format("a.dat") == GeneratorFormat::text);
}

TEST_CASE("a written list reads back bit by bit") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  std::mt19937 random(5);
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 100; ++i) points.push_back(random_point(mesh, random));
    points.push_back(vertex_point(mesh, VertexId(3)));
    for (const GeneratorFormat format : {GeneratorFormat::text, GeneratorFormat::csv, GeneratorFormat::json}) {
      const GeneratorList list = parse(format_generators(mesh, points, format), format);
      CHECK(resolve_generators(mesh, list).points == points);
    }
  }
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("vertices are those of the input file") {
  const Mesh mesh = test::make_grid(2, 2);
  const std::vector<VertexId> map{VertexId(), VertexId(4), VertexId(0)};
  ResolveOptions options;
  options.input_vertices = &map;
  const auto points = resolve_generators(mesh, parse("2\n1\n"), options).points;
  CHECK(vertex(mesh, points[0]) == VertexId(0));
  CHECK(vertex(mesh, points[1]) == VertexId(4));
  const auto message = [&](const std::string& text) {
    return refusal([&] { resolve_generators(mesh, parse(text), options); }, ErrorCode::precondition);
  };
  CHECK(message("1\n0\n") == "list:2: vertex 0 is in no face of the mesh; choose another");
  CHECK(message("3\n") == "list:1: there is no vertex 3; the mesh has 3, numbered from 0");
  CHECK(message("8 1 0 0\n") == "list:1: there is no face 8; the mesh has 8, numbered from 0");
  CHECK_THAT(message("1\n3 0.5 0.5 0.5\n"), Catch::Matchers::StartsWith("list:2: barycentric coordinates"));
  CHECK_THAT(message("3 1.5 -0.5 0\n"), Catch::Matchers::StartsWith("list:1: barycentric coordinates"));
}

TEST_CASE("positions are snapped, and the largest distance is kept") {
  const Mesh mesh = test::make_grid(4, 4);
  ResolveOptions options;
  const ResolvedGenerators result =
      resolve_generators(mesh, parse("p 1.25 1.5 0.5\np -1 -1 0\n0 0.2 0.3 0.5\n"), options);
  CHECK(result.snap_distance[0] == 0.5);
  CHECK(*result.snap_distance[1] == Approx(std::sqrt(2.0)));
  CHECK(!result.snap_distance[2]);
  CHECK((position(mesh, result.points[0]) - Vec3(1.25, 1.5, 0)).norm() < 1e-12);
  CHECK(result.points[1].kind() == SurfacePoint::Kind::vertex);
  options.max_snap = 0.5;
  CHECK(resolve_generators(mesh, parse("p 1.25 1.5 0.5\n"), options).snap_distance[0] == 0.5);
  CHECK_THAT(
      refusal([&] { resolve_generators(mesh, parse("p 1 1.5 0\np 1 1 1\n"), options); }, ErrorCode::precondition),
      Catch::Matchers::StartsWith("list:2: this position is 1 from the surface, more than the 0.5"));
  refusal([&] { resolve_generators(mesh, parse("p 1e300 1e300 0\n"), {}); }, ErrorCode::precondition);
}

TEST_CASE("generators in one place are refused, or merged") {
  const Mesh mesh = test::make_sphere(2);
  // Vertex 0 three ways: by number, as a corner of a face, and by position.
  const SurfacePoint corner = vertex_point(mesh, VertexId(0));
  const Vec3 p = position(mesh, corner);
  SurfacePoint other = corner;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (mesh.vertices(FaceId(f))[std::size_t(i)] == VertexId(0)) other = edge_point(Mesh::halfedge(FaceId(f), i), 0);
    }
  }
  REQUIRE(other.face != corner.face);
  const std::string text = "5\n0\n" + format_generators(mesh, {other}, GeneratorFormat::text);
  CHECK_THAT(refusal([&] { resolve_generators(mesh, parse(text)); }, ErrorCode::precondition),
             Catch::Matchers::StartsWith("list:4: generator 2 is in the same place as generator 1 (list:2)"));
  ResolveOptions merge;
  merge.merge_coincident = true;
  const ResolvedGenerators merged = resolve_generators(mesh, parse(text + "7\n"), merge);
  CHECK(merged.points.size() == 3);
  CHECK(merged.merged == 1);
  CHECK(merged.snap_distance.size() == 3);
  GeneratorList list = parse("0\n");
  list.entries.push_back({Kind::position, 0, {p.x(), p.y(), p.z()}, 0});
  CHECK_THROWS_AS(resolve_generators(mesh, list), Error);
}

TEST_CASE("points close across an edge coincide, points of two touching sheets do not") {
  const Mesh grid = test::make_grid(3, 3);
  const double tiny = 1e-13;
  // Face 0 is (0,0) (1,0) (1,1), face 1 is (0,0) (1,1) (0,1): they share the diagonal.
  const SurfacePoint below{FaceId(0), {0.5, tiny, 0.5 - tiny}}, above{FaceId(1), {0.5, 0.5 - tiny, tiny}};
  CHECK(find_coincident(grid, {below, above}) == std::vector<std::int32_t>{0, 0});
  const Mesh sheets({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(3), VertexId(5), VertexId(4)}});
  const SurfacePoint front = make_surface_point(FaceId(0), {0.2, 0.3, 0.5});
  const SurfacePoint back = make_surface_point(FaceId(1), {0.2, 0.5, 0.3});
  CHECK(find_coincident(sheets, {front, back}) == std::vector<std::int32_t>{0, 1});
}

TEST_CASE("far from the origin points coincide that rounding can't tell apart, and what does not coincide is taken") {
  const Mesh far({{1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const auto at = [](double shift) { return make_surface_point(FaceId(0), {0.5 - shift, 0.3 + shift, 0.2}); };
  CHECK(find_coincident(far, {at(0), at(7e-10)}) == std::vector<std::int32_t>{0, 0});
  CHECK(find_coincident(far, {at(0), at(5e-9)}) == std::vector<std::int32_t>{0, 1});
  CHECK_NOTHROW(compute_diagram(far, {at(0), at(5e-9)}));
}

TEST_CASE("the closest point is that of the best face") {
  std::mt19937 random(11);
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const ClosestPointTree tree(mesh);
    for (int i = 0; i < 60; ++i) {
      const Vec3 query(4 * uniform(random) - 2, 4 * uniform(random) - 2, 2 * uniform(random) - 1);
      ClosestPoint best = closest_point_on_face(mesh, FaceId(0), query);
      for (int f = 1; f < mesh.face_count(); ++f) {
        const ClosestPoint found = closest_point_on_face(mesh, FaceId(f), query);
        if (found.distance < best.distance) best = found;
      }
      const ClosestPoint found = tree.query(query);
      CHECK(found.distance == best.distance);
      CHECK(found.point.face == best.point.face);
      CHECK(found.distance == Approx((position(mesh, found.point) - query).norm()).margin(1e-9));
    }
    const SurfacePoint on = random_point(mesh, random);
    CHECK(tree.query(position(mesh, on)).distance < 1e-12);
  }
}

TEST_CASE("the closest point of a face without area lies on its edges") {
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const ClosestPoint found = closest_point_on_face(mesh, FaceId(0), {2, 1, 0});
  CHECK(found.distance == Approx(1));
  CHECK((position(mesh, found.point) - Vec3(2, 0, 0)).norm() < 1e-12);
}
