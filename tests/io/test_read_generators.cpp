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
  CHECK(refused("1\n2 two 3\n") == "list:2: 'two' is no number");
  CHECK(refused("1\n\n2.5x") == "list:3: '2.5x' is no number");
  CHECK(refused("1;2") == "list:1: '1;2' is no number");
  CHECK(refused("1e999") == "list:1: '1e999' is no number");
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
