// The HTML page: the template of web/, filled with a title, the entries of the scenes and their arrays.
//
// The build embeds the page's program, so one string is the whole page. Text from files is escaped for where it lands:
// the title for HTML, the JSON so that it can't end its script element.
// Invariant: a page is made of checked scenes only, and needs no file and no network when it is opened.
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "io/view/region_colors.hpp"
#include "io/view/scene_entry.hpp"
#include "io/view/view_steps.hpp"

namespace gvd {
namespace {

using nlohmann::json;

std::string replace_all(const std::string& text, char replaced, std::string_view by) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) c == replaced ? result.append(by) : result.append(1, c);
  return result;
}

std::string escape_html(const std::string& text) { return replace_all(replace_all(text, '&', "&amp;"), '<', "&lt;"); }

/// JSON without `<`, so that no text in it can end its HTML element or start a comment.
std::string dump_for_html(const json& document) {
  return replace_all(document.dump(-1, ' ', false, json::error_handler_t::replace), '<', "\\u003c");
}

std::string make_data(const std::vector<ViewScene>& scenes, const ViewOptions& options) {
  const io::ViewFrame frame = io::compute_view_frame(scenes);
  io::ViewBlobs blobs;
  json manifest{{"schema", "gvd-view/1"},
                {"title", options.title},
                {"up", to_text(options.up)},
                {"scale", frame.scale},
                {"origin", {frame.origin.x(), frame.origin.y(), frame.origin.z()}},
                {"scenes", json::array()}};
  const std::vector<std::vector<Rgb>> colors = io::choose_scene_colors(scenes);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    manifest["scenes"].push_back(io::make_scene_entry(scenes[i], colors[i], frame, blobs));
  }
  return "<script type=\"application/json\" id=\"manifest\">" + dump_for_html(manifest) + "</script>\n" + blobs.html();
}

std::string fill_template(std::string_view page, const std::string& title, const std::string& data) {
  const std::size_t title_at = page.find(io::kViewTitleMark), data_at = page.find(io::kViewDataMark);
  const std::size_t title_end = title_at + io::kViewTitleMark.size();
  std::string filled;
  filled.reserve(page.size() + title.size() + data.size());
  filled.append(page.substr(0, title_at)).append(title);
  filled.append(page.substr(title_end, data_at - title_end)).append(data);
  filled.append(page.substr(data_at + io::kViewDataMark.size()));
  return filled;
}

}  // namespace

const char* to_text(UpAxis axis) {
  constexpr std::array<const char*, 6> kNames{"x", "y", "z", "-x", "-y", "-z"};
  return kNames.at(static_cast<std::size_t>(axis));
}

bool has_viewer() { return !io::view_template().empty(); }

std::string make_view_page(const std::vector<ViewScene>& scenes, const ViewOptions& options) {
  if (!has_viewer()) {
    throw Error(
        ErrorCode::invalid_option,
        "can't make an HTML page: built without the viewer; configure with GVD_WITH_VIEWER=ON, which needs npm");
  }
  if (scenes.empty()) throw Error(ErrorCode::precondition, "the view has no scene; give at least one");
  for (const ViewScene& scene : scenes) io::check_view_scene(scene);
  return fill_template(io::view_template(), escape_html(options.title), make_data(scenes, options));
}

std::string make_view_page(const ViewScene& scene, const ViewOptions& options) {
  return make_view_page(std::vector<ViewScene>{scene}, options);
}

}  // namespace gvd
