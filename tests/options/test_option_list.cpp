// What belongs to a list of options: their order, defaults, and which of them go together.

#include "gvd/option_list.hpp"
#include "options/toy_options.hpp"
#include "support/catch.hpp"

namespace gvd::test_option_list {

using test::Toy;

Given given(const std::vector<std::string>& names) {
  Given made;
  for (const std::string& name : names) made.add(name, {"--" + name, ""});
  return made;
}

std::string problem(const std::vector<std::string>& names) {
  const Toy toy;
  const auto found = toy.list.find_problem(given(names));
  return found ? found->option + ": " + found->text : "";
}

TEST_CASE("options come in the order of their groups, and a group goes on where it is named again") {
  bool a = false, b = false, c = false;
  OptionList list;
  list.group("One");
  list.option("a", Flag{&a}, {.help = "A"});
  list.group("Two");
  list.option("b", Flag{&b}, {.help = "B"});
  list.group("One");
  list.option("c", Flag{&c}, {.help = "C"});
  std::string names;
  for (const Option* const option : list.options()) names += option->name;
  CHECK(names == "acb");
  CHECK(list.groups() == std::vector<std::string>{"One", "Two"});
  CHECK(list.find("b")->group == "Two");
  CHECK(list.find("d") == nullptr);
}

TEST_CASE("a default is the value that the field has when it is described, unless words say it") {
  Toy toy;
  const auto usual = [&](const char* name) { return toy.list.find(name)->spec.usual; };
  CHECK(usual("step") == "0.5");
  CHECK(usual("colour") == "green");
  CHECK(usual("output_format") == "ply");
  CHECK(usual("features") == "none");
  CHECK(usual("relax") == "15");
  for (const char* none : {"count", "front", "cut", "output", "curves", "memory"}) {
    CAPTURE(none);
    CHECK(usual(none).empty());
  }
  CHECK(toy.list.find("refine")->is_on);
  CHECK(!toy.list.find("cut")->is_on);
}

TEST_CASE("every field goes back to its default") {
  Toy toy;
  toy.options.step = 1;
  toy.options.colour = test::Colour::red;
  toy.options.front = test::Colour::red;
  toy.options.from.file = "a";
  toy.options.vertices.vertices = {1};
  toy.options.angle = 3;
  toy.options.auto_angle = true;
  toy.options.unnamed_page = true;
  toy.options.formats = {};
  for (const Option* const option : toy.list.options()) option->reset();
  CHECK(toy.options.step == 0.5);
  CHECK(toy.options.colour == test::Colour::green);
  CHECK(!toy.options.front);
  CHECK(toy.options.from.file.empty());
  CHECK(!toy.options.vertices.is_given());
  CHECK(!toy.options.angle);
  CHECK(!toy.options.auto_angle);
  CHECK(!toy.options.unnamed_page);
  CHECK(toy.options.formats == std::vector<std::string>{"ply"});
}

TEST_CASE("options that exclude or need others are told in words that name both") {
  CHECK(problem({"count", "seed"}).empty());
  CHECK(problem({"count", "radius"}) == "radius: \1count\2 and \1radius\2 exclude each other: keep one");
  CHECK(problem({"seed", "vertices"}) == "vertices: \1seed\2 and \1vertices\2 exclude each other: keep one");
  CHECK(problem({"cut"}) == "cut: \1cut\2 needs \1table\2: add it, or leave \1cut\2 out");
  CHECK(problem({"cut", "table"}).empty());
}

TEST_CASE("of two options that exclude each other, the later one is to blame") {
  const Toy toy;
  Given both = given({"radius"});
  both.add("count", {"n", "o.toml:1:1"});
  CHECK(toy.list.find_problem(both)->option == "count");
}

TEST_CASE("an option that does nothing beside a value is told only where it is given") {
  Toy toy;
  CHECK(!toy.list.find_problem(given({"front"})));
  toy.options.colour = test::Colour::red;
  CHECK(!toy.list.find_problem(given({})));
  CHECK(toy.list.find_problem(given({"front"}))->option == "front");
  CHECK(!toy.list.why_idle(*toy.list.find("front"), given({})).empty());
  CHECK(toy.list.why_idle(*toy.list.find("count"), given({})).empty());
}

TEST_CASE("where one of several options is to be given, all are named") {
  const Toy toy;
  CHECK(toy.list.find_missing(given({}))->text == "no numbers: give one of \1count\2, \1radius\2 or \1vertices\2");
  CHECK(!toy.list.find_missing(given({"radius"})));
}

TEST_CASE("a name in a rule or a text that is no option is found") {
  CHECK(Toy().list.find_unknown_names().empty());
  Toy toy;
  toy.list.excludes("cut", {"nothing"});
  toy.list.needs("none", "cut");
  toy.list.rule({"front", {"nobody"}, [](const Given&) { return ""; }});
  bool flag = false;
  toy.list.option("last", Flag{&flag}, {.help = "As \1nowhere=3\2"});
  CHECK(toy.list.find_unknown_names() == std::vector<std::string>{"nobody", "none", "nothing", "nowhere"});
}

}  // namespace gvd::test_option_list
