#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "gvd/object.hpp"
#include "gvd/option_list.hpp"
#include "gvd/soup.hpp"

// Options, figures and descriptions of operations as JSON, for doors that programs use.
namespace gvd {

/// Stores the options of a JSON object, and returns which options it sets. In the JSON, {"array": 0} refers to the
/// numbers of the first of `arrays`. Numbers may be strings; null means that the option is not set.
///
/// Points are an array of vertices, of positions in three columns, or of faces and barycentric coordinates in four; a
/// list of vertices or of such rows; or a list as in JSON files of generators. Vertices have the numbers of the input;
/// with {"mesh_vertices": 0}, an array of vertices has the mesh's own numbers. A list of arrays stands for the points
/// of all of them. Curves are {"points": ..., "offsets": ...}, where each offset is the index of a curve's first point
/// and the last offset is the number of points. Closed curves have "closed": true.
/// Throws Error{invalid_option} with one line about the first mistake. Cost: O(length and numbers).
Given read_json_options(const OptionList& list, const CheckedMesh& input, std::string_view json,
                        std::span<const ArrayView> arrays);

/// The interface whose user reads a text. Users of JSON write options as "count": 30, users of Python as count=30, and
/// users of JavaScript as count: 30.
enum class Door : std::int32_t { json, python, javascript };

/// Replaces the placeholders of a text by options as users of this door write them. Leaves out advice to give an option
/// if the call has no such option or has one that excludes it; without a call, leaves out all advice.
std::string spell_for(Door door, const std::string& text);
std::string spell_for(Door door, const std::string& text, const OptionList& list, const Given& given);
inline std::string spell_for_json(const std::string& text) { return spell_for(Door::json, text); }

/// The value of an option, and the kind of values that it takes.
std::string value_json(const Field& field);
std::string kind_json(const Field& field);

/// All options with their values; null for an option that is not set or has no effect. `read_json_options` reads the
/// same options back: points, curves and numbers are as they were given, and refer to the same arrays. For JavaScript,
/// whole numbers that it would round are texts.
std::string options_json(const OptionList& list, const Given& given, Door door = Door::json);

/// The figures of an object. Dots in their names become levels of JSON.
std::string figures_json(const Object& object, Door door = Door::json);
/// The figures that `visit` passes to its visitor.
std::string figures_json(const std::function<void(ObjectVisitor&)>& visit, Door door = Door::json);

/// The table of formats: an array of objects with `name`, `title`, `extensions`, `input_extensions`, `is_read`,
/// `is_written`, `is_binary` and `carries`.
std::string formats_json();

/// Operations with their options and results, formats, and error codes.
std::string describe_operations(Door door = Door::json);

}  // namespace gvd
