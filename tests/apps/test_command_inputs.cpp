// What the commands read, and the report of a run.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"
#include "support/twisted_strip.hpp"

namespace gvd::test_command_inputs {

using namespace test;
using Catch::Matchers::Contains;

TEST_CASE("commands: a run reports what it did, and is silent when asked") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const std::string report = scratch / (name + ".json");
    const CommandResult result = run_command(name, data_file("torus.ply") + " -n 40 -q --report " + report);
    CHECK(result.exit_code == 0);
    CHECK(result.out.empty());
    CHECK(result.err.empty());
    const auto content = nlohmann::json::parse(read_text(report));
    CHECK(content["schema"] == "gvd-report/2");
    CHECK(content["command"] == name);
    CHECK(content["seed"] == 0);
    CHECK(content["options"]["count"] == 40);
    CHECK(content["input"]["faces"].get<int>() > 1000);
    CHECK(content["generators"].size() >= 40);
    CHECK(content["diagram"]["unresolved_ends"] == 0);
    CHECK(content["peak_memory_bytes"].get<double>() > 1e6);
    CHECK(content["timings_ms"].contains(name == "gvd-segment" ? "diagram" : "relaxation"));
    CHECK(content["timings_ms"].contains("dual") == (name == "gvd-remesh"));
  }
}

TEST_CASE("commands: the report names the method and what belongs to it") {
  const ScratchFolder scratch;
  const std::string report = scratch / "r.json";
  const auto run_with = [&](const std::string& name, const std::string& options) {
    CAPTURE(name, options);
    const CommandResult result =
        run_command(name, data_file("torus.ply") + " -n 20 -q --report " + report + " " + options);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(read_text(report));
  };
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const auto exact = run_with(name, ""), fine = run_with(name, "--method exact --chord-tolerance 1e-6"),
               paper = run_with(name, "--method gbgvd"), planar = run_with(name, "--method gbgvd --front planar");
    CHECK(exact["options"]["method"] == "exact");
    CHECK(exact["options"]["chord_tolerance"] == 1e-4);
    CHECK(exact["options"]["front"].is_null());
    CHECK(exact["diagram"]["straightened_faces"] == 0);
    CHECK(exact["diagram"]["relabelled_vertices"] == 0);
    CHECK(fine["options"]["chord_tolerance"] == 1e-6);
    CHECK(paper["options"]["method"] == "gbgvd");
    CHECK(paper["options"]["chord_tolerance"].is_null());
    CHECK(paper["options"]["front"] == "circle");
    CHECK(planar["options"]["front"] == "planar");
    // Four different diagrams: each option has its effect.
    CHECK(exact["diagram"]["length"] != fine["diagram"]["length"]);
    CHECK(exact["diagram"]["length"] != paper["diagram"]["length"]);
    CHECK(paper["diagram"]["length"] != planar["diagram"]["length"]);
  }
}

// A tetrahedron whose faces have vertices of their own.
const char* const kLooseTetrahedron =
    "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 0 1\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\n";

TEST_CASE("commands: --weld joins copies of vertices, with or without a number, and does not take INPUT for one") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "loose.obj", report = scratch / "r.json";
  write_text(mesh, kLooseTetrahedron);
  write_text(scratch / "weld.toml", "weld = true\n");
  for (const std::string& options : {"--weld " + mesh, mesh + " --weld", "--weld 1e-6 " + mesh, "--weld=0 " + mesh,
                                     mesh + " --config " + (scratch / "weld.toml")}) {
    CAPTURE(options);
    const CommandResult result = run_command("gvd-segment", options + " -n 2 --report " + report);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("8 vertices are welded to others"));
    const auto content = nlohmann::json::parse(read_text(report));
    CHECK(content["input"]["vertices"] == 4);
    CHECK(content["input"]["boundary_loops"] == 0);
    CHECK(content["input"]["defects"]["unwelded_vertices"] == 8);
    CHECK(content["results"]["unreached_faces"] == 0);
  }
}

TEST_CASE("commands: without --weld a note says how many open edges it would close") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "loose.obj";
  write_text(mesh, kLooseTetrahedron);
  const CommandResult result = run_command("gvd-segment", mesh + " -n 4");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Contains("8 boundary vertices are at the position of another one: not joined, the surface is "
                                  "open there; --weld would close 12 open edges\n"));
}

TEST_CASE("commands: --weld that joins nothing says how near vertices on open edges are") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "parted.obj";
  write_text(mesh, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 .25\nv 1 1 .25\nv 0 1 .25\nf 1 2 3\nf 4 5 6\n");
  const std::string apart = "; on open edges, the nearest two that no edge joins are 0.25 apart\n";
  for (const auto& [name, options] : {std::pair{"gvd-segment", " -n 2"}, {"gvd-distance", " --from 0"}}) {
    const std::string run = mesh + options;
    CAPTURE(name);
    CHECK_THAT(run_command(name, run + " --weld .1").err,
               Contains("parted.obj: welding within 0.1 joins nothing: no two vertices are that close" + apart));
    CHECK_THAT(run_command(name, run + " --weld").err,
               Contains("welding joins nothing: no two vertices are at the same coordinates" + apart));
    CHECK_THAT(run_command(name, run + " --weld .25").err, !Contains("joins nothing"));
    CHECK_THAT(run_command(name, run).err, !Contains("joins nothing"));
  }
}

TEST_CASE("commands: a tolerance of --weld that is no number from 0 on is a usage error") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "loose.obj";
  write_text(mesh, kLooseTetrahedron);
  for (const std::string wrong : {"-1", "nan", "inf", "-inf"}) {
    CAPTURE(wrong);
    const CommandResult result = run_command("gvd-segment", mesh + " -n 2 --weld " + wrong);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("'" + wrong + "' is not a finite number from 0 on"));
  }
  const CommandResult tiny = run_command("gvd-segment", mesh + " -n 2 --weld 1e-200");
  CHECK(tiny.exit_code == 2);
  CHECK_THAT(tiny.err, Contains("weld: the tolerance 1e-200 is below 1e-100; 0 joins exact copies"));
  const CommandResult all = run_command("gvd-segment", mesh + " -n 2 --weld 3");
  CHECK(all.exit_code == 4);
  CHECK_THAT(all.err, Contains("loose.obj: welding within 3 joins all vertices: choose a smaller tolerance"));
}

TEST_CASE("commands: a triangle without area that hangs on nothing does not spoil the rest") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "stray.obj", report = scratch / "r.json";
  write_text(mesh,
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 8 0 0\n"
             "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 5 6 7\n");
  const CommandResult result = run_command("gvd-segment", mesh + " -n 3 --balance area --report " + report);
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err,
             Contains("1 component consists of faces without area only, first the one of face 4: removed\n"));
  CHECK_THAT(result.err, !Contains("hold the surface together"));
  CHECK(nlohmann::json::parse(read_text(report))["input"]["defects"]["zero_area_components"] == 1);
  const CommandResult refused = run_command("gvd-segment", mesh + " -n 3 --on-defect error");
  CHECK(refused.exit_code == 4);
  CHECK_THAT(refused.err, Contains("first the one of face 4: repair the mesh, or allow its repair with --on-defect"));
}

std::string to_obj(const PolygonSoup& soup) {
  std::string text;
  for (const Vec3& p : soup.positions) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (std::size_t f = 0; f < soup.polygon_count(); ++f) {
    text += "f";
    for (const std::int32_t v : soup.polygon(f)) text += fmt::format(" {}", v + 1);
    text += "\n";
  }
  return text;
}

TEST_CASE("commands: a closed one-sided surface is cut along its twist of seven edges, or refused from 1 % on") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "closed.obj", coarse = scratch / "coarse.obj", report = scratch / "r.json";
  write_text(mesh, to_obj(make_twisted_strip(34, true)));    // 714 edges
  write_text(coarse, to_obj(make_twisted_strip(33, true)));  // 693
  const std::pair<const char*, const char*> runs[] = {{"gvd-segment", " -n 6"},
                                                      {"gvd-segment", " -n 6 --cut --disc"},
                                                      {"gvd-segment", " -n 6 --balance area"},
                                                      {"gvd-lloyd", " -n 6"},
                                                      {"gvd-remesh", " -n 60"},
                                                      {"gvd-distance", " --from 0 --to 50"}};
  for (const auto& [name, options] : runs) {
    if (std::string(name) != "gvd-distance" && !std::ranges::count(built_commands(), name)) continue;
    CAPTURE(name, options);
    const CommandResult cut = run_command(name, mesh + options + " --report " + report);
    CAPTURE(cut.err);
    REQUIRE(cut.exit_code == 0);
    CHECK_THAT(cut.err, Contains("closed.obj: 7 edges between faces of opposite orientations make the surface "
                                 "one-sided, like a Moebius strip, first the one between vertices 0 and 1 of face 1: "
                                 "cut open there\n"));
    const auto input = nlohmann::json::parse(read_text(report))["input"];
    CHECK(input["defects"]["one_sided_edges"] == 7);
    CHECK(input["boundary_loops"] == 2);
    const CommandResult refused = run_command(name, coarse + options);
    CHECK(refused.exit_code == 4);
    CHECK_THAT(refused.err, Contains("coarse.obj: the component of face 0 has only one side, like a Moebius strip"));
  }
}

TEST_CASE("commands: a vertex far outside is named") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "far.obj";
  write_text(mesh, "v 0 0 0\nv 50 0 0\nv 0 50 0\nv 50 50 0\nv 1e7 50 0\nf 1 2 3\nf 2 4 3\nf 2 5 4\n");
  const CommandResult result = run_command("gvd-segment", mesh + " -n 2");
  CHECK_THAT(result.err, Contains("1 vertex lies far outside: vertex 4 is 1e+07 from the middle, where half"));
}

TEST_CASE("gvd-segment: a note says why no generator reaches some faces") {
  const ScratchFolder scratch;
  const std::string mesh = scratch / "fin.obj";
  const auto told = [&](const std::string& options) { return run_command("gvd-segment", mesh + options).err; };
  const std::string fin = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
  write_text(mesh, fin);
  const std::string cut = "beyond a non-manifold edge, where sheets were cut apart";
  CHECK_THAT(told(" --vertices 2"), Contains("1 face is reached by no generator and gets label -1: " + cut + "\n"));
  // With a component of its own, and one that touches the first one at a vertex.
  write_text(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 3 1 0\nv 3 -1 0\n" +
                       fin.substr(fin.find('f')) + "f 6 7 8\nf 2 9 10\n");
  CHECK_THAT(told(" --vertices 2,4"),
             Contains("2 faces are reached by no generator and get label -1: 1 beyond a non-manifold vertex, where "
                      "sheets were cut apart; 1 in another component\n"));
  write_text(scratch / "regions.txt", "0\n1\n0\n0\n0\n");
  CHECK_THAT(told(" --vertices 2,4,5,8 --within " + scratch / "regions.txt"),
             Contains("1 face is reached by no generator and gets label -1: in another region\n"));
}

TEST_CASE("commands: what they write as VTP, VTU and GLB, they read") {
  const ScratchFolder scratch;
  const std::string torus = data_file("torus.ply");
  CHECK(run_command("gvd-segment",
                    torus + " -n 20 -q -o " + scratch / "a.vtp" + " -o " + scratch / "a.vtu -o " + scratch / "a.glb")
            .exit_code == 0);
  for (const std::string& name : built_commands()) {
    std::vector<std::string> meshes;
    for (const std::string& arguments : {torus, scratch / "a.vtp", scratch / "a.vtu", scratch / "a.glb",
                                         "- --input-format vtp < " + scratch / "a.vtp"}) {
      CAPTURE(name, arguments);
      const std::string report = scratch / "r.json";
      REQUIRE(run_command(name, "-n 20 -q --report " + report + " " + arguments).exit_code == 0);
      nlohmann::json input = nlohmann::json::parse(read_text(report))["input"];
      meshes.push_back(input["vertices"].dump() + " " + input["faces"].dump() + " " +
                       input["euler_characteristic"].dump());
    }
    CHECK(meshes == std::vector<std::string>(5, meshes[0]));
  }
}

TEST_CASE("commands: a .gltf is read with its buffer beside it, which standard input can't have") {
  const ScratchFolder scratch;
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"BUFFER"}]})";
  const auto with_buffer = [&](const std::string& uri) {
    std::string text = gltf;
    return text.replace(text.find("BUFFER"), 6, uri);
  };
  // (0, 0, 0), (1, 0, 0), (0, 1, 0) as floats.
  std::string numbers(36, '\0');
  for (const std::size_t at : {12, 28}) numbers.replace(at + 2, 2, "\x80\x3f");
  write_text(scratch / "numbers.bin", numbers);
  write_text(scratch / "a.gltf", with_buffer("numbers.bin"));
  write_text(scratch / "away.gltf", with_buffer("../numbers.bin"));
  write_text(scratch / "inside.gltf",
             with_buffer("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"));
  for (const std::string& arguments :
       {scratch / "a.gltf", scratch / "inside.gltf", "- --input-format gltf < " + scratch / "inside.gltf"}) {
    CAPTURE(arguments);
    const CommandResult result = run_command("gvd-segment", "-n 1 -q -o - --output-format off " + arguments);
    CAPTURE(result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, Contains("3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"));
  }
  require_error("gvd-segment", "-n 1 - --input-format gltf < " + scratch / "a.gltf", 3,
                "standard input: buffer 0, 'numbers.bin', is not in the file");
  require_error("gvd-segment", "-n 1 " + scratch / "away.gltf", 3, "is not in the folder of the mesh");
}

TEST_CASE("commands: files that are named like OBJ or STL and hold something else are read, or named") {
  const ScratchFolder scratch;
  const auto file = [&](const std::string& name, const std::string& text) {
    write_text(scratch / name, text);
    return scratch / name;
  };
  std::string wide = "\xff\xfe";
  for (const char c : std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n")) wide += {c, '\0'};
  for (const std::string& path :
       {file("wide.obj", wide), file("modelnet.off", "OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        file("mni.obj",
             "P 0.3 0.3 0.4 10 1 3\n0 0 0\n1 0 0\n0 1 0\n\n0 0 1\n0 0 1\n0 0 1\n\n1\n0 1 1 1 1\n\n3\n\n0 1 2\n")}) {
    CAPTURE(path);
    const CommandResult result = run_command("gvd-segment", path + " -n 1 -q -o - --output-format off");
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, Contains("3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"));
  }
  const std::string counted_none = "solid Part" + std::string(74, '\0') + std::string(100, '\0');
  require_error("gvd-segment", file("count0.stl", counted_none) + " -n 1", 3,
                "says that there are 0 triangles, and 100 bytes follow, room for 2 triangles");
  require_error("gvd-segment", file("x.3mf", "PK\x03\x04 [Content_Types].xml 3D/3dmodel.model") + " -n 1", 3,
                "the file is a 3MF model; export the mesh as STL, PLY or OBJ");
  require_error(
      "gvd-segment",
      file("lines.vtk",
           "# vtk DataFile Version 3.0\nl\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\nLINES 1 3\n2 0 1\n") +
          " -n 1",
      3, "the file has 2 vertices and no face; a surface is needed (1 line or vertex is left out)");
}

TEST_CASE("commands: a bad file is refused in one line that names it") {
  const ScratchFolder scratch;
  const auto file = [&](const std::string& name, const std::string& text) {
    write_text(scratch / name, text);
    return scratch / name;
  };
  const std::string torus = read_text(data_file("torus.ply"));
  const std::vector<std::pair<std::string, int>> bad{
      {scratch / "missing.obj", 3},
      {"/tmp", 3},
      {file("empty.obj", ""), 3},
      {file("empty.ply", ""), 3},
      {file("words.obj", "this is no mesh\n"), 3},
      {file("pointer.ply", "version https://git-lfs.github.com/spec/v1\n"), 3},
      {file("page.obj", "<!DOCTYPE html>\n"), 3},
      {file("cut.obj.gz", "\x1f\x8b\x08"), 3},
      {file("words.ply", "this is no mesh\n"), 3},
      {file("bytes.stl", std::string(100, '\xff')), 3},
      {file("short.ply", torus.substr(0, torus.size() / 2)), 3},
      {file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), 3},
      {file("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), 4},
      {file("point.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"), 4},
  };
  for (const std::string& name : built_commands()) {
    for (const auto& [path, code] : bad) require_error(name, path + " -n 1", code, path);
    require_error(name, file("mesh.xyz", "0 0 0\n") + " -n 1", 3, "name the format with --input-format");
    require_error(name, "- --input-format off -n 1 < " + bad[5].first, 3, "standard input");
    require_error(name, "- --input-format off -n 1", 3, "standard input");
  }
}

TEST_CASE("commands: a bad list of generators is refused in one line") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply");
  const auto refused = [&](const std::string& text, int code, const std::string& part) {
    write_text(scratch / "list.txt", text);
    for (const std::string& name : built_commands()) {
      require_error(name, mesh + " --max-snap 0.01 --generators " + scratch / "list.txt", code, part);
    }
  };
  refused("1\n2\nthree\n", 3, "list.txt:3: ");
  refused("", 3, "list.txt:1: ");
  refused("1\n99999999\n", 4, "list.txt:2: ");
  refused("5\n6\n5\n", 4, "list.txt:3: vertex 5 is listed twice (");
  refused("p 9 9 9\n", 4, "list.txt:1: ");
  for (const std::string& name : built_commands()) {
    require_error(name, mesh + " --generators " + scratch / "missing.txt", 3, "missing.txt");
    require_error(name, mesh + " --generators " + scratch / "", 3, "is a directory");
    require_error(name, mesh + " --vertices 1,99999999", 4, "99999999");
  }
}

TEST_CASE("commands: what the results lack or get wrong is told") {
  const ScratchFolder scratch;
  write_text(scratch / "far.txt", "p 1.3 0 0\np 0 9 0\n");
  write_text(scratch / "textured.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
  write_text(scratch / "distant.obj", "v 1e15 0 0\nv 1.000000000000008e15 0 0\nv 1e15 8 0\nf 1 2 3\n");
  const auto told = [&](const std::string& arguments) {
    const CommandResult result = run_command("gvd-segment", arguments + " -o " + scratch / "out.ply");
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(told(data_file("torus.ply") + " --generators " + scratch / "far.txt"),
             Contains("far.txt:2 is ") && Contains("from the surface, and the model's diagonal is "));
  CHECK_THAT(told(scratch / "textured.obj -n 1"), !Contains("left out"));
  CHECK_THAT(told(scratch / "distant.obj -n 1"),
             Contains("coordinates are multiples of 0.12 so far from the origin, and edges there are 9"));
  CHECK_THAT(told(data_file("torus.ply") + " --max-snap 99 --generators " + scratch / "far.txt"),
             !Contains("diagonal"));
  const std::string fixed = data_file("torus.ply") + " -n 5 --iterations 1 --fixed " + scratch / "far.txt";
  CHECK_THAT(run_command("gvd-lloyd", fixed).err, Contains("far.txt:2 is "));
  CHECK_THAT(told(data_file("torus.ply") + " -n 3"), !Contains("texture") && !Contains("multiples"));
}

TEST_CASE("commands: one of a kind is counted in the singular") {
  const CommandResult result = run_command("gvd-segment", data_file("torus.ply") + " -n 1 -v");
  for (const char* part : {" 1 component, ", " 1 generator\n", " 1 cell, 0 branch points, 0 bisectors"}) {
    CHECK_THAT(result.err, Contains(part));
  }
}

TEST_CASE("commands: a covering radius far too small is refused at once") {
  for (const std::string& name : built_commands()) {
    for (const char* radius : {"1e-300", "1e-9", "1e-4"}) {
      require_error(name, data_file("torus.ply") + " --radius " + radius, 4, "too small for this surface");
    }
  }
}

}  // namespace gvd::test_command_inputs
