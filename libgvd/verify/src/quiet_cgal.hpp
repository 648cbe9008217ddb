#pragma once

namespace gvd {

/// While an object of this class exists, a failed check of CGAL throws and does not print. Implemented in verify.cpp,
/// the only file that includes CGAL.
class QuietCgal {
 public:
  QuietCgal();
  ~QuietCgal();
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  using Handler = void (*)(const char*, const char*, const char*, int, const char*);
  Handler on_error_;
  Handler on_warning_;
};

}  // namespace gvd
