#pragma once

#include <string_view>

namespace gvd::io {

/// The page without its data, which the build makes of web/ (cmake/embed_viewer.cmake). It holds each of the two marks
/// below once. It is empty where GVD_WITH_VIEWER is off.
std::string_view view_template();

inline constexpr std::string_view kViewTitleMark = "<!--gvd:title-->";
inline constexpr std::string_view kViewDataMark = "<!--gvd:data-->";

}  // namespace gvd::io
