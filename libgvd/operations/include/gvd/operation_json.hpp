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

/// Stores the options of a JSON object, and returns which ones it has. The numbers of `arrays` are options' values
/// where the JSON has {"array": 0} for the first one. Numbers may be strings; null is as if the option were not there.
///
/// Points are an array of vertices, of positions in three columns, or of faces and barycentric coordinates in four; a
/// list of vertices or of such rows; or one as in JSON files of generators. Vertices are those of the input;
/// {"mesh_vertices": 0} is an array of the mesh's own. A list of arrays is all their points. Curves are {"points": ...,
/// "offsets": ...}, where an offset is the place of the first point of a curve and the last one the number of points,
/// with "closed": true for loops.
/// Throws Error{invalid_option} with one line for the first mistake. Cost: O(length and numbers).
Given read_json_options(const OptionList& list, const CheckedMesh& input, std::string_view json,
                        std::span<const ArrayView> arrays);

/// Whoever reads a text writes an option as "count": 30, as count=30, or as count: 30.
enum class Door : std::int32_t { json, python, javascript };

/// A text with each placeholder as users of this door write the option. Advice to give an option is left out where the
/// call has none of that name, or has one that excludes it; without a call, always.
std::string spell_for(Door door, const std::string& text);
std::string spell_for(Door door, const std::string& text, const OptionList& list, const Given& given);
inline std::string spell_for_json(const std::string& text) { return spell_for(Door::json, text); }

/// The value of an option, and what kind of values it takes.
std::string value_json(const Field& field);
std::string kind_json(const Field& field);

/// Every option with its value; null where it is not set or does nothing. Given back, they are the same options:
/// points, curves and numbers are as they were given, and refer to the same arrays. For JavaScript a whole number that
/// it would round is a text.
std::string options_json(const OptionList& list, const Given& given, Door door = Door::json);

/// The figures of an object, nested at the dots of their names.
std::string figures_json(const Object& object, Door door = Door::json);
/// The same of what `visit` tells.
std::string figures_json(const std::function<void(ObjectVisitor&)>& visit, Door door = Door::json);

/// The table of formats: an array of objects with `name`, `title`, `extensions`, `input_extensions`, `is_read`,
/// `is_written`, `is_binary` and `carries`.
std::string formats_json();

/// Operations with their options and results, formats, and error codes.
std::string describe_operations(Door door = Door::json);

}  // namespace gvd
