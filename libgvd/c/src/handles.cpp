// Handles of the C interface: views of the parts of objects, errors, and the observer of a run.
//
// Most arrays are the object's own memory. The points of several curves are joined when somebody first asks for them.

#include "handles.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "gvd/diagram_operation.hpp"

namespace {

using namespace gvd;
using gvd::c::Lazy;

struct LastError {
  std::string text;
  const char* code = "";
  std::int64_t element = -1;
};
thread_local LastError last_error;

/// For each ErrorCode, in their order.
constexpr std::array kCodeNames{"invalid_option",    "unreadable_input", "precondition", "no_valid_result",
                                "unwritable_output", "reader_gone",      "interrupted"};

/// For each ErrorCode, in their order.
constexpr std::array<gvd_status, 7> kStatuses{GVD_INVALID_OPTION,  GVD_UNREADABLE_INPUT,  GVD_PRECONDITION,
                                              GVD_NO_VALID_RESULT, GVD_UNWRITABLE_OUTPUT, GVD_UNWRITABLE_OUTPUT,
                                              GVD_INTERRUPTED};
static_assert(std::size_t(ErrorCode::interrupted) + 1 == kStatuses.size());

template <class T>
std::vector<T> join(const Lists<T>& lists) {
  std::vector<T> joined;
  for (std::int64_t i = 0; i < lists.count; ++i) {
    const auto list = lists.list(i);
    joined.insert(joined.end(), list.begin(), list.end());
  }
  return joined;
}

/// Fills in the views of a handle. Figures that are lists of numbers become arrays, too.
class ViewCollector : public ObjectVisitor {
 public:
  explicit ViewCollector(gvd_object::Views& views) : views_(views) {}

  void figure(const Meaning& meaning, const Figure& value) override {
    if (const auto* const numbers = std::get_if<std::vector<double>>(&value)) keep(meaning, "", *numbers);
    if (const auto* const whole = std::get_if<std::vector<std::int64_t>>(&value)) keep(meaning, "", *whole);
  }
  void array(const Meaning& meaning, const ArrayView& values) override {
    add(meaning, "", [values] { return values; });
  }
  void points(const Meaning& meaning, const PointsView& points) override {
    add(meaning, "_faces", [points] { return points.faces(); });
    add(meaning, "_bary", [points] { return points.bary(); });
  }
  void curves(const Meaning& meaning, const PointLists& lists) override {
    keep_offsets(meaning, lists);
    const auto joined = std::make_shared<const Lazy<std::vector<SurfacePoint>>>();
    const auto all = [joined, lists] { return PointsView(joined->get([&] { return join(lists); })); };
    add(meaning, "_faces", [all] { return all().faces(); });
    add(meaning, "_bary", [all] { return all().bary(); });
  }
  void lists(const Meaning& meaning, const GeneratorLists& lists) override {
    keep_offsets(meaning, lists);
    keep(meaning, "", join(lists));
  }
  void table(const Meaning& meaning, const Table& table) override {
    for (const Column& column : table) figure({std::string(meaning.name) + '.' + column.name, "", ""}, column.values);
  }
  void part(const Meaning& meaning, std::string_view, const PartMaker& make) override {
    views_.parts.insert_or_assign(std::string(meaning.name), gvd_object::Views::Part{make, std::string(meaning.text)});
  }

 private:
  void add(const Meaning& meaning, const char* suffix, std::function<ArrayView()> view) {
    views_.arrays.insert_or_assign(std::string(meaning.name) + suffix, std::move(view));
  }
  /// Adds numbers that no object owns in contiguous memory.
  template <class T>
  void keep(const Meaning& meaning, const char* suffix, std::vector<T> values) {
    const auto kept = std::make_shared<const std::vector<T>>(std::move(values));
    add(meaning, suffix, [kept] { return view(*kept); });
  }
  template <class T>
  void keep_offsets(const Meaning& meaning, const Lists<T>& lists) {
    std::vector<std::int64_t> offsets{0};
    for (std::int64_t i = 0; i < lists.count; ++i) offsets.push_back(offsets.back() + std::ssize(lists.list(i)));
    keep(meaning, "_offsets", std::move(offsets));
  }

  gvd_object::Views& views_;
};

}  // namespace

gvd_object::gvd_object(std::shared_ptr<const gvd::Object> made, Door of) : object(std::move(made)), door(of) {
  if (const auto* const surface = dynamic_cast<const MeshObject*>(object.get())) {
    for (const std::string& line : surface->mesh()->defects.messages) repairs += spell_for_json(line) + '\n';
  }
}

const gvd_object::Views& gvd_object::views() const {
  return views_.get([&] {
    Views views;
    ViewCollector collector(views);
    object->visit(collector);
    return views;
  });
}

const std::string& gvd_object::figures() const {
  return figures_.get([&] {
    std::string text = figures_json(*object, door);
    if (told.empty()) return text;
    text.back() = text == "{}" ? ' ' : ',';
    return text + told.substr(1);
  });
}

const MeshPtr& gvd_object::checked() const {
  const auto* const surface = dynamic_cast<const MeshObject*>(object.get());
  if (surface == nullptr) c::refuse("this takes a mesh, and the object is a " + std::string(object->kind()));
  return surface->mesh();
}

const DiagramObject& gvd_object::diagram_object() const {
  const auto* const diagram = dynamic_cast<const DiagramObject*>(object.get());
  if (diagram == nullptr) c::refuse("this takes a diagram, and the object is a " + std::string(object->kind()));
  return *diagram;
}

const ClosestPointTree& gvd_object::closest() const {
  const Mesh& surface = mesh();
  return *tree_.get([&] { return std::make_unique<ClosestPointTree>(surface); });
}

const char* gvd_last_error(void) { return last_error.text.c_str(); }

const char* gvd_last_error_code(void) { return last_error.code; }

int64_t gvd_last_error_element(void) { return last_error.element; }

namespace gvd::c {

gvd_status fail(gvd_status status, const char* message, const char* code, std::int64_t element) noexcept {
  last_error.code = code;
  last_error.element = element;
  try {
    last_error.text = message;
  } catch (...) {
    last_error.text.clear();
  }
  return status;
}

Door door_of(const gvd_run* run) noexcept {
  const bool is_known = run != nullptr && run->door >= GVD_JSON && run->door <= GVD_JAVASCRIPT;
  return is_known ? static_cast<Door>(run->door) : Door::json;
}

gvd_status fail(const Error& error, Door door) noexcept {
  const gvd_status status = kStatuses[std::size_t(error.code())];
  try {
    std::string text = spell_for(door, error.text());
    const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
    // File names may contain line breaks, and a message is one line.
    std::replace_if(text.begin(), text.end(), is_control, '?');
    return fail(status, text.c_str(), kCodeNames[std::size_t(error.code())], error.element());
  } catch (...) {
    return fail(status, error.what(), kCodeNames[std::size_t(error.code())], error.element());
  }
}

void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

CallObserver::CallObserver(const gvd_run* run) {
  if (run != nullptr) run_ = *run;
  if (run_.threads < 0) refuse("threads is " + std::to_string(run_.threads) + "; give 0 for one a core, or more");
  threads = run_.threads;
}

bool CallObserver::is_cancelled() const {
  return run_.cancel != nullptr && __atomic_load_n(run_.cancel, __ATOMIC_RELAXED) != 0;
}

bool CallObserver::progress(std::string_view step, double fraction) {
  if (is_cancelled()) return false;
  if (run_.due != nullptr && __atomic_exchange_n(run_.due, 0, __ATOMIC_RELAXED) == 0) return true;
  return run_.progress == nullptr || run_.progress(run_.data, std::string(step).c_str(), fraction) != 0;
}

void CallObserver::enter(std::string_view step) {
  if (is_cancelled()) throw Error(ErrorCode::interrupted, "interrupted before " + std::string(step));
}

void CallObserver::note(const std::string& text) {
  notes_.push_back(spell_for(door(), text));
  if (run_.note != nullptr) run_.note(run_.data, notes_.back().c_str());
}

void CallObserver::iterated(std::int64_t iterations, double energy, const std::vector<SurfacePoint>& generators) {
  if (run_.iteration == nullptr) return;
  auto points = std::make_shared<SampleOutcome>();
  points->found.points = generators;
  const gvd_object object(std::move(points));
  run_.iteration(run_.data, std::int32_t(iterations), energy, &object);
}

void CallObserver::warn(const std::string& text) {
  note(text);
  warnings_.push_back(notes_.back());
}

}  // namespace gvd::c
