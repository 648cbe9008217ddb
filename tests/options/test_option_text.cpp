// Values of options as texts: what each kind takes, refuses and shows.

#include <clocale>

#include "gvd/option_text.hpp"
#include "options/toy_options.hpp"
#include "support/catch.hpp"

namespace gvd::test_option_text {

using Catch::Matchers::Contains;
using test::Toy;
using Texts = std::vector<std::string>;

std::string read(Toy& toy, const char* name, const Texts& texts) { return read_option(*toy.list.find(name), texts); }

std::string refusal(const char* name, const Texts& texts) {
  Toy toy;
  return read(toy, name, texts);
}

TEST_CASE("each kind stores its value") {
  Toy toy;
  test::ToyOptions& o = toy.options;
  const auto take = [&](const char* name, const Texts& texts) {
    CAPTURE(name);
    CHECK(read(toy, name, texts).empty());
  };
  take("input", {"a.obj", "b.obj"});
  CHECK(o.inputs == Texts{"a.obj", "b.obj"});
  take("count", {"010"});
  CHECK(o.count == 10);
  take("relax", {"none"});
  CHECK(o.relax == 0);
  take("seed", {"18446744073709551615"});
  CHECK(o.seed == 18446744073709551615u);
  take("faces", {"1000000000"});
  CHECK(o.faces == 1000000000);
  take("step", {"1.5"});
  CHECK(o.step == 1.5);
  take("radius", {"2.5e-1"});
  CHECK(o.radius == 0.25);
  take("cut", {});
  CHECK(o.cut);
  take("refine", {"false"});
  CHECK(!o.refine);
  take("relocate", {"off"});
  CHECK(o.relocate == false);
  take("colour", {"red"});
  CHECK(o.colour == test::Colour::red);
  take("front", {"green"});
  CHECK(o.front == test::Colour::green);
  take("output_format", {"obj,json", "ply"});
  CHECK(o.formats == Texts{"obj", "json", "ply"});
  take("table", {"a.CSV"});
  CHECK(o.table == "a.CSV");
  take("folder", {"out"});
  CHECK(o.folder == "out");
  take("levels", {"10, 100", "1000"});
  CHECK(o.levels == std::vector<std::int32_t>{10, 100, 1000});
  take("density", {"area"});
  CHECK(o.density.name == "area");
  take("curves", {"creases:30"});
  CHECK(o.curves.name == "creases:30");
}

TEST_CASE("a name that may stand alone has a value of its own") {
  Toy toy;
  CHECK(read(toy, "weld", {}).empty());
  CHECK(toy.options.weld == 0.0);
  CHECK(read(toy, "weld", {"0.5"}).empty());
  CHECK(toy.options.weld == 0.5);
  CHECK(read(toy, "weld", {"true"}).empty());
  CHECK(toy.options.weld == 0.0);
  CHECK(read(toy, "page", {}).empty());
  CHECK((toy.options.unnamed_page && toy.options.page.empty()));
  CHECK(read(toy, "page", {"a.html"}).empty());
  CHECK((!toy.options.unnamed_page && toy.options.page == "a.html"));
  CHECK(read(toy, "page", {""}).empty());
  CHECK((toy.options.unnamed_page && toy.options.page.empty()));
}

TEST_CASE("points are vertices or a file") {
  Toy toy;
  CHECK(read(toy, "from", {"3, 17", "99"}).empty());
  CHECK(toy.options.from.vertices == std::vector<std::int64_t>{3, 17, 99});
  CHECK(read(toy, "from", {"seeds.txt"}).empty());
  CHECK(toy.options.from.file == "seeds.txt");
  CHECK(!toy.options.from.vertices);
  CHECK(refusal("from", {"-1"}) == "'-1' is not a vertex index; write indices from 0, as in 3,17,99");
  CHECK(refusal("from", {"1", "a.txt"}) == "'a.txt': give vertices or one file");
  CHECK(refusal("from", {""}) == "the list is empty; write vertices, as in 3,17,99, or name a file");
  for (const char* wrong : {"", ",", "1,", "1,,2", "-1", "1.0", "0x1", "9223372036854775808"}) {
    CAPTURE(wrong);
    CHECK_THAT(refusal("vertices", {wrong}), Contains("is not a vertex index; write indices from 0"));
  }
}

TEST_CASE("angles and distances have words of their own") {
  Toy toy;
  CHECK(read(toy, "features", {"auto"}).empty());
  CHECK((toy.options.auto_angle && toy.options.angle == 40.0));
  CHECK(read(toy, "features", {"30"}).empty());
  CHECK((!toy.options.auto_angle && toy.options.angle == 30.0));
  CHECK(read(toy, "features", {"none"}).empty());
  CHECK(!toy.options.angle);
  CHECK(refusal("features", {"0"}) == "'0' is not a number above 0 and at most 180 or 'auto' or 'none'");
  CHECK(read(toy, "error", {"0.5%"}).empty());
  CHECK((toy.options.error->in_diagonals && toy.options.error->value == 0.005));
  CHECK(read(toy, "error", {"2"}).empty());
  CHECK((!toy.options.error->in_diagonals && toy.options.error->value == 2));
  CHECK(refusal("error", {"%"}) == "'%' is neither a finite number above 0 nor one with a %");
  CHECK(parse_creases("creases", 40) == 40.0);
  CHECK(parse_creases("creases:12.5", 40) == 12.5);
  for (const char* wrong : {"creases:", "creases:0", "creases:180", "crease", "boundary"}) {
    CHECK(!parse_creases(wrong, 40));
  }
}

TEST_CASE("what is wrong is said with what is expected, and the field stays") {
  CHECK(refusal("count", {"0"}) == "'0' is not a whole number from 1 to 2147483647");
  CHECK(refusal("count", {"2.5"}) == "'2.5' is not a whole number from 1 to 2147483647");
  CHECK(refusal("relax", {"some"}) == "'some' is not a whole number from 0 to 99 or 'none'");
  CHECK(refusal("seed", {"-1"}) == "'-1' is not a whole number from 0 to 2^64 - 1");
  CHECK(refusal("faces", {"3"}) == "'3' is not a whole number from 4 to 1000000000");
  CHECK(refusal("step", {"2"}) == "'2' is not a number above 0 and below 2");
  CHECK(refusal("step", {"0"}) == "'0' is not a number above 0 and below 2");
  for (const char* wrong : {"nan", "inf", "1,5", "-1", "0", "", " 1", "+1", "0x10", "1e999"}) {
    CAPTURE(wrong);
    CHECK_THAT(refusal("radius", {wrong}), Contains("is not a finite number above 0"));
  }
  CHECK_THAT(refusal("weld", {"x"}), Contains("'x' is not a finite number from 0 on"));
  CHECK(refusal("colour", {"gren"}) == "'gren' is not one of red|green; did you mean green?");
  CHECK(refusal("relocate", {"maybe"}) == "'maybe' is not one of on|off");
  CHECK(refusal("cut", {"maybe"}) == "'maybe' is neither true nor false");
  CHECK(refusal("output_format", {"ply,pyl"}) == "'pyl' is not one of ply|obj|json; did you mean ply?");
  CHECK(refusal("output_format", {"ply", "ply"}) == "ply is given twice; keep one");
  CHECK(refusal("table", {"a.txt"}) == "'a.txt': the extension must be .csv");
  CHECK(refusal("page", {"a.csv"}) == "'a.csv': the extension must be one of .html, .htm");
  CHECK(refusal("table", {".csv"}) == "'.csv': the extension must be .csv");
  CHECK(refusal("folder", {""}) == "the name is empty; name a folder");
  CHECK(refusal("curves", {"creases:400"}) ==
        "'creases:400': write an angle above 0 and below 180 degrees, as in creases:30");
  CHECK(refusal("levels", {"10,5"}) == "5 follows 10; write ascending numbers, as in 10,100,1000");
  CHECK(refusal("levels", {"x"}) == "'x' is not a whole number from 1 to 2147483647");
  CHECK(refusal("density", {""}) == "the name is empty; name a file");
  CHECK(refusal("count", {"1", "2"}) == "given twice; keep one");
  CHECK(refusal("count", {}) == "its value is missing; write \1count=N\2");
  CHECK_THAT(refusal("table", {std::string(500, 'x') + "\n"}), Contains("xxx...': the extension"));
  Toy toy;
  read(toy, "step", {"7"});
  CHECK(toy.options.step == 0.5);
}

TEST_CASE("a file that is no regular one may have any name") {
  CHECK(refusal("table", {"/dev/null"}).empty());
  CHECK(refusal("table", {"-"}).empty());
}

std::optional<std::int64_t> bytes_of(const std::string& text) {
  Toy toy;
  return read(toy, "memory", {text}).empty() ? toy.options.memory : std::nullopt;
}

TEST_CASE("sizes have binary units, in any spelling") {
  CHECK(bytes_of("1") == 1);
  CHECK(bytes_of("500K") == 500 * 1024);
  CHECK(bytes_of("500m") == 500LL << 20);
  CHECK(bytes_of("2G") == 2LL << 30);
  CHECK(bytes_of("1.5GiB") == 3LL << 29);
  CHECK(bytes_of("3TB") == 3LL << 40);
  CHECK(bytes_of("7b") == 7);
  CHECK(bytes_of("1048576T") == std::int64_t{1} << 60);
  for (const char* text : {"", "G", "B", "1X", "1 G", "1GG", "1i", "nan", "inf", "G1", "1e", "infK"}) {
    CAPTURE(text);
    CHECK_THAT(refusal("memory", {text}),
               Contains("is not a size; write a number with K, M, G or T, such as 500M or 2G"));
  }
  for (const char* text : {"1e30", "1e999", "1048577T", "99999999999999999999"}) {
    CAPTURE(text);
    CHECK_THAT(refusal("memory", {text}), Contains("is too large; write at most 1048576T"));
  }
  for (const char* text : {"0", "0.2", "-1G", "1e-999"}) {
    CAPTURE(text);
    CHECK_THAT(refusal("memory", {text}), Contains("is less than a byte"));
  }
}

TEST_CASE("numbers are the same in any locale") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(refusal("radius", {"1.5"}).empty());
  CHECK(!refusal("radius", {"1,5"}).empty());
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("what an option takes is named as help shows it") {
  const Toy toy;
  const auto shown = [&](const char* name) { return value_name(toy.list.find(name)->field); };
  CHECK(shown("cut").empty());
  CHECK(shown("relocate") == "on|off");
  CHECK(shown("count") == "N");
  CHECK(shown("relax") == "N|none");
  CHECK(shown("radius") == "NUMBER");
  CHECK(shown("weld") == "[NUMBER]");
  CHECK(shown("colour") == "red|green");
  CHECK(shown("output_format") == "ply|obj|json");
  CHECK(shown("output") == "FILE");
  CHECK(shown("table") == "FILE.csv");
  CHECK(shown("page") == "FILE.html|htm");
  CHECK(shown("folder") == "DIR");
  CHECK(shown("input") == "FILE");
  CHECK(shown("vertices") == "LIST");
  CHECK(shown("levels") == "LIST");
  CHECK(shown("density") == "area|FILE|PROPERTY");
  CHECK(shown("memory") == "SIZE");
  CHECK(shown("error") == "NUMBER[%]");
  CHECK(shown("features") == "auto|none|ANGLE");
}

TEST_CASE("what is written is read again as the same value") {
  for (const auto& [name, texts] : std::vector<std::pair<const char*, Texts>>{{"count", {"7"}},
                                                                              {"relax", {"none"}},
                                                                              {"step", {"0.1"}},
                                                                              {"cut", {"true"}},
                                                                              {"refine", {"false"}},
                                                                              {"relocate", {"off"}},
                                                                              {"colour", {"red"}},
                                                                              {"output_format", {"obj", "json"}},
                                                                              {"output", {"a.ply", "-"}},
                                                                              {"from", {"3,17"}},
                                                                              {"from", {"a.txt"}},
                                                                              {"levels", {"1,20"}},
                                                                              {"memory", {"1024"}},
                                                                              {"error", {"3%"}},
                                                                              {"features", {"auto"}},
                                                                              {"features", {"none"}},
                                                                              {"features", {"12.5"}}}) {
    CAPTURE(name);
    Toy toy;
    CHECK(read(toy, name, texts).empty());
    CHECK(write_option(toy.list.find(name)->field) == texts);
  }
  const Toy toy;
  for (const char* none : {"count", "front", "output", "vertices", "curves", "memory"}) {
    CAPTURE(none);
    CHECK(!write_option(toy.list.find(none)->field));
  }
}

TEST_CASE("texts of the user's are printable and short in messages, and keep their letters whole") {
  CHECK(user_text("-n") == "-n");
  CHECK(user_text(std::string("a\n\0\x1b", 4) + "\x7f") == "a    ");
  CHECK(user_text(std::string(61, 'a')) == std::string(60, 'a') + "...");
  CHECK(user_text("k\u00e4se", 3) == "k\u00e4...");
  CHECK(user_text("k\u00e4se", 2) == "k...");
}

}  // namespace gvd::test_option_text
