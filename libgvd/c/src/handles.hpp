#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/gvd.h"
#include "gvd/mesh_objects.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/surface_point.hpp"

// What the C interface hands out, and the guard that lets no exception out.

namespace gvd::c {

/// Lists of points as one, made when it is asked for first.
class JoinedPoints {
 public:
  const std::vector<SurfacePoint>& all();
  PointLists lists;

 private:
  std::once_flag made_;
  std::vector<SurfacePoint> points_;
};

}  // namespace gvd::c

/// An object with the views of its parts. It holds what it refers to, so that handles may be released in any order.
struct gvd_object {
  explicit gvd_object(std::shared_ptr<const gvd::Object> made);
  gvd_object(const gvd_object&) = delete;
  gvd_object& operator=(const gvd_object&) = delete;

  /// Throws Error{invalid_option} where this is no mesh.
  const gvd::MeshPtr& checked() const;
  const gvd::Mesh& mesh() const { return checked()->mesh; }
  /// Throws Error{invalid_option} where this is no diagram.
  const gvd::DiagramObject& diagram_object() const;
  const gvd::Diagram& diagram() const { return diagram_object().diagram(); }
  /// The tree of a mesh, which the first call builds.
  const gvd::ClosestPointTree& closest() const;

  std::shared_ptr<const gvd::Object> object;
  std::string figures;  ///< JSON
  std::string repairs;  ///< of a mesh, one line each
  std::map<std::string, std::function<gvd::ArrayView()>, std::less<>> arrays;
  std::map<std::string, std::shared_ptr<const gvd::Object>, std::less<>> parts;
  std::optional<std::vector<gvd_point>> generators;  ///< of the vertices of a remesh

  // What no object owns in one piece.
  std::deque<std::vector<double>> numbers;
  std::deque<std::vector<std::int64_t>> whole_numbers;
  std::deque<gvd::c::JoinedPoints> joined;

 private:
  mutable std::once_flag tree_made_;
  mutable std::unique_ptr<gvd::ClosestPointTree> tree_;
};

namespace gvd::c {

/// Keeps the message for gvd_last_error, and returns the status.
gvd_status fail(gvd_status status, const char* message) noexcept;
gvd_status fail(const Error& error) noexcept;

/// Does the work of a call; its exceptions become a status and a message.
template <class Work>
gvd_status guarded(Work&& work) noexcept {
  try {
    work();
    return GVD_OK;
  } catch (const Error& error) {
    return fail(error);
  } catch (const std::bad_alloc&) {
    return fail(GVD_OUT_OF_MEMORY, "out of memory; use a smaller mesh or fewer generators");
  } catch (const std::exception& error) {
    return fail(GVD_INTERNAL_ERROR, error.what());
  } catch (...) {
    return fail(GVD_INTERNAL_ERROR, "unknown exception");
  }
}

/// What a function without a status answers: `fallback` where an argument is NULL or an object of another kind.
template <class T, class Work>
T answered(T fallback, Work&& work) noexcept {
  guarded([&] { fallback = work(); });
  return fallback;
}

[[noreturn]] void refuse(const std::string& message);

/// The value behind an argument that must not be NULL.
template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) refuse(std::string(name) + " is NULL");
  return *argument;
}

/// The result of an operation, with options as JSON. Throws what the operation throws.
std::unique_ptr<gvd_object> call(const char* operation, const gvd_object* on, const std::string& options,
                                 std::span<const ArrayView> arrays, const gvd_run* run);

/// What an operation tells, for the functions and the flag of a run.
class CallObserver : public Observer {
 public:
  explicit CallObserver(const gvd_run* run);
  bool progress(std::string_view step, double fraction) override;
  void enter(std::string_view step) override;
  void note(const std::string& text) override;
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  bool is_cancelled() const;

  gvd_run run_{};
  std::vector<std::string> notes_;
};

}  // namespace gvd::c
