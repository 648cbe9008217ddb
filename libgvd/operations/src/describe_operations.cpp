// Describes everything that can be called as JSON: operations with their options and results, formats and error codes.

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "gvd/io/format.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/operation.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/option_text.hpp"
#include "gvd/version.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kTypeNames{"int8",   "uint8", "int16",  "uint16",  "int32",
                                "uint32", "int64", "uint64", "float32", "float64"};

constexpr std::array kFigureKinds{
    "none",          "flag",  "whole number",           "number",           "text", "numbers",
    "whole numbers", "texts", "lists of whole numbers", "lists of numbers", "flags"};
static_assert(kFigureKinds.size() == std::variant_size_v<Figure>);

Json describe_meaning(const Meaning& meaning) {
  return {
      {"name", meaning.name}, {"unit", meaning.unit.empty() ? Json() : Json(meaning.unit)}, {"meaning", meaning.text}};
}

/// Describes the parts of an object, and recursively the parts of these, by their kinds.
class Describer : public ObjectVisitor {
 public:
  void figure(const Meaning& meaning, const Figure& value) override {
    Json& one = kind_["figures"].emplace_back(describe_meaning(meaning));
    if (value.index() > 0) one["kind"] = kFigureKinds[value.index()];
  }
  void array(const Meaning& meaning, const ArrayView& view) override {
    Json& one = kind_["arrays"].emplace_back(describe_meaning(meaning));
    one["type"] = kTypeNames[std::size_t(view.type)];
    const std::int64_t columns = view.dimensions == 1 ? 1 : view.shape[1];
    one["columns"] = columns > 0 ? Json(columns) : Json();  // null: any number
  }
  void points(const Meaning& meaning, const PointsView& points) override {
    const std::string name(meaning.name), text(meaning.text);
    array({name + "_faces", "", text + ": faces"}, points.faces());
    array({name + "_bary", "", text + ": barycentric coordinates"}, points.bary());
  }
  void curves(const Meaning& meaning, const PointLists&) override {
    offsets(meaning, "index of each list's first point, and the total number of points");
    points(meaning, std::vector<SurfacePoint>());
  }
  void lists(const Meaning& meaning, const GeneratorLists&) override {
    offsets(meaning, "index of each list's first number, and the total count");
    array(meaning, view(std::vector<GeneratorId>()));
  }
  void table(const Meaning& meaning, const Table& table) override {
    Json& one = kind_["tables"].emplace_back(describe_meaning(meaning));
    for (const Column& column : table) one["columns"].push_back(column.name);
  }
  void part(const Meaning& meaning, std::string_view kind, const PartMaker&) override {
    kind_["parts"].emplace_back(describe_meaning(meaning))["kind"] = kind;
  }
  Json take() { return std::move(kind_); }

 private:
  void offsets(const Meaning& meaning, const char* text) {
    array({std::string(meaning.name) + "_offsets", "", text}, view(std::vector<std::int64_t>()));
  }

  Json kind_{
      {"figures", Json::array()}, {"tables", Json::array()}, {"arrays", Json::array()}, {"parts", Json::array()}};
};

Json describe_object(const Object& object) {
  Describer describer;
  object.visit(describer);
  return describer.take();
}

/// Adds the texts about an option for users of the door.
void describe_words(Json& one, const Option& option, Door door) {
  const Spec& spec = option.spec;
  one["unit"] = spec.unit.empty() ? Json() : Json(spec.unit);
  one["default"] = Json::parse(value_json(option.field));
  const bool is_plain = spec.usual.empty() || spec.usual == default_text(option.field);
  one["usual"] = is_plain ? Json() : Json(spell_for(door, spec.usual));
  const bool has_own = !spec.arrays.empty();
  one["summary"] = spell_for(door, has_own ? spec.arrays : spec.help);
  one["help"] = spell_for(door, has_own ? spec.arrays : spec.help + spec.more);
  one["also"] = Json::array();  // other words for which a hint names this option
  for (const std::string& word : {spec.short_name, spec.also}) {
    if (!word.empty()) one["also"].push_back(word);
  }
}

Json describe_options(const OptionList& list, Door door) {
  Json all = Json::array();
  for (const Option* const option : list.options()) {
    Json& one = all.emplace_back(Json{{"name", option->name}});
    one.update(Json::parse(kind_json(option->field)));
    if (std::holds_alternative<PointList>(option->field) && one["kind"] != "vertices") {
      one["kind"] = "points";  // programs pass no files
    }
    if (const auto* const values = std::get_if<ValueSource>(&option->field)) {
      one["of"] = values->of == ValueSource::Of::generators ? "generators" : "vertices or faces";
    }
    describe_words(one, *option, door);
    Json& excluded = one["excludes"] = Json::array();
    for (const Option* const other : list.options()) {
      if (list.exclude_each_other(option->name, other->name)) excluded.push_back(other->name);
    }
    one["needs"] = list.needed_by(option->name);
  }
  return all;
}

Json describe_formats() {
  Json all = Json::array();
  for (const Format& format : formats()) {
    Json& one =
        all.emplace_back(Json{{"name", format.name}, {"title", format.title.empty() ? Json() : Json(format.title)}});
    one["extensions"] = format.extensions;
    one["input_extensions"] = format.input_extensions;
    one["is_read"] = format.read != nullptr;
    one["is_written"] = format.is_output();
    one["is_binary"] = format.is_binary;
    Json& carries = one["carries"] = Json::array();
    for (const auto& [name, content] : kContentNames) {
      if (has_any(format.carries, content)) carries.push_back(name);
    }
  }
  return all;
}

}  // namespace

std::string formats_json() { return describe_formats().dump(); }

std::string describe_operations(Door door) {
  Json described{{"version", version()}, {"operations", Json::array()}, {"objects", Json::object()}};
  for (const Operation& operation : operations()) {
    const auto call = operation.call();
    OptionList list;
    call->describe(list);
    described["operations"].push_back({{"name", operation.name},
                                       {"summary", operation.summary},
                                       {"on", operation.on.empty() ? Json() : Json(operation.on)},
                                       {"options", describe_options(list, door)},
                                       {"result", describe_object(*operation.no_result())}});
  }
  described["objects"]["mesh"] = describe_object(MeshObject());
  described["objects"]["diagram"] = describe_object(DiagramObject());
  FileOptions files;
  OptionList list;
  describe(list, files);
  described["file_options"] = describe_options(list, door);
  described["formats"] = describe_formats();
  return described.dump();
}

}  // namespace gvd
