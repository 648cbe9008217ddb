// gvd-distance on files: distances beside known ones, paths, isolines, the formats, and what it refuses.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/read_values.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_distance_command {

using namespace test;
using Catch::Matchers::Contains;
using nlohmann::json;

/// A square of n x n squares on the plane, each two triangles.
std::string write_plane(const ScratchFolder& scratch, int n) {
  std::string text = fmt::format("OFF\n{} {} 0\n", (n + 1) * (n + 1), 2 * n * n);
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) text += fmt::format("{} {} 0\n", x, y);
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x;
      text += fmt::format("3 {} {} {}\n3 {} {} {}\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  write_text(scratch / "plane.off", text);
  return scratch / "plane.off";
}

/// The unit cube: vertex 4 z + 2 y + x.
std::string write_cube(const ScratchFolder& scratch) {
  std::string text = "OFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i) text += fmt::format("{} {} {}\n", i & 1, i >> 1 & 1, i >> 2);
  text += "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
  write_text(scratch / "cube.off", text);
  return scratch / "cube.off";
}

struct Outcome {
  json output, report;
  std::string err;
};

/// Runs the command for JSON and report.
Outcome measure(const ScratchFolder& scratch, const std::string& arguments) {
  const std::string out = scratch / "out.json", report = scratch / "report.json";
  const CommandResult result = run_command("gvd-distance", arguments + " -o " + out + " --report " + report);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return {json::parse(read_text(out)), json::parse(read_text(report)), result.err};
}

/// The numbers of an NPY of doubles, and its header.
std::pair<std::vector<double>, std::string> read_npy(const std::string& path) {
  const std::string bytes = read_text(path);
  REQUIRE(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  CHECK((10 + length) % 64 == 0);
  std::vector<double> values((bytes.size() - 10 - length) / 8);
  std::memcpy(values.data(), bytes.data() + 10 + length, 8 * values.size());
  return {values, bytes.substr(10, length)};
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) fields.push_back(field);
  return fields;
}

std::vector<std::vector<std::string>> read_csv(const std::string& path) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : split(read_text(path), '\n')) rows.push_back(split(line, ','));
  return rows;
}

Mesh read_mesh(const std::string& path) { return build_mesh(read_soup(path)).mesh; }

SurfacePoint to_point(const json& point) {
  return {FaceId(point["face"].get<int>()), point["bary"].get<std::array<double, 3>>()};
}

double length_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += (position(mesh, points[i]) - position(mesh, points[i - 1])).norm();
  return length;
}

TEST_CASE("gvd-distance: GIFTI and FreeSurfer's files hold the distances of the vertices as floats") {
  const ScratchFolder scratch;
  const std::string line = write_plane(scratch, 6) + " -q --from 3,40 ";
  REQUIRE(run_command("gvd-distance", line + "-o " + scratch / "a.npy" + " -o " + scratch / "a.shape.gii" + " -o " +
                                          scratch / "lh.curv")
              .exit_code == 0);
  std::vector<double> wanted = read_values(scratch / "a.npy");
  for (double& d : wanted) d = static_cast<float>(d);
  CHECK(read_values(scratch / "a.shape.gii") == wanted);
  CHECK(read_values(scratch / "lh.curv") == wanted);
  REQUIRE(run_command("gvd-distance", line + "--each -o " + scratch / "each.shape.gii").exit_code == 0);
  CHECK_THAT(read_text(scratch / "each.shape.gii"), Contains("NumberOfDataArrays=\"2\""));
  require_error("gvd-distance", line + "--each -o " + scratch / "b.curv", 2,
                ".curv hold one distance for each vertex; write .shape.gii, .json, .npy, .csv or .txt");
  require_error("gvd-distance", line + "--to 5 -o " + scratch / "b.shape.gii", 2, "--to: .shape.gii and .curv hold a");
}

TEST_CASE("gvd-distance: on a plane, distances from the nearest of two sources are straight, in every format") {
  const ScratchFolder scratch;
  const std::string mesh = write_plane(scratch, 6), npy = scratch / "d.npy", csv = scratch / "d.csv",
                    ply = scratch / "d.ply";
  write_text(scratch / "from.csv", "x,y,z\n1.3,2.2,0\n5,5,0\n");
  const auto [output, report, err] = measure(
      scratch, mesh + " --from " + scratch / "from.csv" + " -o " + npy + " -o " + csv + " --ascii-ply -o " + ply);
  const auto [values, header] = read_npy(npy);
  CHECK_THAT(header, Contains("'descr': '<f8'") && Contains("'shape': (49,)"));
  const auto rows = read_csv(csv);
  REQUIRE(rows.size() == 50);
  CHECK(rows[0] == std::vector<std::string>{"source", "vertex", "distance", "source_vertex"});
  REQUIRE(output["distances"].size() == 1);
  CHECK(output["points"] == "vertices");
  const std::string text = read_text(ply);
  const auto lines = split(text.substr(text.find("end_header") + 11), '\n');
  for (int v = 0; v < 49; ++v) {
    const int row = v / 7;
    const double x = v % 7, y = row;
    const double first = std::hypot(x - 1.3, y - 2.2), second = std::hypot(x - 5, y - 5);
    CHECK(values[v] == Approx(std::min(first, second)).epsilon(1e-13).margin(1e-14));
    CHECK(rows[v + 1] ==
          std::vector<std::string>{first <= second ? "0" : "1", std::to_string(v), fmt::format("{}", values[v]), "-1"});
    CHECK(output["distances"][0][v] == values[v]);
    CHECK(output["nearest"][v] == (first <= second ? 0 : 1));
    CHECK(std::stod(split(lines[v], ' ')[3]) == Approx(values[v]).epsilon(1e-6));
  }
  CHECK(report["results"]["largest"] == Approx(std::sqrt(26.0)));
  CHECK(report["results"]["unreached"] == 0);
  CHECK(report["generators"].size() == 2);
  CHECK(report["diagram"].is_null());
}

TEST_CASE("gvd-distance: round a cube, distances are those of the unfolded faces") {
  const ScratchFolder scratch;
  const auto [output, report, err] = measure(scratch, write_cube(scratch) + " --from 0 --to 1,3,7 --paths");
  const std::vector<double> known{1, std::sqrt(2.0), std::sqrt(5.0)};
  const Mesh mesh = read_mesh(scratch / "cube.off");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(output["distances"][0][i] == Approx(known[i]).epsilon(1e-14));
    const json& path = output["paths"][i];
    std::vector<SurfacePoint> points;
    for (const json& point : path["points"]) points.push_back(to_point(point));
    CHECK(path["length"].get<double>() == Approx(known[i]).epsilon(1e-14));
    CHECK(length_of(mesh, points) == Approx(known[i]).epsilon(1e-14));
  }
  CHECK_THAT(err, Contains("vertex 7 is 2.23606798 from vertex 0"));
}

TEST_CASE("gvd-distance: paths are as long as the distance, lie on the mesh, and no nearby path is shorter") {
  const ScratchFolder scratch;
  const std::string file = data_file("figure.obj"), csv = scratch / "p.csv";
  const auto output = measure(scratch, file + " --from 17,2000 --to 3,900,1500,2500 --paths -o " + csv).output;
  const Mesh mesh = read_mesh(file);
  REQUIRE(output["paths"].size() == 4);
  std::size_t rows = 1;
  for (const json& path : output["paths"]) {
    const double length = path["length"];
    CHECK(path["complete"] == true);
    CHECK(length == Approx(output["distances"][0][path["target"].get<int>()].get<double>()).epsilon(1e-13));
    std::vector<SurfacePoint> points;
    for (const json& point : path["points"]) {
      points.push_back(to_point(point));
      const auto at = point["position"].get<std::array<double, 3>>();
      CHECK((position(mesh, points.back()) - Vec3(at[0], at[1], at[2])).norm() == 0);
    }
    rows += points.size();
    CHECK(length_of(mesh, points) == Approx(length).epsilon(1e-12));
    const json& source = output["sources"][path["source"].get<int>()];
    CHECK((position(mesh, points.back()) - position(mesh, to_point(source))).norm() < 1e-12);
    // Each crossing of an edge, moved along it to either side, makes the path longer.
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      REQUIRE(find_common_view(mesh, points[i - 1], points[i]));
      if (points[i].kind() != SurfacePoint::Kind::edge) continue;
      for (const double move : {-0.01, 0.01}) {
        std::vector<SurfacePoint> moved = points;
        const HalfedgeId h = halfedge(points[i]);
        const double t = points[i].bary[Mesh::corner(Mesh::next(h))];
        moved[i] = edge_point(h, std::clamp(t + move, 0.0, 1.0));
        CHECK(length_of(mesh, moved) > length - 1e-12);
      }
    }
  }
  const auto table = read_csv(csv);
  CHECK(table.size() == rows);
  CHECK(fmt::format("{}", fmt::join(table[0], ",")) ==
        "path,source,target,length,face,b0,b1,b2,x,y,z,source_vertex,target_vertex");
}

TEST_CASE("gvd-distance: --each has a row for each source, whose least is that of the nearest") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply"), npy = scratch / "rows.npy";
  const json each = measure(scratch, mesh + " --from 0,40,90 --each -o " + npy).output;
  const json nearest = measure(scratch, mesh + " --from 0,40,90").output;
  const json second = measure(scratch, mesh + " --from 40").output;
  REQUIRE(each["distances"].size() == 3);
  CHECK(each["nearest"].is_null());
  CHECK(each["distances"][1] == second["distances"][0]);
  const auto [values, header] = read_npy(npy);
  const std::size_t n = each["distances"][0].size();
  CHECK_THAT(header, Contains(fmt::format("'shape': (3, {})", n)));
  for (std::size_t v = 0; v < n; ++v) {
    double least = INFINITY;
    for (std::size_t row = 0; row < 3; ++row) {
      CHECK(values[row * n + v] == each["distances"][row][v].get<double>());
      least = std::min(least, values[row * n + v]);
    }
    CHECK(nearest["distances"][0][v].get<double>() == Approx(least).epsilon(1e-12).margin(1e-14));
  }
  const json paths = measure(scratch, mesh + " --from 0,40 --to 90,90,17 --each --paths").output["paths"];
  REQUIRE(paths.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) CHECK(paths[i]["source"] == i / 3);
  CHECK(paths[0]["points"] == paths[1]["points"]);
  const json targets = measure(scratch, mesh + " --from 0,40,90 --to 90,17 --each").output;
  CHECK(targets["distances"][1][0] == each["distances"][1][90]);
  CHECK(targets["distances"][2][1] == each["distances"][2][17]);
}

TEST_CASE("gvd-distance: --each refuses a table that the memory does not hold, before the work") {
  if (kSanitized) return;  // a limit of memory would stop the sanitizer
  const ScratchFolder scratch;
  std::string list;
  for (int v = 0; v < 2900; ++v) list += fmt::format("{}\n", v);
  write_text(scratch / "all.txt", list);
  require_error(
      "gvd-distance",
      data_file("figure.obj") + " --each --max-memory 60M --from " + scratch / "all.txt" + " -o " + scratch / "a.npy",
      2, "give fewer sources");
}

TEST_CASE("gvd-distance: what is farther than --max-distance, or in another component, is inf") {
  const ScratchFolder scratch;
  const std::string mesh = write_plane(scratch, 6), csv = scratch / "d.csv";
  const std::string some = mesh + " --from 24 --max-distance 2 -o " + csv;
  const auto [output, report, err] = measure(scratch, some + " --isolines 1");
  int unreached = 0;
  const auto rows = read_csv(csv);
  for (int v = 0; v < 49; ++v) {
    const double straight = std::hypot(v % 7 - 3, v / 7 - 3);
    const json& d = output["distances"][0][v];
    CHECK(d.is_null() == (straight > 2));
    CHECK(rows[v + 1][2] == (straight > 2 ? "inf" : fmt::format("{}", d.get<double>())));
    CHECK(rows[v + 1][0] == (straight > 2 ? "-1" : "0"));
    unreached += straight > 2;
  }
  CHECK(report["results"]["unreached"] == unreached);
  CHECK_THAT(err, Contains(fmt::format("{} of 49 distances to vertices are inf", unreached)));
  REQUIRE(output["isolines"].size() == 2);
  for (const json& line : output["isolines"]) CHECK(line["closed"] == true);
  const auto far = measure(scratch, mesh + " --from 24 --to 25,0 --paths --max-distance 2");
  CHECK(far.output["distances"][0] == json({1.0, nullptr}));
  CHECK(far.output["paths"][1]["points"].empty());
  CHECK(far.output["paths"][1]["length"].is_null());
  CHECK_THAT(far.err, Contains("vertex 0 is not reached from any source"));
}

TEST_CASE("gvd-distance: rows are the vertices of the input file, unused ones too") {
  const ScratchFolder scratch;
  write_text(scratch / "a.obj", "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 3 4\nf 1 4 5\n");
  const json output = measure(scratch, scratch / "a.obj" + " --from 3").output;
  CHECK(output["distances"][0] == json({std::sqrt(2.0), nullptr, 1.0, 0.0, 1.0}));
  CHECK(output["nearest"] == json({0, -1, 0, 0, 0}));
  // A file of a triangle each: copies of a vertex are as far.
  const json stl = measure(scratch, data_file("plate.stl") + " --from 0").output["distances"][0];
  CHECK(stl.size() % 3 == 0);
  CHECK(std::none_of(stl.begin(), stl.end(), [](const json& d) { return d.is_null(); }));
}

TEST_CASE("gvd-distance: isolines and paths are lines of OBJ and VTP, and levels of the report") {
  const ScratchFolder scratch;
  const std::string obj = scratch / "a.obj", vtp = scratch / "a.vtp";
  const auto [output, report, err] = measure(
      scratch, write_plane(scratch, 6) + " --from 24 --to 0,48 --paths --isolines 0.75 -o " + obj + " -o " + vtp);
  const std::string text = read_text(obj);
  for (const char* name : {"g path_0\n", "g path_1\n", "g isoline_0.75\n", "g isoline_3.75\n"})
    CHECK_THAT(text, Contains(name));
  std::ptrdiff_t segments = 0;
  for (const json& path : output["paths"]) segments += std::ssize(path["points"]) - 1;
  for (const json& line : output["isolines"]) segments += std::ssize(line["points"]) - (line["closed"] == true ? 0 : 1);
  std::ptrdiff_t lines = 0;
  for (std::size_t at = text.find("\nl "); at != text.npos; at = text.find("\nl ", at + 1)) ++lines;
  CHECK(lines == segments);
  CHECK_THAT(read_text(vtp), Contains(fmt::format("NumberOfLines=\"{}\"", 2 + output["isolines"].size())) &&
                                 Contains("Name=\"Curve\""));
  const json& levels = report["results"]["isolines"];
  REQUIRE(levels.size() == 5);  // 3 sqrt(2) is the largest distance
  CHECK(levels[3]["level"] == 3.0);
  CHECK(levels[0]["closed"] == 1);
  CHECK(levels[0]["length"].get<double>() == Approx(2 * M_PI * 0.75).epsilon(0.01));
  CHECK(levels[4]["curves"] == 4);  // round the corners
  CHECK(levels[4]["closed"] == 0);
}

TEST_CASE("gvd-distance: isolines that would fill the memory are refused") {
  const ScratchFolder scratch;
  // A disc of 5,000 triangles round vertex 0: each of 5,000 spokes crosses each level.
  constexpr int kSpokes = 5000;
  std::string vertices = "0 0 0\n", faces;
  for (int i = 0; i < kSpokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSpokes;
    vertices += fmt::format("{} {} 0\n", std::cos(angle), std::sin(angle));
    faces += fmt::format("3 0 {} {}\n", i + 1, (i + 1) % kSpokes + 1);
  }
  write_text(scratch / "disc.off", fmt::format("OFF\n{} {} 0\n{}{}", kSpokes + 1, kSpokes, vertices, faces));
  require_error(
      "gvd-distance", scratch / "disc.off" + " --from 0 --isolines 2.1e-4 -o " + scratch / "a.json", 2,
      "--isolines 0.00021: the curves would cross edges 2.4e+07 times, more than 2e+07; give fewer levels, with "
      "a larger step");
}

TEST_CASE("gvd-distance: isolines of a coarse mesh are nowhere farther from their level than 1e-4 mean edges") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "a.off", sources = scratch / "sources.txt";
  write_text(mesh, "OFF\n4 2 0\n0 0 0\n3 0 0\n3 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  write_text(sources, "p 2.556 0.337 0\np 0.889 0.259 0\n");
  const auto distance = [](const json& a, const json& b, double t) {
    const auto at = [&](int i) {
      return (1 - t) * a["position"][i].get<double>() + t * b["position"][i].get<double>();
    };
    return std::min(std::hypot(at(0) - 2.556, at(1) - 0.337), std::hypot(at(0) - 0.889, at(1) - 0.259));
  };
  for (const char* level : {"0.394", "0.788"}) {
    const json output = measure(scratch, mesh + " --from " + sources + " --isolines " + level).output;
    REQUIRE(!output["isolines"].empty());
    double worst = 0;
    for (const json& line : output["isolines"]) {
      const json& points = line["points"];
      for (std::size_t i = line["closed"] == true ? 0 : 1; i < points.size(); ++i) {
        const json& before = points[(i + points.size() - 1) % points.size()];
        for (const double t : {0.0, 0.5, 0.9}) {
          worst = std::max(worst, std::abs(distance(before, points[i], t) - line["level"].get<double>()));
        }
      }
    }
    CHECK(worst < 1e-4 * (3 + 3 + 1 + 1 + std::sqrt(10)) / 5);
  }
  const json report = measure(scratch, mesh + " --curves boundary --isolines 0.4").report;
  CHECK(report["results"]["isolines"][0]["curves"] == 1);
  CHECK(report["results"]["isolines"][0]["closed"] == 1);
  CHECK(report["results"]["isolines"][0]["length"].get<double>() == Approx(4.8).epsilon(1e-9));
}

TEST_CASE("gvd-distance: the same bytes on any number of threads") {
  const ScratchFolder scratch;
  const std::vector<std::string> formats{"npy", "csv", "json", "ply", "vtp", "vtu", "obj"};
  std::vector<std::string> texts;
  for (const char* threads : {"1", "2", "5"}) {
    std::string line = data_file("figure.obj") + " -q --from 17,900 --to 3,5 --isolines 0.2 --threads " + threads;
    for (const std::string& format : formats) line += " -o " + scratch / "a." + format;
    REQUIRE(run_command("gvd-distance", line).exit_code == 0);
    std::string all;
    for (const std::string& format : formats) all += read_text(scratch / "a." + format);
    texts.push_back(all);
  }
  CHECK(texts[1] == texts[0]);
  CHECK(texts[2] == texts[0]);
}

TEST_CASE("gvd-distance: --view shows distances, curves and the paths of vertices") {
  const ScratchFolder scratch;
  const std::string page = scratch / "a.html";
  const CommandResult result = run_command(
      "gvd-distance", data_file("figure.obj") + " -q --from 17 --to 3 --paths --isolines 0.5 " + "--view " + page);
  if (result.err.find("not part of this build") != std::string::npos) {
    WARN("skipped: built without the viewer");
    return;
  }
  REQUIRE(result.exit_code == 0);
  const std::string text = read_text(page);
  for (const char* member : {"\"isolines\":", "\"paths\":", "\"vertex_paths\":", "2938 of 2938"})
    CHECK_THAT(text, Contains(member));
}

TEST_CASE("gvd-distance: lists come from standard input, files of options and several inputs") {
  const ScratchFolder scratch;
  const std::string mesh = write_plane(scratch, 6), list = scratch / "list.txt", toml = scratch / "a.toml";
  write_text(list, "24\np 3 3 0\n");
  const CommandResult piped =
      run_command("gvd-distance", mesh + " -q --from 0 --to - -o - --output-format csv < " + list);
  CHECK(piped.out ==
        "source,target,distance,source_vertex,target_vertex\n0,0,4.242640687119285,0,24\n0,1,4.242640687119285,0,-1\n");
  write_text(toml, "from = [0]\nto = [24, 24]\n");
  write_text(list, "48\n\np 3 1 0\np 5 1 0\n");
  const std::string to_vertex_0 = " -q --to 0 -o - --output-format csv --curves ";
  const CommandResult curve = run_command("gvd-distance", mesh + to_vertex_0 + "- < " + list);
  CHECK_THAT(curve.out, Contains("_vertex\n1,0,3.16227766"));
  CHECK(curve.out == run_command("gvd-distance", mesh + to_vertex_0 + list).out);
  const CommandResult configured =
      run_command("gvd-distance", mesh + " -q --config " + toml + " -o - --output-format csv");
  CHECK_THAT(configured.out, Contains("\n0,0,4.242640687119285,0,24\n0,1,4.242640687119285,0,24\n"));
  const CommandResult several =
      run_command("gvd-distance", mesh + " " + data_file("torus.ply") + " --from 0 --output-dir " + scratch / "out" +
                                      " --output-format npy,csv");
  CAPTURE(several.err);
  REQUIRE(several.exit_code == 0);
  CHECK(read_csv(scratch / "out/plane.csv").size() == 50);
  CHECK(read_npy(scratch / "out/torus.npy").first.size() > 50);
}

TEST_CASE("gvd-distance: bad lists and contradictory options are refused in one line") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj"), out = " -o " + scratch / "a.npy";
  const auto refused = [&](const std::string& options, int code, const std::string& part) {
    require_error("gvd-distance", mesh + " " + options, code, part);
  };
  refused("", 2, "--from or --curves");
  refused("--from ''", 2, "the list is empty");
  refused("--from 3 -n 4", 2, "unknown option: -n");
  refused("--from 3 --method gbgvd", 2, "unknown option: --method");
  refused("--from 3 17" + out, 2, "--from takes commas without blanks");
  refused("--from none.txt" + out, 3, "none.txt");
  refused("--from 99999" + out, 4, "there is no vertex 99999");
  refused("--from 3,3" + out, 4, "--from: vertex 3 is listed twice; remove one, or add --merge-coincident");
  refused("--from - --to -" + out + " < /dev/null", 2, "--from and --to are both standard input");
  refused("--curves - --to -" + out + " < /dev/null", 2, "--to and --curves are both standard input");
  refused("--curves -" + out + " < /dev/null", 3, "standard input: the file holds no curve");
  refused("--from 3 --paths" + out, 2, "add --to");
  refused("--from 3 --each --isolines 1 -o " + scratch / "a.json", 2, "--each and --isolines exclude each other");
  refused("--from 3 --each -o " + scratch / "a.ply", 2, "hold one distance for each vertex");
  refused("--from 3 --isolines 1" + out, 2, "--isolines: only .obj, .vtp");
  refused("--from 3 --isolines 1e-9 -o " + scratch / "a.json", 2, "give a larger step");
  refused("--from 3 --isolines 0 -o " + scratch / "a.json", 2, "--isolines");
  refused("--from 3 --max-distance nan" + out, 2, "--max-distance");
  refused("--from 3 -o " + scratch / "a.stl", 2, "the extension must be one of");
  refused("--from 3 -o " + scratch / "none/a.npy", 6, "there is no directory");
  write_text(scratch / "list.csv", "vertex\n3\n");
  refused("--from " + scratch / "list.csv" + " -o " + scratch / "list.csv", 2, "the run reads this file");
  refused("--from 3 --to " + scratch / "list.csv" + " -o " + scratch / "list.csv", 2, "the run reads this file");
  write_text(scratch / "far.txt", "p 0 0 99\n");
  refused("--from 3 --to " + scratch / "far.txt" + " --max-snap 1" + out, 4, "far.txt:1");
}

}  // namespace gvd::test_distance_command
