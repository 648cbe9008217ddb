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

// Values of options that come as arrays beside JSON, or as lists in it.
namespace gvd {

/// Beyond there are doubles that stand for several whole numbers.
inline constexpr double kMostWhole = 0x1p53;

/// What JSON refers to.
struct Arrays {
  std::span<const ArrayView> views;
  const CheckedMesh& input;
};

// Each of these throws Error{invalid_option} whose text begins with what is wrong, without the name of the option.

/// `name`: what later messages call the points.
GeneratorList read_points(const nlohmann::ordered_json& value, const Arrays& arrays, const std::string& name);
CurveList read_curves(const nlohmann::ordered_json& value, const Arrays& arrays, const std::string& name);
ElementValues read_numbers(const nlohmann::ordered_json& value, const Arrays& arrays, ValueSource::Of of,
                           const std::string& name);
/// Whole numbers from 0 on.
std::vector<std::int64_t> read_indices(const nlohmann::ordered_json& value, const Arrays& arrays);

/// A text, as an array of its bytes.
std::string read_bytes(const nlohmann::ordered_json& value, const Arrays& arrays);
/// The bytes of an array of them that has no gaps. `place`: its number, for messages.
std::string_view bytes_of(const ArrayView& view, std::size_t place);
/// All numbers of an array, row by row. `place`: its number, for messages.
std::vector<double> read_array(const ArrayView& view, std::size_t place);

/// Whether a value is {"array": N}.
bool is_array_reference(const nlohmann::ordered_json& value);
/// Whether it is {"mesh_vertices": N}: an array of vertices as the mesh numbers them, not the input.
bool is_mesh_reference(const nlohmann::ordered_json& value);

}  // namespace gvd
