#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/curve_list.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/object.hpp"
#include "gvd/option_list.hpp"
#include "gvd/read_values.hpp"
#include "gvd/soup.hpp"

// Reads values of options from arrays beside JSON, or from lists in JSON.
namespace gvd {

/// Beyond this, a double may stand for several whole numbers.
inline constexpr double kMostWhole = 0x1p53;

/// The objects to which JSON refers.
struct Arrays {
  std::span<const ArrayView> views;
  const CheckedMesh& input;
};

// Each of these functions throws Error{invalid_option} with a text that says what is wrong, without the name of the
// option.

/// `name`: how later messages call the points.
GeneratorList read_points(const nlohmann::ordered_json& value, const Arrays& arrays, const std::string& name);
CurveList read_curves(const nlohmann::ordered_json& value, const Arrays& arrays, const std::string& name);
ElementValues read_numbers(const nlohmann::ordered_json& value, const Arrays& arrays, ValueSource::Of of,
                           const std::string& name);
/// Reads whole numbers from 0.
std::vector<std::int64_t> read_indices(const nlohmann::ordered_json& value, const Arrays& arrays);

/// Reads a text from an array of its bytes.
std::string read_bytes(const nlohmann::ordered_json& value, const Arrays& arrays);
/// The bytes of an array, which must be contiguous. `place`: its number, for messages.
std::string_view bytes_of(const ArrayView& view, std::size_t place);
/// Reads all numbers of an array, row by row. `place`: its number, for messages.
std::vector<double> read_array(const ArrayView& view, std::size_t place);

/// Whether a value is {"array": N}.
bool is_array_reference(const nlohmann::ordered_json& value);
/// Whether a value is {"mesh_vertices": N}, an array of vertices with the mesh's numbers instead of the input's.
bool is_mesh_reference(const nlohmann::ordered_json& value);

}  // namespace gvd
