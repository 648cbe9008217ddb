// The C interface as JavaScript calls it: numbers in place of structures, and functions of the page in place of
// pointers.
//
// web/npm/library.mjs calls these and those of gvd/gvd.h that take plain numbers; nobody else does.
#include <emscripten.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <vector>

#include "gvd/gvd.h"

// What JavaScript has set as Module.progress and Module.iterated.
EM_JS(int, tell_progress, (void* data, const char* step, double fraction),
      { return Module['progress'](step, fraction); })
EM_JS(void, tell_iteration, (void* data, int32_t iterations, double energy, const gvd_object* points),
      { Module['iterated'](iterations, energy, points); })

namespace {

/// How calls run; JavaScript hears of progress and iterations where it wants to.
gvd_run make_run(int32_t hears_progress, int32_t hears_iterations) {
  gvd_run run{};
  run.threads = 1;
  run.door = GVD_JAVASCRIPT;
  if (hears_progress != 0) run.progress = tell_progress;
  if (hears_iterations != 0) run.iteration = tell_iteration;
  return run;
}

/// Four numbers for each array: its address, type, rows and columns. One of one dimension has 0 columns.
gvd_array to_array(const int32_t* given) {
  const int64_t size[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  const int64_t bytes = size[given[1]], rows = given[2], columns = given[3];
  const auto* const data = reinterpret_cast<const void*>(given[0]);
  if (columns == 0) return {data, given[1], 1, {rows, 1}, {bytes, 0}};
  return {data, given[1], 2, {rows, columns}, {columns * bytes, bytes}};
}

}  // namespace

extern "C" {

/// There are no files: whoever opens one hears so. Without these, emscripten's end the module.
int __syscall_openat(int, intptr_t, int, ...) { return -ENOENT; }
int __syscall_stat64(intptr_t, intptr_t) { return -ENOENT; }
int __syscall_lstat64(intptr_t, intptr_t) { return -ENOENT; }
int __syscall_newfstatat(int, intptr_t, intptr_t, int) { return -ENOENT; }

/// `arrays`: four numbers for each of `count`.
EMSCRIPTEN_KEEPALIVE gvd_status gvd_web_call(const char* operation, const gvd_object* on, const char* options,
                                             const int32_t* arrays, int32_t count, int32_t hears_progress,
                                             int32_t hears_iterations, gvd_object** result) {
  std::vector<gvd_array> views;
  for (int32_t i = 0; i < count; ++i) views.push_back(to_array(arrays + 4 * i));
  const gvd_run run = make_run(hears_progress, hears_iterations);
  return gvd_call(GVD_ABI, operation, on, options, views.data(), count, &run, result);
}

/// `view`: address, type, rows, columns, and the bytes from one row and one column to the next.
EMSCRIPTEN_KEEPALIVE gvd_status gvd_web_array_of(const gvd_object* object, const char* name, int32_t* view) {
  gvd_array array{};
  const gvd_status status = gvd_array_of(object, name, &array);
  const bool is_table = array.dimensions == 2;
  const int64_t numbers[] = {reinterpret_cast<int32_t>(array.data), array.type,       array.shape[0],
                             is_table ? array.shape[1] : 1,         array.strides[0], is_table ? array.strides[1] : 0};
  std::transform(std::begin(numbers), std::end(numbers), view, [](int64_t number) { return int32_t(number); });
  return status;
}

EMSCRIPTEN_KEEPALIVE gvd_status gvd_web_file_of(const gvd_object* object, const char* format, const char* options,
                                                gvd_object** file) {
  const gvd_run run = make_run(0, 0);
  return gvd_file_of(object, format, options, &run, file);
}

EMSCRIPTEN_KEEPALIVE double gvd_web_last_error_element() { return double(gvd_last_error_element()); }

}  // extern "C"
