// Which files hold what was asked of distances: the same for the commands, before they measure, and for every result
// that is written later.
#include <fmt/format.h>

#include <algorithm>

#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// What holds curves without a surface and, of the formats with one, those that draw lines beside it.
constexpr Content kPaths = Content::curves | Content::paths, kIsolines = Content::curves | Content::isolines;
constexpr Content kDistances = Content::distances | Content::rows;

[[noreturn]] void refuse_file(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

/// The formats to write instead.
std::string list_formats(Content any) { return list_extensions(output_extensions(any), "or"); }

std::string named(const WrittenFile& file) {
  return fmt::format("{}: .{}", file.name, file.format->extensions.front());
}

}  // namespace

AskedDistances asked_of(const DistancesCall& call) {
  return {call.targets.are_listed(), call.each, call.paths, call.isolines.has_value()};
}

void check_files(const AskedDistances& asked, const std::vector<WrittenFile>& files,
                 const std::vector<std::string>& others, bool has_other) {
  /// The first file that carries any of `any`, but nothing of `none`. Null: there is none.
  const auto find = [&](Content any, Content none = Content::nothing) {
    const auto found = std::ranges::find_if(files, [&](const WrittenFile& file) {
      return has_any(file.format->carries, any) && !has_any(file.format->carries, none);
    });
    return found == files.end() ? nullptr : &*found;
  };
  const auto loses = [&](bool is_asked, Content any) { return is_asked && !has_other && find(any) == nullptr; };
  if (find(Content::distances, Content::surface) != nullptr && asked.targets) {
    refuse_file(fmt::format("\1to\2: {} hold a distance for each vertex; write {}, or leave \1to\2 out",
                            list_extensions(output_extensions(Content::distances, Content::surface), "and"),
                            list_formats(Content::targets)));
  }
  const WrittenFile* const single = find(Content::distances, Content::rows);
  const bool has_surface = single != nullptr && has_any(single->format->carries, Content::surface);
  if (asked.each && single != nullptr && !(asked.paths && has_surface)) {
    refuse_file(fmt::format("\1each\2: {} hold one distance for each vertex; write {}{}",
                            list_extensions(output_extensions(Content::distances, Content::rows), "and"),
                            list_formats(Content::rows), has_surface ? ", or add \1to\2 and \1paths\2" : ""));
  }
  if (loses(asked.isolines, kIsolines)) {
    refuse_file(fmt::format("\1isolines\2: {} curves; write one of them or leave \1isolines\2 out",
                            only_formats(kIsolines, others)));
  }
  const bool has_curves = asked.paths || asked.isolines;
  if (const WrittenFile* const lines = find(Content::curves, kDistances); lines != nullptr && !has_curves) {
    refuse_file(asked.targets ? fmt::format("{} holds no distances; add \1paths\2 for the shortest paths, or write {}",
                                            named(*lines), list_formats(Content::targets))
                              : fmt::format("{} holds no distances; write {}, or add \1isolines\2", named(*lines),
                                            list_formats(kDistances)));
  }
  const WrittenFile* const mesh = find(Content::distances, Content::targets);
  if (mesh != nullptr && !has_curves && loses(asked.targets, Content::targets)) {
    refuse_file(
        fmt::format("{} has the distances of all vertices, for which \1to\2 does nothing; {}write {}, or leave "
                    "\1to\2 out",
                    named(*mesh), has_any(mesh->format->carries, Content::curves) ? "add \1paths\2, " : "",
                    list_formats(Content::targets)));
  }
  if (loses(asked.paths, kPaths)) {
    refuse_file(
        fmt::format("\1paths\2: {} paths; write one of them or leave \1paths\2 out", only_formats(kPaths, others)));
  }
}

}  // namespace gvd
