#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Receives the progress and the notes of a running operation. Doors override its functions. Texts name options by
/// placeholders (gvd/placeholders.hpp). All calls come from the thread that runs the operation.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Reports the fraction of a step that is done. Returning false cancels the operation.
  virtual bool progress(std::string_view /*step*/, double /*fraction*/) { return true; }
  /// A step begins, possibly inside another step. A name that occurred before continues that step.
  virtual void enter(std::string_view /*step*/) {}
  /// The innermost step ends.
  virtual void leave() {}
  /// `note` reports a line that users should not miss, and `detail` a line for curious users only.
  virtual void note(const std::string& /*text*/) {}
  /// A note about something that the user probably did not intend.
  virtual void warn(const std::string& text) { note(text); }
  virtual void detail(const std::string& /*text*/) {}
  /// A relaxation has done this many iterations.
  virtual void iterated(std::int64_t /*iterations*/, double /*energy*/,
                        const std::vector<SurfacePoint>& /*generators*/) {}
  /// Shows what the step has found so far; an empty text clears it.
  virtual void status(const std::string& /*text*/) {}

  int threads = 0;  ///< for the operation; 0: as many as there are cores
};

/// A callback for the `progress` fields of the library. The observer must outlive it.
inline Progress progress_of(Observer& observer) {
  return [&observer](std::string_view step, double fraction) { return observer.progress(step, fraction); };
}

/// A step of an operation, which lasts as long as this object.
class Step {
 public:
  Step(Observer& observer, std::string_view name) : observer_(observer) { observer_.enter(name); }
  ~Step() {
    if (is_inside_) observer_.leave();
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  /// Ends the step and begins another one in its place.
  void next(std::string_view name) {
    is_inside_ = false;  // if `enter` throws, no step has to end
    observer_.leave();
    observer_.enter(name);
    is_inside_ = true;
  }

 private:
  Observer& observer_;
  bool is_inside_ = true;
};

/// Runs `work` as a step, and returns its result.
template <class Work>
decltype(auto) as_step(Observer& observer, std::string_view name, Work&& work) {
  const Step step(observer, name);
  return std::forward<Work>(work)();
}

}  // namespace gvd
