#pragma once

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bound_calls.hpp"
#include "bound_results.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// Values of JavaScript and of the library: typed arrays, points of a mesh, options by their names, and errors.
namespace gvd::web {

using emscripten::val;

/// A typed array that owns a copy of `count` numbers. Ids are 32-bit integers, -1 for none.
template <class Number>
val copy_numbers(const Number* first, std::size_t count) {
  return val(emscripten::typed_memory_view(count, first)).call<val>("slice");
}
inline val to_array(const std::vector<double>& values) { return copy_numbers(values.data(), values.size()); }
inline val to_array(const std::vector<float>& values) { return copy_numbers(values.data(), values.size()); }
inline val to_array(const std::vector<std::int32_t>& values) { return copy_numbers(values.data(), values.size()); }
template <int N>
val to_array(const std::vector<Eigen::Matrix<double, N, 1>>& values) {
  return copy_numbers(values.empty() ? nullptr : values[0].data(), N * values.size());
}
template <std::size_t N>
val to_array(const std::vector<std::array<double, N>>& values) {
  return copy_numbers(values.empty() ? nullptr : values[0].data(), N * values.size());
}
inline val to_array(const std::vector<std::array<VertexId, 3>>& faces) {
  return copy_numbers(reinterpret_cast<const std::int32_t*>(faces.data()), 3 * faces.size());
}
template <class Tag>
val to_array(const std::vector<Id<Tag>>& ids) {
  return copy_numbers(reinterpret_cast<const std::int32_t*>(ids.data()), ids.size());
}
template <class IdType, class Value>
val to_array(const IdVector<IdType, Value>& values) {
  return to_array(values.raw());
}

/// A Uint8Array of these bytes.
inline val to_bytes(std::string_view bytes) {
  return copy_numbers(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// An object with these members.
inline val object(std::initializer_list<std::pair<const char*, val>> members) {
  val made = val::object();
  for (const auto& [name, value] : members) made.set(name, value);
  return made;
}

/// {face, bary}: the faces of points, and three barycentric coordinates of each.
val to_points(const std::vector<SurfacePoint>& points);
/// Their positions, three coordinates each.
val to_positions(const Mesh& mesh, const std::vector<SurfacePoint>& points);

/// A text of the library with its placeholders as properties of options: "max_added", "no_refine: true".
std::string spell_properties(std::string_view text);

/// Does the work of a call. What it throws becomes the class that JavaScript gave as Module.Error, with its code.
template <class Work>
auto guarded(Work&& work) {
  const auto raise = [](const char* message, std::string_view code, double element) {
    val::module_property("Error").new_(std::string(message), std::string(code), element).throw_();
  };
  try {
    return std::forward<Work>(work)();
  } catch (const Error& error) {
    raise(spell_properties(error.text()).c_str(), kErrorCodeNames[std::size_t(error.code())], double(error.element()));
  } catch (const std::bad_alloc&) {
    raise("the memory of the page is full; use a smaller mesh or fewer generators", "out_of_memory", -1);
  } catch (const std::exception& error) {
    raise(error.what(), "internal_error", -1);
  }
  __builtin_unreachable();
}

/// What a vertex, a face or a position is in the entries of `points`, as web/npm/points.mjs makes them: {kind, id, at}.
GeneratorList make_list(const char* name, const val& entries);
std::vector<SurfacePoint> resolve(const Mesh& mesh, const char* name, const val& entries);

/// Does `work` with points or, where `entries` are {curves}, with curves.
template <class Work>
auto with_sources(const Mesh& mesh, const val& entries, const Work& work) {
  const val curves = entries["curves"];
  return curves.isUndefined() ? work(resolve(mesh, "points", entries)) : work(curves.as<CurveSet>().curves);
}

/// The options of a call by their names; undefined and null stand for those that were not given.
class Given {
 public:
  Given(const Mesh& mesh, val options) : mesh_(mesh), options_(std::move(options)) {}

  bool has(const char* name) const { return !options_[name].isUndefined() && !options_[name].isNull(); }
  bool is_text(const char* name) const { return options_[name].isString(); }
  val operator[](const char* name) const { return options_[name]; }

  /// Throws Error{invalid_option} where the value has another type, or is out of its range.
  template <class T>
  void read(const char* name, T& value) const {
    if (!has(name)) return;
    const val given = options_[name];
    if constexpr (std::is_same_v<T, bool>) {
      if (!given.isTrue() && !given.isFalse()) refuse(name, "true or false");
      value = given.isTrue();
    } else {
      const double number = given.isNumber() ? given.as<double>() : std::numeric_limits<double>::quiet_NaN();
      if (std::isnan(number)) refuse(name, "a number");
      if constexpr (std::is_integral_v<T>) {
        const bool fits =
            std::abs(number) < std::ldexp(1.0, std::numeric_limits<T>::digits) && number == std::trunc(number);
        if (!fits || (number < 0 && std::is_unsigned_v<T>)) refuse(name, "a whole number that is not too large");
      }
      value = static_cast<T>(number);
    }
  }
  template <class T>
  void read(const char* name, std::optional<T>& value) const {
    if (!has(name)) return;
    value.emplace();
    read(name, *value);
  }
  /// Throws Error{invalid_option} for a name that is none of the choices.
  template <class T, class Choice>
  void read(const char* name, T& value, const Choices<Choice>& choices) const {
    if (!has(name)) return;
    const std::optional<Choice> found =
        is_text(name) ? value_in(choices, options_[name].as<std::string>()) : std::nullopt;
    if (!found) refuse(name, fmt::format("one of {}", fmt::join(names_in(choices), ", ")));
    value = *found;
  }

  std::vector<SurfacePoint> points(const char* name) const { return resolve(mesh_, name, options_[name]); }
  std::vector<double> numbers(const char* name) const {
    return emscripten::convertJSArrayToNumberVector<double>(options_[name]);
  }
  /// n, sampling, seed and radius, which make the option `sampler` of other languages.
  SamplingOptions sampling(const char*) const;
  DiagramOptions diagram() const;
  /// The option `progress`: a function of a step's name and the fraction done, which cancels by returning false. It is
  /// called ten times a second at most.
  Progress progress() const;

 private:
  [[noreturn]] void refuse(const char* name, std::string_view wanted) const {
    throw Error(ErrorCode::invalid_option, fmt::format("{}: {} is needed, not {}", name, wanted,
                                                       val::global("String")(options_[name]).as<std::string>()));
  }

  const Mesh& mesh_;
  val options_;
};

/// The bytes of a file in the format of an extension. `own` are formats of one result alone.
val write_result(LabelledMesh mesh, const std::string& format, const Given& options, const OwnFormats& own);

void bind_mesh();
void bind_curves();
void bind_diagram();
void bind_editor();
void bind_remesh();

}  // namespace gvd::web
