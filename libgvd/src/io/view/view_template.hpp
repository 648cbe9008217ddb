#pragma once

#include <string_view>

namespace gvd::io {

/// The page without its data, which the build makes from web/ (cmake/embed_viewer.cmake). It contains each of the two
/// marks below once. It is empty if GVD_WITH_VIEWER is off.
std::string_view view_template();

inline constexpr std::string_view kViewTitleMark = "<!--gvd:title-->";
inline constexpr std::string_view kViewDataMark = "<!--gvd:data-->";

}  // namespace gvd::io
