// What a misspelt name may have been meant for.

#include "gvd/option_text.hpp"
#include "support/catch.hpp"

namespace gvd::test_suggest_name {

const std::vector<std::string> kNames{"-n",     "--count", "--sampling",      "--seed",   "--generators",
                                      "--view", "-o",      "--output-format", "--output", "--radius",
                                      "--cut",  "-h",      "--help",          "--method", "--threads"};

TEST_CASE("a misspelt option is told from few letters that differ") {
  CHECK(suggest_name("--smapling", kNames) == "--sampling");  // a swap
  CHECK(suggest_name("--samplin", kNames) == "--sampling");
  CHECK(suggest_name("--samplings", kNames) == "--sampling");
  CHECK(suggest_name("--sanplimg=random", kNames) == "--sampling");
  CHECK(suggest_name("-sampling", kNames) == "--sampling");
  CHECK(suggest_name("--generater", kNames) == "--generators");
  CHECK(suggest_name("--cat", kNames) == "--cut");
  CHECK(suggest_name("--n", kNames) == "-n");
}

TEST_CASE("the beginning of an option stands for the shortest that begins so") {
  CHECK(suggest_name("--out", kNames) == "--output");
  CHECK(suggest_name("--gen", kNames) == "--generators");
  CHECK(suggest_name("--output-f", kNames) == "--output-format");
}

TEST_CASE("beginnings of an option's words stand for it, with dashes between them or not") {
  CHECK(suggest_name("--out-f", kNames) == "--output-format");
  CHECK(suggest_name("--outform", kNames) == "--output-format");
  CHECK(suggest_name("--outputformat", kNames) == "--output-format");
  CHECK(!suggest_name("--format", kNames));
}

TEST_CASE("capitals do not count, and the same name goes before a longer one") {
  CHECK(suggest_name("--OUTPUT", kNames) == "--output");
  CHECK(suggest_name("--Samplign", kNames) == "--sampling");
  CHECK(suggest_name("-N", kNames) == "-n");
}

TEST_CASE("the name of what is not an option is known from its first letter on") {
  std::vector<std::string> names = kNames;
  names.insert(names.end(), {"INPUT", "--input-format"});
  for (const char* wrong : {"-i", "--in", "--input", "--Input", "--input=a.obj"}) {
    CAPTURE(wrong);
    CHECK(suggest_name(wrong, names) == "INPUT");
  }
  CHECK(suggest_name("--input-f", names) == "--input-format");
}

TEST_CASE("what is like no option gets no suggestion") {
  for (const char* wrong : {"--nonsense", "--x", "-x", "-", "--", "--=3", "--qq"}) {
    CAPTURE(wrong);
    CHECK(!suggest_name(wrong, kNames));
  }
  CHECK(!suggest_name("--seed", {}));
  CHECK(!suggest_name(std::string(1 << 24, 's'), kNames));  // at once
}

}  // namespace gvd::test_suggest_name
