// Makes a soup of VTK's points and cells, for both kinds of VTK files.
//
// A file may hold lines and vertices beside its polygons; files that this library writes hold bisectors. These lines
// and vertices are left out together with the points that only they use, so that a written mesh reads back as it was.
// Source: VTK File Formats, version 4.2; vtkCellType.h for the types of cells.
// Invariant: every index is compared with the number of points before it is used.
#include "mesh/reading/vtk_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// The numbers of cell types in files.
constexpr double kPolyLine = 4, kTriangle = 5, kStrip = 6, kPolygon = 7, kPixel = 8, kQuad = 9;

/// The number of corners of a type of faces, if the type fixes it.
std::optional<std::size_t> corners_of(double type) {
  if (type == kTriangle) return 3;
  return type == kPixel || type == kQuad ? std::optional<std::size_t>(4) : std::nullopt;
}

}  // namespace

std::optional<StoredNumber> find_vtk_type(std::string_view name) {
  using Kind = StoredNumber::Kind;
  static constexpr std::array<std::pair<std::string_view, StoredNumber>, 23> kTypes{
      {{"char", {Kind::signed_integer, 1}},
       {"unsigned_char", {Kind::unsigned_integer, 1}},
       {"short", {Kind::signed_integer, 2}},
       {"unsigned_short", {Kind::unsigned_integer, 2}},
       {"int", {Kind::signed_integer, 4}},
       {"unsigned_int", {Kind::unsigned_integer, 4}},
       {"long", {Kind::signed_integer, 8}},
       {"unsigned_long", {Kind::unsigned_integer, 8}},
       {"vtkidtype", {Kind::signed_integer, 4}},
       {"vtktypeint64", {Kind::signed_integer, 8}},
       {"float", {Kind::real, 4}},
       {"double", {Kind::real, 8}},
       {"int8", {Kind::signed_integer, 1}},
       {"uint8", {Kind::unsigned_integer, 1}},
       {"int16", {Kind::signed_integer, 2}},
       {"uint16", {Kind::unsigned_integer, 2}},
       {"int32", {Kind::signed_integer, 4}},
       {"uint32", {Kind::unsigned_integer, 4}},
       {"int64", {Kind::signed_integer, 8}},
       {"uint64", {Kind::unsigned_integer, 8}},
       {"float32", {Kind::real, 4}},
       {"float64", {Kind::real, 8}},
       {"vtktypeuint64", {Kind::unsigned_integer, 8}}}};
  const std::string lower = to_lower(name);
  const auto* found = std::ranges::find(kTypes, std::string_view(lower), [](const auto& type) { return type.first; });
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

void VtkSoup::add_points(const std::vector<double>& coordinates) {
  first_point_ = soup_.positions.size();
  check_counts(first_point_ + coordinates.size() / 3, 0, name_);
  // Reserving for each of many small pieces would take quadratic time.
  if (first_point_ == 0) soup_.positions.reserve(coordinates.size() / 3);
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    const Vec3 p(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    const auto point = std::ssize(soup_.positions);
    if (!p.allFinite()) {
      throw Error(ErrorCode::precondition,
                  fmt::format("{}: a coordinate of point {} is not a finite number", name_, point), point);
    }
    soup_.positions.push_back(p);
  }
}

void VtkSoup::for_each_cell(const VtkCells& cells, void (VtkSoup::*add)(Corners)) {
  std::size_t begin = 0;
  for (const double end : cells.ends) {
    if (!(end >= double(begin) && end <= double(cells.corners.size()) && end == std::floor(end))) {
      refuse(fmt::format("the corners of cell {} end at {}; the file has {} from {} on", cell_, end,
                         cells.corners.size(), begin),
             cell_);
    }
    const auto next = std::size_t(end);
    (this->*add)(Corners(cells.corners).subspan(begin, next - begin));
    begin = next;
    ++cell_;
  }
  if (begin < cells.corners.size()) {
    refuse(fmt::format("the corners of the last cell end at {}, and the file has {}; write the file again", begin,
                       cells.corners.size()));
  }
}

void VtkSoup::add_polygon(Corners corners) {
  for (const double corner : corners) soup_.corners.push_back(require_index(corner));
  soup_.close_polygon();
  if (keeps_cells_) polygon_cell_.push_back(cell_);
}

void VtkSoup::add_strip(Corners corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::size_t turned = i % 2;  // every second triangle is reversed
    add_polygon(std::array{corners[i - 2 + turned], corners[i - 1 - turned], corners[i]});
  }
}

void VtkSoup::leave_out_cell(Corners corners) {
  for (const double corner : corners) line_points_.push_back(require_index(corner));
  ++left_out_;
}

void VtkSoup::add_cells(const VtkCells& cells, const std::vector<double>& types) {
  if (types.size() != cells.ends.size()) {
    refuse(fmt::format("there are {} and {} of cells", counted(std::ssize(cells.ends), "cell", "cells"),
                       counted(std::ssize(types), "type", "types")));
  }
  type_ = types.data();
  for_each_cell(cells, &VtkSoup::add_typed);
}

void VtkSoup::add_typed(Corners corners) {
  const double type = *type_++;
  if (const auto wanted = corners_of(type); wanted && corners.size() != *wanted) {
    refuse(fmt::format("cell {} has {}, and its VTK type {} has {}; correct it, or write a polygon (type {})", cell_,
                       counted(std::ssize(corners), "corner", "corners"), type, *wanted, kPolygon),
           cell_);
  }
  if (type == kTriangle || type == kPolygon || type == kQuad) return add_polygon(corners);
  if (type == kStrip) return add_strip(corners);
  if (type == kPixel) return add_polygon(std::array{corners[0], corners[1], corners[3], corners[2]});
  if (type >= 0 && type <= kPolyLine) return leave_out_cell(corners);
  refuse(fmt::format("cell {} has the VTK type {}, and only triangles, quads, polygons and strips are read; extract "
                     "the surface first",
                     cell_, type),
         cell_);
}

std::int32_t VtkSoup::require_index(double corner) const {
  const std::size_t points = soup_.positions.size() - first_point_;
  if (!(corner >= 0) || corner >= double(points) || corner != std::floor(corner)) {
    refuse(fmt::format("cell {} refers to point {}, and there are {}", cell_, corner, points), cell_);
  }
  return static_cast<std::int32_t>(first_point_ + std::size_t(corner));
}

void VtkSoup::drop_points_of_lines() {
  constexpr char kDropped = 1, kKept = 2;
  std::vector<char> state(soup_.positions.size(), 0);
  for (const std::int32_t p : line_points_) state[p] = kDropped;
  for (const std::int32_t p : soup_.corners) state[p] = kKept;
  std::vector<std::int32_t> moved(soup_.positions.size());
  std::size_t kept = 0;
  for (std::size_t p = 0; p < soup_.positions.size(); ++p) {
    moved[p] = static_cast<std::int32_t>(kept);
    if (state[p] != kDropped) soup_.positions[kept++] = soup_.positions[p];
    is_kept_.push_back(state[p] != kDropped);
  }
  soup_.positions.resize(kept);
  for (std::int32_t& p : soup_.corners) p = moved[p];
}

PolygonSoup VtkSoup::take() {
  if (left_out_ > 0) {
    if (soup_.polygon_count() > 0) drop_points_of_lines();
    soup_.notes.push_back(
        fmt::format("{} left out", counted(left_out_, "line or vertex is", "lines and vertices are")));
  }
  return std::move(soup_);
}

void VtkSoup::refuse(std::string_view message, std::int64_t element) const {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name_, message), element);
}

}  // namespace gvd
