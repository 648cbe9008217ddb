// The operation `edit`: moves or removes a generator of a diagram, or adds generators.
//
// Objects never change, but an editor does. So an editor belongs to the last diagram that it made: an edit takes it out
// of this diagram and leaves it in the next. A diagram without an editor, for example because it was edited before,
// gets a new one. So edits give the right diagram in any order and from any thread.

#include "gvd/edit_operation.hpp"

#include <fmt/format.h>

#include <vector>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

std::vector<SurfacePoint> resolve_points(const DiagramObject& on, const EditCall& call, Observer& observer) {
  GeneratorOptions asked;
  asked.points_name = call.move ? "\1to\2" : "\1add\2";
  asked.points = call.move ? call.to : call.add;
  asked.max_snap = call.max_snap;
  std::vector<SurfacePoint> points = resolve_listed(*on.mesh(), asked, observer).points;
  if (!call.move || points.size() == 1) return points;
  throw Error(ErrorCode::invalid_option, fmt::format("one point is needed in \1to\2, and there are {}",
                                                     counted(std::ssize(points), "point", "points")));
}

void change(DiagramEditor& editor, const EditCall& call, const std::vector<SurfacePoint>& points) {
  if (call.move) {
    editor.move(GeneratorId(*call.move), points.front());
  } else if (call.remove) {
    editor.remove(GeneratorId(*call.remove));
  } else {
    editor.add(points);
  }
}

}  // namespace

void describe(OptionList& list, EditCall& call) {
  list.group("Change (one of \1move\2, \1add\2, \1remove\2)");
  list.option("move", Number{&call.move, {.least = 0}}, {.help = "Number of the generator that moves to \1to\2"});
  list.option("to", PointList{&call.to}, {.help = "A point, near or far"});
  list.option("add", PointList{&call.add}, {.help = "Points that become generators, with the next numbers"});
  list.option("remove", Number{&call.remove, {.least = 0}},
              {.help = "Number of a generator to remove", .more = "; the last one gets its number"});
  list.option("max_snap", Number{&call.max_snap, {.least = 0}},
              {.help = "Refuse a point that is farther than this from the surface", .unit = "mesh units"});
  list.one_of({{"move", "add", "remove"}, "no change"});
  list.needs("move", "to");
  list.needs("to", "move");
  list.excludes("remove", {"max_snap"});
}

void EditOutcome::visit(ObjectVisitor& visitor) const {
  DiagramObject::visit(visitor);
  visitor.figure({"propagated", "", "generators whose distances were computed again"}, std::int64_t(propagated_));
}

std::shared_ptr<const EditOutcome> run(const DiagramObject& on, EditCall& call, Observer& observer) {
  const Step step(observer, "edit");
  const auto points = call.remove ? std::vector<SurfacePoint>() : resolve_points(on, call, observer);
  std::unique_ptr<DiagramEditor> editor = on.take_editor(observer);
  try {
    change(*editor, call, points);
  } catch (const Error&) {  // a failed change leaves the editor as it was
    on.keep(std::move(editor));
    throw;
  }
  auto made = std::make_shared<EditOutcome>(
      DiagramObject(on.mesh(), std::make_shared<const Diagram>(editor->diagram()), on.options()), editor->propagated());
  made->keep(std::move(editor));
  return made;
}

}  // namespace gvd
