// Lists of generators as files, and plain lists of numbers, as densities are given.
#include <clocale>
#include <cstdlib>
#include <fstream>

#include "gvd/text.hpp"
#include "io/fixture.hpp"
#include "io/generator_fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_read_generators {

using namespace test;

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
  const Mesh mesh = make_grid(3, 3);
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
}

TEST_CASE("the format of a list is told from its content") {
  using Format = GeneratorFormat;
  for (const char* text : {"17\n", "", "\n# 1,2\n 3 0.25 0.5 0.25\n", "p 1 2 3", "17 # a, b\n", "# only",
                           "\xef\xbb\xbf"
                           "17\n"}) {
    CAPTURE(text);
    CHECK(detect_generator_format(text) == Format::text);
  }
  for (const char* csv : {"3,0.5,0.5,0\n", "vertex\r\n17\r\n", "# list\n\"x\",\"y\",\"z\"\n", "\"vertex\"\n17\n"}) {
    CAPTURE(csv);
    CHECK(detect_generator_format(csv) == Format::csv);
  }
  for (const char* json : {"{", " \n\t{\"generators\":[]}", "[1]", "\xef\xbb\xbf{"})
    CHECK(detect_generator_format(json) == Format::json);
}

TEST_CASE("the vertices of a PLY are points in faces where it has them, else positions") {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n";
  const std::string points =
      head + "property int face\nproperty double b0\nproperty double b1\nproperty double b2\nend_header\n";
  CHECK(detect_generator_format(points) == GeneratorFormat::ply);
  const auto parse = [](const std::string& bytes) {
    return parse_generators(bytes, GeneratorFormat::ply, "list").entries;
  };
  const auto in_faces = parse(points + "9 9 9 3 0.25 0.5 0.25\n9 9 9 0 1 0 0\n");
  REQUIRE(in_faces.size() == 2);
  CHECK(in_faces[0].kind == GeneratorEntry::Kind::face);
  CHECK(in_faces[0].index == 3);
  CHECK(in_faces[0].values == std::array{0.25, 0.5, 0.25});
  const auto positions =
      parse(head + "element face 0\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n4 5 6.5\n");
  REQUIRE(positions.size() == 2);
  CHECK(positions[1].kind == GeneratorEntry::Kind::position);
  CHECK(positions[1].values == std::array{4.0, 5.0, 6.5});
  const auto refused = [&](const std::string& bytes) {
    return refusal([&] { parse(bytes); }, ErrorCode::unreadable_input);
  };
  CHECK(refused(points + "9 9 9 3 0.25 0.5 0.25\n9 9 9 0.5 1 0 0\n") ==
        "list: point 1 of the PLY has numbers that are not a face and coordinates in it");
  CHECK(refused(head + "end_header\n1 2 nan\n1 2 3\n") ==
        "list: point 0 of the PLY has numbers that are not a position");
  CHECK_THAT(refused(head + "end_header\n1 2 3\n"),
             Catch::Matchers::Contains("the header promises 2 of element 'vertex'"));
  CHECK_THAT(refused("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float "
                     "z\nend_header\n"),
             Catch::Matchers::Contains("holds no generator"));
}

TEST_CASE(
    "the first three numbers of a line of XYZ are a position, whole or not, text takes a position with a normal") {
  const auto xyz = parse_generators("1 2 3\n4 5 6 0 0 1 255 red\n", GeneratorFormat::xyz, "list").entries;
  REQUIRE(xyz.size() == 2);
  CHECK(xyz[0].kind == GeneratorEntry::Kind::position);
  CHECK(xyz[1].values == std::array{4.0, 5.0, 6.0});
  CHECK(xyz[1].line == 2);
  CHECK(refusal([] { parse_generators("1 2\n", GeneratorFormat::xyz, "list"); }, ErrorCode::unreadable_input) ==
        "list:1: 2 fields of three coordinates");
  const auto text = parse_generators("4 5 6 0 0 1\n", GeneratorFormat::text, "list").entries;
  REQUIRE(text.size() == 1);
  CHECK(text[0].kind == GeneratorEntry::Kind::position);
  CHECK(text[0].values == std::array{4.0, 5.0, 6.0});
  CHECK_THAT(
      refusal([] { parse_generators("4 5 6 0 0 up\n", GeneratorFormat::text, "list"); }, ErrorCode::unreadable_input),
      Catch::Matchers::Contains("'up' is not a finite number"));
}

TEST_CASE("an array of NumPy is no list, and named") {
  CHECK(
      refusal([] { parse_generators("\x93NUMPY\x01", GeneratorFormat::text, "list"); }, ErrorCode::unreadable_input) ==
      "list: the file is a NumPy array; write the points as .ply, .xyz or text");
}

TEST_CASE("a list in UTF-16 is read in every format") {
  const auto wide = [](std::string_view text) {
    std::string bytes = "\xff\xfe";
    for (const char c : text) bytes += {c, '\0'};
    return bytes;
  };
  for (const auto& [text, format] : {std::pair("17\r\n", GeneratorFormat::text),
                                     {"vertex\r\n17\r\n", GeneratorFormat::csv},
                                     {"{\"generators\":[{\"vertex\":17}]}", GeneratorFormat::json}}) {
    CHECK(detect_generator_format(wide(text)) == format);
    CHECK(parse_generators(wide(text), format, "list").entries.at(0).index == 17);
  }
  CHECK(parse_numbers(wide("1 2"), "list") == std::vector<double>{1, 2});
}

TEST_CASE("a file is read in the given format, in that of its extension, or by its content") {
  const TemporaryFolder folder;
  const std::string json = "{\"generators\":[{\"vertex\":7}]}";
  for (const auto& [name, content] : std::vector<std::pair<std::string, std::string>>{{"a.JSON", json},
                                                                                      {"a.csv", "vertex\n7\n"},
                                                                                      {"a.txt", "7\n"},
                                                                                      {"list", json},
                                                                                      {"a.dat", "vertex\n7\n"},
                                                                                      {"a", "7"}}) {
    CAPTURE(name);
    write_bytes(folder / name, content);
    CHECK(read_generators(folder / name).entries.at(0).index == 7);
  }
  CHECK_THROWS_AS(read_generators(folder / "a.csv", GeneratorFormat::json), Error);
  write_bytes(folder / "b.csv", json);
  CHECK(read_generators(folder / "b.csv", GeneratorFormat::json).entries.at(0).index == 7);
}

TEST_CASE("a written list reads back bit by bit") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  std::mt19937 random(5);
  for (const auto& [name, mesh] : small_family()) {
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

// Hidden: tests/formats/check_schemas.py asks for it.
TEST_CASE("write a list as JSON to the file that GVD_LIST_SAMPLE names", "[.list]") {
  const char* file = std::getenv("GVD_LIST_SAMPLE");
  REQUIRE(file != nullptr);
  const Mesh mesh = make_sphere(1);
  std::ofstream(file) << format_generators(
      mesh, {vertex_point(mesh, VertexId(3)), make_surface_point(FaceId(5), {0.25, 0.25, 0.5})}, GeneratorFormat::json);
}

std::string refused(const std::string& content) {
  return refusal([&] { parse_numbers(content, "list"); }, ErrorCode::unreadable_input);
}

TEST_CASE("numbers stand between blanks, commas and line ends, and # begins a comment") {
  CHECK(parse_numbers("\xef\xbb\xbf# weights\n1 2.5,\t-3e2 , 4 # 5\r\n\n6", "list") ==
        std::vector<double>{1, 2.5, -300, 4, 6});
  CHECK(parse_numbers("", "list").empty());
  CHECK(parse_numbers(" ,\n, ,\n", "list").empty());
}

TEST_CASE("what is no number in full is refused with its line") {
  CHECK(refused("1\n2 two 3\n") == "list:2: 'two' is not a number");
  CHECK(refused("1\n\n2.5x") == "list:3: '2.5x' is not a number");
  CHECK(refused("1;2") == "list:1: '1;2' is not a number");
  CHECK(refused("1e999") == "list:1: '1e999' is not a number");
}

TEST_CASE("a list that is not there, or is packed, is refused with its name") {
  CHECK(refusal([] { read_generators("missing/list.txt"); }, ErrorCode::unreadable_input) ==
        "missing/list.txt: No such file or directory; name a list of generators");
  CHECK(refusal([] { read_generators("/"); }, ErrorCode::unreadable_input) ==
        "/: is a directory; name a list of generators");
  const TemporaryFolder folder;
  std::ofstream(folder / "list.txt.gz") << "\x1f\x8b\x08";
  CHECK_THAT(refusal([&] { read_generators(folder / "list.txt.gz"); }, ErrorCode::unreadable_input),
             Catch::Matchers::EndsWith("list.txt.gz: the file is compressed by gzip; unpack it first"));
}

}  // namespace gvd::test_read_generators
