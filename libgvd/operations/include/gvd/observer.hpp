#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// What an operation tells while it works, for a door to override. Texts name options by placeholders
/// (gvd/placeholders.hpp). All calls come from the thread that runs the operation, also where it throws later.
class Observer {
 public:
  virtual ~Observer() = default;
  /// The fraction of a step that is done; false cancels the operation.
  virtual bool progress(std::string_view /*step*/, double /*fraction*/) { return true; }
  /// A step begins, maybe inside another one. A step that was there already goes on.
  virtual void enter(std::string_view /*step*/) {}
  /// The last step that began, and has not ended, ends.
  virtual void leave() {}
  /// A line that users should not miss, and one that only curious ones want to read.
  virtual void note(const std::string& /*text*/) {}
  /// A note that something is probably not as the user meant it.
  virtual void warn(const std::string& text) { note(text); }
  virtual void detail(const std::string& /*text*/) {}
  /// A relaxation has done so many iterations.
  virtual void iterated(std::int64_t /*iterations*/, double /*energy*/,
                        const std::vector<SurfacePoint>& /*generators*/) {}
  /// What the step has found so far; empty: nothing.
  virtual void status(const std::string& /*text*/) {}

  int threads = 0;  ///< for the operation; 0: one a core
};

/// For the `progress` fields of the library. The observer must outlive it.
inline Progress progress_of(Observer& observer) {
  return [&observer](std::string_view step, double fraction) { return observer.progress(step, fraction); };
}

/// A step, for as long as this lives.
class Step {
 public:
  Step(Observer& observer, std::string_view name) : observer_(observer) { observer_.enter(name); }
  ~Step() {
    if (is_inside_) observer_.leave();
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  /// Ends it, and begins another one in its place.
  void next(std::string_view name) {
    is_inside_ = false;  // where the other one can't begin, none has to end
    observer_.leave();
    observer_.enter(name);
    is_inside_ = true;
  }

 private:
  Observer& observer_;
  bool is_inside_ = true;
};

/// The result of `work`, which is a step.
template <class Work>
decltype(auto) as_step(Observer& observer, std::string_view name, Work&& work) {
  const Step step(observer, name);
  return std::forward<Work>(work)();
}

}  // namespace gvd
