// gvd-distance without a file: what was asked for goes to standard output, in the user's own numbers. And the parts of
// the surface that --within and --mask leave.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "base/plane.hpp"
#include "gvd/io/format.hpp"
#include "support/catch.hpp"
#include "support/plane_with_holes.hpp"

namespace gvd::test_distance_results {

using namespace test;
using Catch::Matchers::Contains;
using nlohmann::json;

/// A strip of four squares along x, two triangles each. Vertex i is (i, 0) and 5 + i is (i, 1); the last vertex is in
/// no face. Faces 2 i and 2 i + 1 are those of square i.
std::string write_strip(const ScratchFolder& scratch) {
  std::string text = "OFF\n11 8 0\n";
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 5; ++x) text += fmt::format("{} {} 0\n", x, y);
  }
  text += "7 7 7\n";
  for (int x = 0; x < 4; ++x) text += fmt::format("3 {} {} {}\n3 {} {} {}\n", x, x + 1, x + 6, x, x + 6, x + 5);
  write_text(scratch / "strip.off", text);
  return scratch / "strip.off ";
}

/// Standard output of a run that succeeds.
std::string output_of(const std::string& arguments) {
  const CommandResult result = run_command("gvd-distance", arguments);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

/// The numbers of a text with twelve digits, which rounding does not reach.
std::string rounded(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string before;
    for (std::string word; words >> word; before = " ") result += before + fmt::format("{:.12g}", std::stod(word));
    result += '\n';
  }
  return result;
}

TEST_CASE("gvd-distance: without a file, one distance is a number on standard output, and nothing else is") {
  const ScratchFolder scratch;
  const std::string strip = write_strip(scratch);
  for (const char* quiet : {"", " -q", " -v"}) CHECK(rounded(output_of(strip + "--from 0 --to 4" + quiet)) == "4\n");
  CHECK(output_of(strip + "--from 0 --to 6") == fmt::format("{}\n", std::sqrt(2.0)));
  CHECK(output_of(strip + "--from 0 --to 0") == "0\n");
  CHECK(output_of(strip + "--from 0 --to 4 --max-distance 1") == "inf\n");
  CHECK(run_command("gvd-distance", strip + "-q --from 0 --to 4").err.empty());
  const CommandResult shell = run_command("gvd-distance", strip + "-q --from 0 --to 4 > " + scratch / "d");
  CHECK(rounded(read_text(scratch / "d")) == "4\n");
  // The same double comes back.
  const std::string exact = output_of(strip + "--from 0 --to 6 --output-format json");
  CHECK(json::parse(exact)["distances"][0][0] == std::stod(output_of(strip + "--from 0 --to 6")));
}

TEST_CASE("gvd-distance: without a file, several distances have a line each, behind the user's own vertex") {
  const ScratchFolder scratch;
  const std::string strip = write_strip(scratch);
  CHECK(rounded(output_of(strip + "--from 0 --to 4,2")) == "4 4\n2 2\n");
  const std::string all = rounded(output_of(strip + "--from 0"));
  CHECK_THAT(all, Contains("0 0\n1 1\n2 2\n3 3\n4 4\n5 1\n6 1.41421356237\n"));
  CHECK(all.ends_with("\n10 inf\n"));
  CHECK(rounded(output_of(strip + "--from 4,0 --each --to 1,3")) == "1 3 1\n3 1 3\n");
  write_text(scratch / "to.txt", "p 2 0.5 0\n4\n");
  CHECK(rounded(output_of(strip + "--from 0 --to " + scratch / "to.txt")) == "-1 2.06155281281\n4 4\n");
}

TEST_CASE("gvd-distance: vertices keep the user's numbers where the mesh was repaired") {
  const ScratchFolder scratch;
  // Two triangles that share only a vertex, which is cut apart, behind a vertex in no face.
  write_text(scratch / "a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 2 3 4\nf 2 5 6\n");
  const std::string given = scratch / "a.obj" + " --from 2 --to 1,3,5";
  CHECK(output_of(given) == fmt::format("1 1\n3 {}\n5 inf\n", std::sqrt(2.0)));
  CHECK_THAT(output_of(given + " --output-format csv"), Contains("0,0,1,2,1\n") && Contains("-1,2,inf,-1,5\n"));
  const json document = json::parse(output_of(given + " --paths --output-format json"));
  CHECK(document["source_vertices"] == json({2}));
  CHECK(document["target_vertices"] == json({1, 3, 5}));
  CHECK(document["paths"][1]["source_vertex"] == 2);
  CHECK(document["paths"][1]["target_vertex"] == 3);
  CHECK(document["paths"][2]["source_vertex"].is_null());
  const CommandResult files = run_command("gvd-distance", given + " -o " + scratch / "a.npy");
  CHECK(files.out.empty());
  CHECK_THAT(files.err, Contains("vertex 1 is 1 from vertex 2") && Contains("vertex 5 is not reached from any source"));
}

TEST_CASE("gvd-distance: errors name the user's own vertices") {
  const ScratchFolder scratch;
  // Vertices 0 and 3 are in no face, 2 and 4 are at one place.
  write_text(scratch / "a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 2 3 6\nf 5 7 6\n");
  write_text(scratch / "list.txt", "p 0 1 0\n5\n");
  write_text(scratch / "mask.csv", "face,label\n0,-1\n1,0\n");
  const auto refused = [&](const std::string& options, const std::string& part) {
    const CommandResult result = run_command("gvd-distance", scratch / "a.obj" + " --weld " + options);
    CAPTURE(options, result.err);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Contains("gvd-distance: error: ") && Contains(part));
  };
  refused("--from 0", "--from: vertex 0 is in no face of the mesh");
  refused("--from 1 --to 1,3", "--to: vertex 3 is in no face of the mesh");
  refused("--from 7", "--from: there is no vertex 7; the mesh has 7, numbered from 0");
  refused("--from 1 --to 9", "--to: there is no vertex 9;");
  refused("--from 4,5,2", "--from: vertex 2 is in the same place as vertex 4; remove one");
  refused("--from " + scratch / "list.txt", "list.txt:2: vertex 5 is in the same place as point 0 (");
  refused("--from 6,1 --within " + scratch / "mask.csv",
          "--from: vertex 1 lies in faces that --within or --mask leaves out");
}

TEST_CASE("gvd-distance: a point that is not reached has its reason, from each source and with paths") {
  const ScratchFolder scratch;
  // Two sheets that meet a third one, cut apart there; one that met the first one at vertex 2; and one on its own.
  // Vertex 10 is in no face.
  write_text(scratch / "a.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 2 1\nv 0 2 2\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 9 9\n"
             "f 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 6 7\nf 8 9 10\n");
  const std::string mesh = scratch / "a.obj ";
  const auto told = [&](const std::string& options) { return run_command("gvd-distance", mesh + options).err; };
  const std::string edge = "beyond a non-manifold edge, where sheets were cut apart",
                    vertex = "beyond a non-manifold vertex, where sheets were cut apart",
                    other = "in another component";
  for (const char* more : {"", " --each", " --paths", " --each --paths"}) {
    CAPTURE(more);
    const std::string err = told("--from 2 --to 3,4,5,7 -o " + scratch / "a.json" + more);
    const std::string from = std::string(more).find("each") == std::string::npos ? "any source" : "vertex 2";
    CHECK_THAT(err, Contains("vertex 4 is not reached from " + from + ": it is " + edge + "\n"));
    CHECK_THAT(err, Contains("vertex 5 is not reached from " + from + ": it is " + vertex + "\n"));
    CHECK_THAT(err, Contains("vertex 7 is not reached from " + from + ": it is " + other + "\n"));
    CHECK_THAT(err, !Contains("are inf"));  // all are told
  }
  CHECK_THAT(told("--from 2 --to 4"), Contains("1 of 1 distance is inf: " + edge + "\n"));
  CHECK_THAT(told("--from 2 --to 4 --each --paths"), Contains("1 of 1 distance is inf: " + edge + "\n"));
  CHECK_THAT(told("--from 2,7 --each --to 8 -o " + scratch / "a.csv"),
             Contains("vertex 8 is not reached from vertex 2: it is " + other + "\n") &&
                 Contains("vertex 8 is 1 from vertex 7\n"));
  CHECK_THAT(told("--from 2"), Contains("7 of 11 distances to vertices are inf: 1 in no face; 1 " + edge + "; 2 " +
                                        vertex + "; 3 " + other + "\n"));
  CHECK_THAT(told("--from 2,7 --each"), Contains("15 of 22 distances to vertices are inf: 2 in no face; 1 " + edge +
                                                 "; 2 " + vertex + "; 10 " + other + "\n"));
  CHECK_THAT(told("--from 2 --to 1 --max-distance .1 -o " + scratch / "a.csv"),
             Contains("vertex 1 is not reached from any source: it is beyond --max-distance\n"));
  write_text(scratch / "regions.csv", "face,label\n0,0\n1,1\n2,1\n3,1\n4,-1\n");
  const std::string within = " --within " + scratch / "regions.csv" + " -o " + scratch / "b.csv";
  CHECK_THAT(
      told("--from 2 --to 3,7" + within),
      Contains(
          "vertex 3 is not reached from any source: it is in another region, or in another part of its region\n") &&
          Contains("vertex 7 is not reached from any source: it is left out by --within or --mask\n"));
}

TEST_CASE("gvd-distance: without a file, paths are a table and isolines JSON, and --output-format chooses") {
  const ScratchFolder scratch;
  const std::string strip = write_strip(scratch);
  const std::string paths = output_of(strip + "--from 0 --to 2,4 --paths");
  CHECK(paths.starts_with("path,source,target,length,face,b0,b1,b2,x,y,z,source_vertex,target_vertex\n0,0,0,"));
  CHECK(paths.ends_with(",0,4\n"));
  const json lines = json::parse(output_of(strip + "--from 0 --isolines 1.5"));
  CHECK(lines["isolines"].size() == 2);
  CHECK(json::parse(output_of(strip + "--from 0 --to 4 --output-format json"))["distances"][0][0] == Approx(4));
  CHECK(output_of(strip + "--from 0 --to 4 -o - --output-format txt") == output_of(strip + "--from 0 --to 4"));
  CHECK(output_of(strip + "--from 0 -q --report " + scratch / "r.json").empty());
  require_error("gvd-distance", strip + "--from 0 --to 4 --paths --output-format txt", 2,
                "--paths: only .obj, .vtp, .vtu, .glb, .json, .csv, --view and --report hold paths; write one of them");
  require_error("gvd-distance", strip + "--from 0 --isolines 1 --output-format txt", 2,
                "--isolines: only .obj, .vtp, .vtu, .glb, .json, --view and --report hold curves; write one of them");
}

TEST_CASE("gvd-distance: a mesh that would hold nothing of what was asked for is refused, with what to do") {
  const ScratchFolder scratch;
  const std::string strip = write_strip(scratch);
  require_error(
      "gvd-distance", strip + "--from 0 --to 4 -o " + scratch / "p.obj", 2,
      "p.obj: .obj holds no distances; add --paths for the shortest paths, or write .json, .npy, .csv or .txt");
  require_error("gvd-distance", strip + "--from 0 -o " + scratch / "p.obj", 2, "or add --isolines");
  require_error("gvd-distance", strip + "--from 0 -o " + scratch / "p.glb", 2, ".glb holds no distances; write .ply");
  require_error("gvd-distance", strip + "--from 0 --to 4 -o " + scratch / "p.vtp", 2,
                "for which --to does nothing; add");
  require_error(
      "gvd-distance", strip + "--from 0 --to 4 -o " + scratch / "p.ply", 2,
      "p.ply: .ply has the distances of all vertices, for which --to does nothing; write .json, .npy, .csv or .txt");
  output_of(strip + "--from 0 --to 4 --paths -o " + scratch / "p.obj");
  output_of(strip + "--from 0 --to 4 -o " + scratch / "p.ply" + " -o " + scratch / "p.csv");
}

TEST_CASE("gvd-distance: a format holds what its row in the table says, and is refused for the rest") {
  const ScratchFolder scratch;
  const std::string strip = write_strip(scratch);
  struct Change {
    Content content;
    std::string one, other;
  };
  const std::array<Change, 5> changes{{
      {Content::distances | Content::rows, "--from 0", "--from 3"},
      {Content::rows, "--from 0,4 --each", "--from 0,3 --each"},
      {Content::targets, "--from 0 --to 4", "--from 0 --to 3"},
      {Content::curves | Content::paths, "--from 0 --to 4 --paths", "--from 0 --to 3 --paths"},
      {Content::curves | Content::isolines, "--from 0 --isolines 1.5", "--from 0 --isolines 0.5"},
  }};
  for (const Format& format : formats()) {
    const bool is_offered =
        std::ranges::any_of(changes, [&](const Change& c) { return has_any(format.carries, c.content); });
    if (!format.is_output() || !is_offered) continue;
    for (const Change& change : changes) {
      const std::string path = scratch / ("a." + format.extensions.front()), output = " -q -o " + path;
      INFO(change.one + output);
      if (!has_any(format.carries, change.content)) {
        CHECK(run_command("gvd-distance", strip + change.one + output).exit_code == 2);
        continue;
      }
      output_of(strip + change.one + output);
      const std::string before = read_text(path);
      output_of(strip + change.other + output);
      CHECK(read_text(path) != before);
    }
  }
}

TEST_CASE("gvd-distance: -h names what is asked for") {
  const std::string help = output_of("-h");
  for (const char* option : {"--from", "--to", "--paths", "--isolines", "--output"}) CHECK_THAT(help, Contains(option));
  const std::string remesh = run_command("gvd-remesh", "-h").out;
  for (const char* option : {"--target-edge", "--error"}) CHECK_THAT(remesh, Contains(option));
}

TEST_CASE("gvd-distance --mask: distances go round the faces that are left out, and these are not reached") {
  const ScratchFolder scratch;
  // The middle of a 3 x 3 grid of squares is left out.
  std::string text = "OFF\n16 18 0\n", mask;
  for (int i = 0; i < 16; ++i) text += fmt::format("{} {} 0\n", i % 4, i / 4);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      const int a = 4 * y + x;
      text += fmt::format("3 {} {} {}\n3 {} {} {}\n", a, a + 1, a + 5, a, a + 5, a + 4);
      mask += x == 1 && y == 1 ? "1\n1\n" : "0\n0\n";
    }
  }
  write_text(scratch / "grid.off", text);
  write_text(scratch / "mask.txt", mask);
  const std::string given = scratch / "grid.off" + " --mask " + scratch / "mask.txt" + " --from 0 --to ";
  CHECK(std::stod(output_of(given + "15")) == Approx(2 * std::sqrt(5.0)).epsilon(1e-13));  // past a corner of the hole
  CHECK(std::stod(output_of(scratch / "grid.off" + " --from 0 --to 15")) == Approx(3 * std::sqrt(2.0)).epsilon(1e-13));
  CHECK(output_of(given + "5 -q") == fmt::format("{}\n", std::sqrt(2.0)));  // a corner of the hole
  write_text(scratch / "hole.txt", "p 1.5 1.4 0\n");
  CHECK(output_of(given + scratch / "hole.txt") == "inf\n");
  require_error("gvd-distance",
                scratch / "grid.off" + " -q --mask " + scratch / "mask.txt" + " --from " + scratch / "hole.txt", 4,
                "--from: source 0 lies in faces that --within or --mask leaves out");
  const std::string paths = output_of(given + "15 --paths");
  CHECK_THAT(paths, Contains("15\n"));
  require_error("gvd-distance", scratch / "grid.off" + " --curves boundary --mask " + scratch / "mask.txt", 2,
                "--curves");
}

/// The largest difference of the middle of a straight piece of the isolines from its level.
double worst_piece(const json& lines, const std::function<double(const Vec2&)>& distance) {
  double worst = 0;
  for (const json& line : lines) {
    const json& points = line["points"];
    const auto at = [&](std::size_t i) { return Vec2(points[i]["position"][0], points[i]["position"][1]); };
    for (std::size_t i = line["closed"] == true ? 0 : 1; i < points.size(); ++i) {
      const Vec2 middle = 0.5 * (at(i) + at((i + points.size() - 1) % points.size()));
      worst = std::max(worst, std::abs(distance(middle) - line["level"].get<double>()));
    }
  }
  return worst;
}

TEST_CASE("gvd-distance: isolines with --mask go round what is left out, and with --within end at the border") {
  const ScratchFolder scratch;
  std::string text = "OFF\n16 18 0\n", mask, parts;
  for (int i = 0; i < 16; ++i) text += fmt::format("{} {} 0\n", i % 4, i / 4);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      const int a = 4 * y + x;
      text += fmt::format("3 {} {} {}\n3 {} {} {}\n", a, a + 1, a + 5, a, a + 5, a + 4);
      mask += x == 1 && y == 1 ? "1\n1\n" : "0\n0\n";
      parts += x < 2 ? "0\n0\n" : "1\n1\n";
    }
  }
  write_text(scratch / "grid.off", text);
  write_text(scratch / "mask.txt", mask);
  write_text(scratch / "parts.txt", parts);
  const std::string grid = scratch / "grid.off" + " -q ";
  write_text(scratch / "from.txt", "p 0.3 1.4 0\np 2.9 0.2 0\n");
  const json round = json::parse(output_of(grid + "--mask " + scratch / "mask.txt" + " --from " + scratch / "from.txt" +
                                           " --isolines 0.3"))["isolines"];
  const PlaneWithHoles plane({Box2(Vec2(1, 1), Vec2(2, 2))}, {{0.3, 1.4}, {2.9, 0.2}});
  const double mean_edge = (24 + 9 * std::sqrt(2.0)) / 33;
  CHECK(round.size() >= 12);
  CHECK(worst_piece(round, [&](const Vec2& p) { return plane.distance(p); }) < 1.001e-4 * mean_edge);
  // The first source reaches the part on the left alone, the second one that on the right.
  const json parted = json::parse(output_of(grid + "--within " + scratch / "parts.txt" + " --from " +
                                            scratch / "from.txt" + " --isolines 0.3"))["isolines"];
  CHECK(worst_piece(parted, [](const Vec2& p) {
          return p.x() < 2 ? (p - Vec2(0.3, 1.4)).norm() : (p - Vec2(2.9, 0.2)).norm();
        }) < 1.001e-4 * mean_edge);
  for (const json& line : parted) {
    const auto is_left = [](const json& p) { return p["position"][0].get<double>() <= 2; };
    CHECK((std::ranges::all_of(line["points"], is_left) ||
           std::ranges::none_of(line["points"], [&](const json& p) { return p["position"][0].get<double>() < 2; })));
  }
}

TEST_CASE("gvd-distance --within: a source reaches its own region, and on a border all regions there") {
  const ScratchFolder scratch;
  const std::string strip = write_strip(scratch);
  write_text(scratch / "two.txt", "0\n0\n0\n0\n1\n1\n1\n1\n");  // the border is x = 2
  const std::string given = strip + "--within " + scratch / "two.txt" + " -q ";
  CHECK(rounded(output_of(given + "--from 0 --to 1,2,3,4")) == "1 1\n2 2\n3 inf\n4 inf\n");
  CHECK_THAT(rounded(output_of(given + "--from 0")), Contains("\n2 2\n3 inf\n"));
  CHECK(rounded(output_of(given + "--from 2 --to 0,2,4")) == "0 2\n2 0\n4 2\n");
  CHECK(rounded(output_of(given + "--from 4,2,0 --each --to 3,1")) == "3 1 1 inf\n1 inf 1 1\n");
  CHECK(rounded(output_of(given + "--from 4,0 --each --to 2")) == "2 2 2\n");
  CHECK_THAT(output_of(given + "--from 2,0 --to 3 --paths"), Contains("0,0,0,1,") && Contains(",2,3\n"));
  CHECK(rounded(output_of(given + "--from 2 --each")) == rounded(output_of(given + "--from 2")));
  const json lines = json::parse(output_of(given + "--from 0 --isolines 1.9"))["isolines"];
  CHECK(lines.size() == 1);  // none beyond the border
}

TEST_CASE(
    "commands: --within and --mask: a number that is none is refused with its vertex, in the commands that take them") {
  const ScratchFolder scratch;
  const auto write_ply = [&](const std::string& value) {
    write_text(scratch / "a.ply",
               "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
               "property float part\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
               "7 7 7 0\n0 0 0 1\n1 0 0 1\n1 1 0 " +
                   value + "\n0 1 0 1\n3 1 2 3\n3 1 3 4\n");
  };
  const auto refused = [&](const std::string& option, const std::string& part) {
    const std::string mesh = scratch / "a.ply" + option;
    require_error("gvd-segment", mesh + " -q -n 2 -o " + scratch / "b.ply", 4, part);
    require_error("gvd-distance", mesh + " -q --from 2", 4, part);
  };
  // The other corners outvote the one that is wrong.
  for (const char* value : {"inf", "-inf", "nan"}) {
    write_ply(value);
    refused(" --within part", fmt::format("--within part: the region of vertex 3 is {}; give whole numbers", value));
    refused(" --mask part", fmt::format("--mask part: the number of vertex 3 is {}; give finite numbers", value));
  }
  write_ply("1.5");
  refused(" --within part", "--within part: the region of vertex 3 is 1.5; give whole numbers of 32 bits");
}

}  // namespace gvd::test_distance_results
