// Describes the options that the commands share: their fields, their texts, and which options go together.

#include "common/options/shared_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/diagram_options.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/option_text.hpp"

namespace gvd::app {
namespace {

using Formats = std::vector<std::string>;
using Use = File::Use;

/// The extensions of INPUT, for completion. A file with another name is recognised by its content, too.
std::vector<std::string> mesh_extensions() {
  std::vector<std::string> extensions{"gz"};
  for (const Format& format : formats()) {
    if (format.read == nullptr) continue;
    for (const auto* const more : {&format.extensions, &format.input_extensions}) {
      extensions.insert(extensions.end(), more->begin(), more->end());
    }
  }
  return extensions;
}

/// Lists formats as ".obj, .ply, MNI's". A format without an extension of its own has the name of its program.
std::string list_mesh_formats() {
  std::vector<std::string> named;
  for (const Format& format : formats()) {
    if (format.read == nullptr) continue;
    const bool has_own = !format.extensions.empty() && format.input_extensions.empty();
    named.push_back(has_own ? "." + format.extensions.back() : fmt::format("{}'s", format.title));
  }
  return fmt::format("{}", fmt::join(named, ", "));
}

/// The options that choose outputs.
const std::vector<std::string> kTargets{"output", "output_dir", "output_format"};

void describe_page(OptionList& list, OutputOptions& output) {
  list.option("view", File{&output.view, Use::write, {"html", "htm"}, &output.views},
              {.help = "Write an interactive page of the result (HTML)",
               .more = "; with \1output_dir\2, \1view\2 takes no name, and each \1input\2 has a page named "
                       "after it",
               .shown = Shown::main});
  list.option("open", Flag{&output.open},
              {.help = "Show the page in the browser ($BROWSER, or else the system's)",
               .more = "; without \1view\2, it is INPUT.gvd.html in the current folder"});
  list.option("up", choice(output.up, kUpAxisNames), {.help = "Axis that points up on the page", .usual = "y"});
  list.excludes("open", {"output_dir"});
  list.rule({"up", {"view", "open"}, [&output](const Given&) -> std::string {
               const bool has_page = !output.view.empty() || output.views || output.open;
               return has_page ? "" : "\1up\2 needs \1view\2 or \1open\2: add one, or leave \1up\2 out";
             }});
}

/// Says why --output-format has no effect. Without a folder, it applies only to standard output and to FreeSurfer's
/// names.
std::string why_no_format(const OutputOptions& output) {
  const auto is_chosen = [&](const std::string& file) { return file == "-" || format_of(output, file) == kFreeSurfer; };
  if (!output.folder.empty() || std::any_of(output.files.begin(), output.files.end(), is_chosen)) return "";
  if (output.prints && !names_file(output)) return "";
  return "\1output_format\2 has no effect here: add \1output=-\2 or \1output_dir\2, or leave "
         "\1output_format\2 out";
}

}  // namespace

void describe_input(OptionList& list, InputOptions& input) {
  list.group("Input");
  list.option("input", File{&input.paths, Use::read, mesh_extensions()},
              {.help = fmt::format("The mesh ({}, also .gz)", list_mesh_formats()),
               .more = ", or - for standard input; several need \1output_dir\2",
               .shown = Shown::main,
               .positional = true,
               .required = true});
  list.option(
      "input_format", choice(input.format, input_format_names()),
      {.help = "Format of the input", .more = "; required with -, otherwise detected from content and extension"});
  list.option("on_defect", choice(input.on_defect, kDefectPolicyNames),
              {.help = "How to treat defects of the mesh",
               .more = ": refuse them, repair them without loss, or repair them and keep only the largest component"});
  list.option("weld", Number{&input.weld, {.least = 0}, {}, 0},
              {.help = "Join vertices at most this far apart",
               .more = "; without a number, those at the same place, as in an STL",
               .unit = "mesh units"});
  list.option("drop_smaller_than", SizeOrPercent{&input.drop_smaller_than},
              {.help = "Leave out components whose bounding box has a smaller diagonal than this",
               .more = ", in mesh units or in percent of the whole mesh's diagonal"});
}

void describe_generators_format(OptionList& list, InputOptions& input) {
  list.group(kGeneratorGroup);
  list.option(
      "generators_format", choice(input.list_format, kGeneratorFormatNames),
      {.help = "Format of the list of \1generators\2", .more = ", otherwise detected from extension and content"});
  list.needs("generators_format", "generators");
}

void describe_resources(OptionList& list, ComputeOptions& compute) {
  describe_threads(list, compute.threads);
  list.option("max_memory", ByteSize{&compute.max_memory},
              {.help = "End the run if it needs more memory than this, as in 500M or 2G"});
}

void describe_verify(OptionList& list, ComputeOptions& compute) {
  list.group(kComputingGroup);
  list.option("verify", Flag{&compute.verify},
              {.help = "After the run, measure the error of the diagram against exact distances"});
}

ValueRule format_rule(const OutputOptions& output, const std::string& option, const Formats& formats,
                      const std::string& reason) {
  return {option, kTargets, [&output, formats, reason](const Given&) -> std::string {
            for (const std::string& format : written_formats(output)) {
              if (contains(formats, format)) return "";
            }
            const bool names_formats = !output.folder.empty() || contains(output.files, "-");
            constexpr std::string_view kOutput = "{output}";
            std::string text = reason;
            const std::size_t at = text.find(kOutput);
            if (at == text.npos) return text;
            return text.replace(at, kOutput.size(), names_formats ? "\1output_format\2" : "\1output\2");
          }};
}

void describe_output(OptionList& list, OutputOptions& output, const Formats& formats, const std::string& usual) {
  list.group("Output");
  list.option("output", File{&output.files, Use::write, formats},
              {.help = "File to write, with an extension of \1output_format\2",
               .more = "; or - for standard output. May be repeated",
               .short_name = "o",
               .shown = Shown::main});
  list.option(
      "output_dir", File{&output.folder, Use::folder},
      {.help = "Process each \1input\2 in turn, and write files named after it to this folder", .shown = Shown::main});
  output.formats = {usual};
  list.option(
      "output_format", ChoiceList{&output.formats, formats},
      {.help = "Format of \1output=-\2 or \1output_dir\2",
       .more = std::string("; \1output_dir\2 takes several, separated by commas") +
               (contains(formats, kFreeSurfer) ? ". With fs, \1output\2 takes any name, such as lh.white" : "")});
  list.option("ascii_ply", Flag{&output.ascii_ply},
              {.help = "Write .ply as text instead of binary",
               .more = "; meshio reads the labels of faces from text, and from .vtu"});
  list.option("report", File{&output.report, Use::write, {"json"}},
              {.help = "Write a report of the run (JSON)", .shown = Shown::main});
  describe_page(list, output);
  list.option("summary", File{&output.summary, Use::write, {"csv"}},
              {.help = "Write a table with a row for each \1input\2 (CSV)"});
  list.excludes("output_dir", {"output", "report"});
  list.needs("summary", "output_dir");
  list.rule({"output_format", {"output", "output_dir"}, [&output](const Given&) { return why_no_format(output); }});
  list.rule(format_rule(output, "ascii_ply", {"ply"},
                        "\1ascii_ply\2: no .ply is written; write one with {output} or leave \1ascii_ply\2 "
                        "out"));
}

void describe_diagram_output(OptionList& list, OutputOptions& output) {
  list.group("Output");
  list.option("diagram", File{&output.diagram, Use::write, {"json"}}, {.help = "Write the diagram (JSON)"});
  list.excludes("diagram", {"output_dir"});
}

void describe_no_curves(OptionList& list, OutputOptions& output) {
  list.group("Output");
  list.option("no_curves", Flag{&output.no_curves},
              {.help = "Leave the bisectors out of " + list_extensions(output_extensions(Content::curves), "and")});
  list.rule(format_rule(output, "no_curves", output_extensions(Content::curves),
                        fmt::format("\1no_curves\2: {} curves; write one of them with {{output}} or leave "
                                    "\1no_curves\2 out",
                                    only_formats(Content::curves))));
}

void describe_target(OptionList& list, OutputOptions& output, const std::string& name, std::string& file,
                     const Formats& extensions, Spec spec) {
  list.group("Output");
  list.option(name, File{&file, Use::write, extensions}, std::move(spec));
  list.excludes(name, {"output_dir"});
  if (extensions.size() > 1) {
    list.rule({name, {}, [name, &file, extensions](const Given&) -> std::string {
                 if (contains(extensions, file_extension(file))) return "";
                 return fmt::format("\1{}\2: {} has no known extension; give a file that ends in {}", name,
                                    user_text(file), list_extensions(extensions, "or"));
               }});
  }
  output.own[name] = &file;
}

}  // namespace gvd::app
