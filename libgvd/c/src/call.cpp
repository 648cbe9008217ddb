// Calls operations by name, with options as JSON, and gives access to the parts of their results.

#include <fmt/format.h>

#include <array>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gvd/mesh_objects.hpp"
#include "gvd/operation.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"
#include "handles.hpp"

namespace {

using namespace gvd;
using namespace gvd::c;

using Json = nlohmann::ordered_json;

/// Refuses an unknown name, and suggests the known name that may be meant.
template <class Named, class NameOf>
[[noreturn]] void refuse_name(const char* kind, const char* name, const Named& known, const NameOf& name_of) {
  std::vector<std::string> names;
  for (const auto& one : known) names.emplace_back(std::invoke(name_of, one));
  const auto meant = suggest_name(name, names);
  refuse(fmt::format("there is no {} {}{}", kind, gvd::quoted(name),
                     meant ? fmt::format("; did you mean '{}'?", *meant) : ""));
}

const Operation& find(const char* name) {
  const Operation* const found = find_operation(&given(name, "operation"));
  if (found == nullptr) refuse_name("operation", name, operations(), &Operation::name);
  return *found;
}

std::vector<ArrayView> to_views(const gvd_array* arrays, std::int32_t count) {
  if (count < 0) refuse(fmt::format("count is {}; give 0 or more", count));
  std::vector<ArrayView> views;
  for (std::int32_t i = 0; i < count; ++i) {
    const gvd_array& array = (&given(arrays, "arrays"))[i];
    views.push_back({array.data,
                     static_cast<ArrayType>(array.type),
                     array.dimensions,
                     {array.shape[0], array.shape[1]},
                     {array.strides[0], array.strides[1]}});
  }
  return views;
}

void read_file_options(FileOptions& how, const char* options, const gvd_run* run) {
  how.threads = run == nullptr ? 0 : run->threads;
  OptionList list;
  describe(list, how);
  read_json_options(list, {}, options == nullptr ? "{}" : options, {});
}

}  // namespace

std::unique_ptr<gvd_object> gvd::c::call(const char* name, const gvd_object* on, const std::string& options,
                                         std::span<const ArrayView> arrays, const gvd_run* run) {
  const Operation& operation = find(name);
  static const MeshPtr kNoMesh = std::make_shared<CheckedMesh>();
  const bool takes_object = !operation.on.empty();
  const auto object = takes_object ? given(on, "the object").object : nullptr;
  const MeshPtr& mesh = takes_object ? mesh_of(operation, *object) : kNoMesh;
  CallObserver observer(run);
  const auto call = operation.call();
  OptionList list;
  call->describe(list);
  call->take(arrays);
  const Given names = read_json_options(list, *mesh, options, arrays);
  auto made = [&] {
    try {
      return std::make_unique<gvd_object>(call->run(object, observer), observer.door());
    } catch (const Error& error) {
      throw Error(error.code(), spell_for(observer.door(), error.text(), list, names), error.element());
    }
  }();
  Json more{{"options", Json::parse(options_json(list, names, observer.door()))},
            {"notes", observer.notes()},
            {"warnings", observer.warnings()}};
  made->told = more.dump(-1, ' ', false, Json::error_handler_t::replace);
  return made;
}

gvd_status gvd_call(int32_t abi, const char* name, const gvd_object* on, const char* options, const gvd_array* arrays,
                    int32_t count, const gvd_run* run, gvd_object** result) {
  return guarded_for(run, [&] {
    if (abi != GVD_ABI) {
      refuse(
          fmt::format("this program was compiled for interface {}, and the library has {}: compile it with the "
                      "library's gvd.h",
                      abi, GVD_ABI));
    }
    find(name);
    given(result, "result");
    *result = call(name, on, options == nullptr ? "{}" : options, to_views(arrays, count), run).release();
  });
}

gvd_status gvd_array_of(const gvd_object* object, const char* name, gvd_array* view) {
  return guarded([&] {
    const auto& arrays = given(object, "object").views().arrays;
    const auto found = arrays.find(std::string_view(&given(name, "name")));
    if (found == arrays.end()) refuse_name("array", name, arrays, [](const auto& one) { return one.first; });
    const ArrayView of = found->second();
    given(view, "view") = {of.data,
                           static_cast<gvd_type>(of.type),
                           of.dimensions,
                           {of.shape[0], of.shape[1]},
                           {of.strides[0], of.strides[1]}};
  });
}

gvd_status gvd_object_of(const gvd_object* object, const char* name, gvd_object** part) {
  return guarded([&] {
    const auto& parts = given(object, "object").views().parts;
    const auto found = parts.find(std::string_view(&given(name, "name")));
    if (found == parts.end()) refuse_name("part", name, parts, [](const auto& one) { return one.first; });
    auto made = found->second.make();
    if (made == nullptr) refuse(fmt::format("there is no {} here: {}", name, found->second.text));
    given(part, "part") = new gvd_object(std::move(made), object->door);
  });
}

const char* gvd_figures(const gvd_object* object) {
  return answered("null", [&] { return given(object, "object").figures().c_str(); });
}

const char* gvd_describe(void) { return gvd_describe_for(GVD_JSON); }

const char* gvd_describe_for(int32_t door) {
  return answered("null", [&] {
    const auto text = [](Door of) {
      Json described{{"abi", GVD_ABI}};
      described.update(Json::parse(describe_operations(of)));
      return described.dump();
    };
    static const std::array kTexts{text(Door::json), text(Door::python), text(Door::javascript)};
    if (door < 0 || std::size_t(door) >= kTexts.size()) refuse(fmt::format("there is no door {}", door));
    return kTexts[std::size_t(door)].c_str();
  });
}

gvd_status gvd_write(const gvd_object* object, const char* path, const gvd_run* run) {
  return gvd_write_as(object, path, nullptr, run);
}

gvd_status gvd_write_as(const gvd_object* object, const char* path, const char* options, const gvd_run* run) {
  return guarded_for(run, [&] {
    const Object& written = *given(object, "object").object;
    const std::string name = given_path(path);
    CallObserver observer(run);
    FileOptions how;
    read_file_options(how, options, run);
    write_object(name, written, how, progress_of(observer));
  });
}

gvd_status gvd_file_of(const gvd_object* object, const char* format, const char* options, const gvd_run* run,
                       gvd_object** file) {
  return guarded_for(run, [&] {
    const Object& written = *given(object, "object").object;
    given(file, "file");
    FileOptions how;
    read_file_options(how, options, run);
    auto visit = [bytes = file_bytes(&given(format, "format"), written, how)](ObjectVisitor& visitor) {
      visitor.array({"bytes", "", "of the file"}, {bytes.data(), ArrayType::uint8, 1, {std::ssize(bytes), 1}, {1, 0}});
    };
    *file = new gvd_object(std::make_shared<PlainObject>("file", std::move(visit)));
  });
}

void gvd_release(gvd_object* object) { delete object; }
