// gvd-segment --disc and --uv: cells that are discs, and texture coordinates of the pieces.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "base/plane.hpp"
#include "gvd/mesh.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_segment_charts {

using namespace test;
using Catch::Matchers::Contains;

std::string run(const std::string& arguments) {
  const CommandResult result = run_command("gvd-segment", arguments);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return result.err;
}

nlohmann::json read_json(const std::string& path) { return nlohmann::json::parse(read_text(path)); }

struct ObjFace {
  std::array<std::array<double, 2>, 3> texture{};
  double twice_area() const {
    const auto& [a, b, c] = texture;
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
};

/// The faces of an OBJ by their texture coordinates; all must have some.
std::vector<ObjFace> read_faces(const std::string& path) {
  std::istringstream in(read_text(path));
  std::vector<std::array<double, 2>> texture;
  std::vector<ObjFace> faces;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string kind;
    fields >> kind;
    if (kind == "vt") {
      fields >> texture.emplace_back()[0] >> texture.back()[1];
    } else if (kind == "f") {
      ObjFace& face = faces.emplace_back();
      for (auto& corner : face.texture) {
        std::string field;
        fields >> field;
        REQUIRE(field.find('/') != std::string::npos);
        corner = texture.at(std::stoul(field.substr(field.find('/') + 1)) - 1);
      }
    }
  }
  return faces;
}

TEST_CASE(
    "gvd-segment --disc: every cell is a disc, the given generators come first, and the report counts the added ones") {
  const ScratchFolder scratch;
  const std::string figure = data_file("figure.obj") + " -n 6";
  run(figure + " -q --report " + scratch / "without.json");
  const std::string notes =
      run(figure + " --disc --cut -o " + scratch / "a.ply" + " --report " + scratch / "with.json" + " --diagram " +
          scratch / "d.json --stats " + scratch / "s.csv");
  const auto without = read_json(scratch / "without.json"), with = read_json(scratch / "with.json");
  const int added = with["results"]["disc"]["added"];
  REQUIRE(without["diagram"]["disc_cells"] < 6);
  CHECK(added >= 1);
  CHECK(with["diagram"]["cells"] == 6 + added);
  CHECK(with["diagram"]["disc_cells"] == 6 + added);
  CHECK(with["results"]["regions"].size() == std::size_t(6 + added));
  CHECK(read_json(scratch / "d.json")["generators"].size() == std::size_t(6 + added));
  for (std::size_t i = 0; i < 6; ++i) CHECK(with["generators"][i] == without["generators"][i]);
  CHECK_THAT(notes, Contains("so that every cell is a disc"));
  // A run that needs none says so, too.
  run(data_file("figure.obj") + " -q -n 300 --disc --report " + scratch / "none.json");
  CHECK(read_json(scratch / "none.json")["results"]["disc"]["added"] == 0);
}

TEST_CASE("gvd-segment --uv flat: each face is counter-clockwise in the square, and the report says so") {
  const ScratchFolder scratch;
  run(data_file("figure.obj") + " -n 12 --disc --uv flat -q -o " + scratch / "a.obj" + " -o " + scratch / "a.ply" +
      " --report " + scratch / "r.json");
  const auto report = read_json(scratch / "r.json");
  CHECK(report["options"]["cut"] == true);
  CHECK(report["options"]["uv"] == "flat");
  const auto& charts = report["results"]["charts"];
  CHECK(charts["flipped_share"] == 0);
  CHECK(charts["charts"].size() == report["results"]["regions"].size());
  const auto faces = read_faces(scratch / "a.obj");
  CHECK(faces.size() == report["results"]["faces"]);
  double area = 0;
  for (const ObjFace& face : faces) {
    REQUIRE(face.twice_area() > 0);
    for (const auto& [u, v] : face.texture) REQUIRE(std::min({u, v, 1 - u, 1 - v}) > 0);
    area += 0.5 * face.twice_area();
  }
  CHECK(area == Approx(charts["covered_share"].get<double>()).epsilon(1e-6));
  CHECK_THAT(read_text(scratch / "a.ply"), Contains("texcoord") || Contains("property double s"));
}

/// How many faces of a file are not counter-clockwise in the texture, for certain.
std::int64_t count_flipped(const std::string& file) {
  const std::vector<Uv> texture = read_soup(file).appearance.texture;
  REQUIRE(!texture.empty());
  const auto at = [&](std::size_t i) { return Vec2(texture[i][0], texture[i][1]); };
  std::int64_t flipped = 0;
  for (std::size_t i = 0; i < texture.size(); i += 3) flipped += orientation(at(i), at(i + 1), at(i + 2)) <= 0;
  return flipped;
}

TEST_CASE("gvd-segment --uv flat: PLY and OBJ flip no face, and -v counts those that the floats of GLB flip") {
  const ScratchFolder scratch;
  const std::string notes = run(data_file("figure.obj") + " -v -n 12 --disc --uv flat -o " + scratch / "a.obj" +
                                " -o " + scratch / "a.ply" + " -o " + scratch / "a.glb --report " + scratch / "r.json");
  CHECK(count_flipped(scratch / "a.obj") == 0);
  CHECK(count_flipped(scratch / "a.ply") == 0);
  const std::int64_t flipped = count_flipped(scratch / "a.glb");
  CHECK(flipped > 0);
  CHECK(read_json(scratch / "r.json")["results"]["charts"]["flipped_by_floats"] == flipped);
  CHECK_THAT(notes,
             Contains(std::to_string(flipped) + " faces are flipped in .glb, which rounds texture coordinates to " +
                      "32-bit floats; .ply and .obj keep doubles, and flip none"));
}

TEST_CASE("gvd-segment --uv logmap: the report has the generators' places, and distances in the texture are exact") {
  const ScratchFolder scratch;
  run(data_file("figure.obj") + " -n 40 --uv logmap -q -o " + scratch / "a.obj" + " --report " + scratch / "r.json");
  const auto charts = read_json(scratch / "r.json")["results"]["charts"];
  CHECK(charts["unplaced_share"] == 0);
  CHECK(charts["flipped_share"] < 0.01);
  CHECK(charts["torn_share"] < 0.03);
  for (const auto& chart : charts["charts"]) {
    CHECK(chart["origin"][0].get<double>() > 0);
    CHECK(chart["origin"][1].get<double>() < 1);
  }
  CHECK(read_faces(scratch / "a.obj").size() > 5876);
}

TEST_CASE("gvd-segment --uv: the same bytes on any number of threads, and inside regions") {
  const ScratchFolder scratch;
  run(data_file("figure.obj") + " -q -n 5 -o " + scratch / "coarse.ply");
  for (const std::string map : {"flat", "logmap"}) {
    for (const std::string threads : {"1", "3"}) {
      run(scratch / "coarse.ply" + " --within label -n 20 --disc -q --uv " + map + " --threads " + threads + " -o " +
          scratch / threads + ".ply -o " + scratch / "any.obj" + " --report " + scratch / threads + ".json");
    }
    const bool is_same = read_text(scratch / "1.ply") == read_text(scratch / "3.ply");
    CHECK(is_same);
    CHECK(read_json(scratch / "1.json")["results"]["charts"]["unplaced_share"] == 0);
    CHECK(read_faces(scratch / "any.obj").size() == read_json(scratch / "3.json")["results"]["faces"]);
  }
}

TEST_CASE("gvd-segment --uv: --stats has the charts' columns, and a line says that the input's texture is replaced") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  const std::string notes = run(scratch / "in.obj" + " -n 1 --uv logmap -o " + scratch / "a.obj --stats " +
                                scratch / "s.csv --report " + scratch / "r.json");
  CHECK_THAT(notes, Contains("in.obj: left out: texture coordinates of the input (replaced by --uv)\n"));
  std::istringstream rows(read_text(scratch / "s.csv"));
  std::string header, row;
  std::getline(rows, header);
  std::getline(rows, row);
  CHECK_THAT(header, Contains(",neighbours,flipped_share,stretch,u_min,v_min,u_max,v_max"));
  const auto chart = read_json(scratch / "r.json")["results"]["charts"]["charts"][0];
  CHECK(chart["stretch"].get<double>() == Approx(1));
  std::string box;
  for (const auto& number : chart["box"]) box += "," + number.dump();
  CHECK_THAT(row, Contains(box));
}

TEST_CASE("gvd-segment --uv: the regions have their own materials, as the input's images do not fit the charts") {
  const ScratchFolder scratch;
  write_text(scratch / "paint.mtl", "newmtl skin\n");
  write_text(scratch / "in.obj",
             "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl skin\nf 1/1 2/2 3/3\n");
  const std::string given = scratch / "in.obj" + " --vertices 0,1 --uv flat -o ";
  const std::string notes = run(given + scratch / "a.obj");
  CHECK_THAT(notes, Contains("in.obj: left out: texture coordinates of the input (replaced by --uv); materials of the "
                             "input, whose images do not fit those of --uv\n"));
  const std::string written = read_text(scratch / "a.obj");
  CHECK_THAT(written, Contains("mtllib a.mtl\n") && Contains("\nusemtl region_0\n") && Contains("\nusemtl region_1\n"));
  CHECK_THAT(written, !Contains("paint.mtl") && !Contains("skin"));
  CHECK_THAT(read_text(scratch / "a.mtl"), Contains("newmtl region_1\n"));
  // Their file does not replace that of the input.
  require_error("gvd-segment", given + scratch / "paint.obj", 2, "its materials would replace paint.mtl");
  CHECK(read_text(scratch / "paint.mtl") == "newmtl skin\n");
}

/// A closed ring of eight cubes, as the squares of their surface, each of two triangles.
std::string cube_ring() {
  const auto is_solid = [](int x, int y, int z) {
    return z == 0 && x >= 0 && y >= 0 && x < 3 && y < 3 && (x != 1 || y != 1);
  };
  std::map<std::array<int, 3>, int> number;
  std::string vertices, faces;
  int squares = 0;
  for (int square = 0; square < 9 * 6; ++square) {
    const std::array<int, 3> cube{square / 18, square / 6 % 3, 0};
    const int axis = square % 6 / 2, side = square % 2;
    std::array<int, 3> beside = cube;
    beside[std::size_t(axis)] += 2 * side - 1;
    if (!is_solid(cube[0], cube[1], 0) || is_solid(beside[0], beside[1], beside[2])) continue;
    std::array<int, 4> corners{};
    for (int k = 0; k < 4; ++k) {
      std::array<int, 3> at = cube;
      at[std::size_t(axis)] += side;
      at[std::size_t((axis + 1) % 3)] += k == 1 || k == 2 ? 1 : 0;
      at[std::size_t((axis + 2) % 3)] += k >= 2 ? 1 : 0;
      const auto [entry, is_new] = number.try_emplace(at, int(number.size()));
      if (is_new) vertices += fmt::format("{} {} {}\n", at[0], at[1], at[2]);
      corners[std::size_t(k)] = entry->second;
    }
    if (side == 0) std::swap(corners[1], corners[3]);
    faces += fmt::format("3 {0} {1} {2}\n3 {0} {2} {3}\n", corners[0], corners[1], corners[2], corners[3]);
    ++squares;
  }
  return fmt::format("OFF\n{} {} 0\n", number.size(), 2 * squares) + vertices + faces;
}

/// The Euler characteristic of the faces with a label, with the vertices that they share.
int euler_of_piece(const nlohmann::json& cut, int label) {
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  int faces = 0;
  for (std::size_t f = 0; f < cut["faces"].size(); ++f) {
    if (cut["labels"][f] != label) continue;
    ++faces;
    const auto corners = cut["faces"][f].get<std::array<int, 3>>();
    for (std::size_t i = 0; i < 3; ++i) {
      vertices.insert(corners[i]);
      edges.insert(std::minmax(corners[i], corners[(i + 1) % 3]));
    }
  }
  return int(vertices.size()) - int(edges.size()) + faces;
}

TEST_CASE("gvd-segment --disc --cut: each piece is a disc as a mesh, also where cells nearly touch themselves") {
  const ScratchFolder scratch;
  write_text(scratch / "ring.off", cube_ring());
  for (const std::string vertices : {"1,24,31", "3,8,13,27,30", "8,13,17,21,27"}) {
    CAPTURE(vertices);
    const std::string notes = run(scratch / "ring.off" + " --vertices " + vertices + " --disc --cut -o " +
                                  scratch / "a.json" + " -o " + scratch / "a.off");
    CHECK_THAT(notes, !Contains("not a disc") && !Contains("not discs"));
    const nlohmann::json written = read_json(scratch / "a.json");
    for (const auto& cell : written["cells"]) {
      CHECK(cell["euler_characteristic"] == 1);
      CHECK(euler_of_piece(written["cut_mesh"], cell["generator"]) == 1);
    }
    const PolygonSoup soup = read_soup(scratch / "a.off");
    const MeshSummary whole = compute_mesh_summary(build_mesh(soup, DefectPolicy::error, "a.off").mesh);
    CHECK(whole.euler_characteristic == 0);
    CHECK(whole.boundary_loops == 0);
  }
}

TEST_CASE("gvd-segment --disc: a note names regions of whole faces that touch themselves at a vertex") {
  const ScratchFolder scratch;
  write_text(scratch / "ring.off", cube_ring());
  const std::string notes = run(scratch / "ring.off" + " --vertices 5,10,23 --disc -o " + scratch / "a.json");
  CHECK_THAT(notes, Contains("1 region is not a disc, although its cell is: 0; whole faces join or touch there; --cut "
                             "follows the cells\n"));
  nlohmann::json whole = {{"labels", read_json(scratch / "a.json")["face_labels"]}};
  const PolygonSoup soup = read_soup(scratch / "ring.off");
  for (std::size_t f = 0; f < soup.polygon_count(); ++f) {
    whole["faces"].push_back({soup.polygon(f)[0], soup.polygon(f)[1], soup.polygon(f)[2]});
  }
  const int regions = int(read_json(scratch / "a.json")["cells"].size());
  for (int label = 0; label < regions; ++label) CHECK((euler_of_piece(whole, label) == 1) == (label != 0));
}

TEST_CASE("gvd-segment --disc and --uv: refusals name what helps") {
  const std::string name = "gvd-segment", figure = data_file("figure.obj") + " -n 6 ";
  require_error(name, figure + "-q --uv flat", 5, "--disc adds generators until every region is a disc");
  require_error(name, figure + "--uv flat --labels smooth", 2, "--uv");
  require_error(name, figure + "--uv round", 2, "logmap|flat");
  require_error(
      name, figure + "--uv logmap -o a.off -o a.json", 2,
      "--uv: only .ply, .obj and .glb hold texture coordinates; write one, such as -o FILE.obj, or leave it out");
  require_error(name, figure + "--disc --balance area", 2, "--disc");
  require_error(name, figure + "--disc --weights none.txt", 2, "--disc");
}

}  // namespace gvd::test_segment_charts
