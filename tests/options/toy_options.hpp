#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "gvd/option_list.hpp"

namespace gvd::test {

enum class Colour { red, green };
inline const Choices<Colour> kColours{{"red", Colour::red}, {"green", Colour::green}};

/// A field of each kind.
struct ToyOptions {
  std::vector<std::string> inputs, outputs, formats{"ply"};
  bool cut = false, refine = true;
  std::optional<bool> relocate;
  std::optional<std::int32_t> count, relax;
  std::uint64_t seed = 0;
  std::int64_t faces = 4;
  double step = 0.5;
  std::optional<double> radius, weld, angle;
  bool auto_angle = false;
  Colour colour = Colour::green;
  std::optional<Colour> front;
  std::string table, page, folder;
  GivenCurves curves;
  GivenNumbers density;
  bool unnamed_page = false;
  GivenPoints vertices, from;
  std::vector<std::int32_t> levels;
  std::optional<std::int64_t> memory;
  std::optional<ErrorBound> error;
};

/// Describes them all, with rules of each sort.
inline void describe(OptionList& list, ToyOptions& toy) {
  list.group("Input");
  list.option("input", File{&toy.inputs, File::Use::read, {"obj"}},
              {.help = "The mesh", .shown = Shown::main, .positional = true, .required = true});
  list.group("Numbers (one of \1count\2 and \1radius\2)");
  list.option("count", Number{&toy.count, {.least = 1}},
              {.help = "A count", .more = "; of \1input\2", .short_name = "n", .shown = Shown::main});
  list.option("relax", Number{&toy.relax, {.least = 0, .most = 99}, {{"none", 0}}},
              {.help = "Iterations", .usual = "15"});
  list.option("seed", Number{&toy.seed}, {.help = "A seed"});
  list.option("faces", Number{&toy.faces, {.least = 4, .most = 1e9}}, {.help = "Faces"});
  list.option("step", Number{&toy.step, {.least = 0, .most = 2, .above_least = true, .below_most = true}},
              {.help = "A step"});
  list.option("radius", Number{&toy.radius, above(0)}, {.help = "A radius", .unit = "mesh units"});
  list.option("weld", Number{&toy.weld, {.least = 0}, {}, 0}, {.help = "A tolerance"});
  list.group("Output");
  list.option("output", File{&toy.outputs, File::Use::write, {"ply", "obj"}}, {.help = "Files", .short_name = "o"});
  list.option("output_format", ChoiceList{&toy.formats, {"ply", "obj", "json"}}, {.help = "Formats"});
  list.option("table", File{&toy.table, File::Use::write, {"csv"}}, {.help = "A table"});
  list.option("page", File{&toy.page, File::Use::write, {"html", "htm"}, &toy.unnamed_page}, {.help = "A page"});
  list.option("folder", File{&toy.folder, File::Use::folder}, {.help = "A folder"});
  list.group("Others");
  list.option("cut", Flag{&toy.cut}, {.help = "Cut"});
  list.option("refine", Flag{&toy.refine}, {.help = "Add nothing"});
  list.option("relocate", Switch{&toy.relocate}, {.help = "Relocate"});
  list.option("colour", choice(toy.colour, kColours), {.help = "A colour"});
  list.option("front", choice(toy.front, kColours), {.help = "A front"});
  list.option("vertices", PointList{&toy.vertices, PointList::Named::vertices}, {.help = "Vertices"});
  list.option("from", PointList{&toy.from}, {.help = "Points"});
  list.option("curves", Curves{&toy.curves, 40}, {.help = "Curves"});
  list.option("levels", Counts{&toy.levels}, {.help = "Levels"});
  list.option("density", ValueSource{&toy.density, {"area"}}, {.help = "Numbers"});
  list.option("memory", ByteSize{&toy.memory}, {.help = "Bytes"});
  list.option("error", SizeOrPercent{&toy.error}, {.help = "A distance"});
  list.option("features", CreaseAngle{&toy.angle, &toy.auto_angle, 40}, {.help = "An angle"});
  list.one_of({{"count", "radius", "vertices"}, "no numbers"});
  list.excludes("seed", {"vertices"});
  list.needs("cut", "table");
  list.rule({"front", {"colour"}, [&toy](const Given&) -> std::string {
               return toy.colour == Colour::green
                          ? ""
                          : "\1front\2 has no effect here: add \1colour=green\2, or leave \1front\2 out";
             }});
}

/// The options of a toy command, described.
struct Toy {
  Toy() { describe(list, options); }
  ToyOptions options;
  OptionList list;
};

}  // namespace gvd::test
