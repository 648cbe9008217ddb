#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/view.hpp"
#include "gvd/option_list.hpp"
#include "gvd/sampling.hpp"
#include "gvd/soup.hpp"

// The options of the commands as plain values, with their defaults.
namespace gvd::app {

/// Where the mesh comes from.
struct InputOptions {
  std::vector<std::string> paths;    ///< of all runs; each a file, or "-" for standard input
  std::string path;                  ///< of this run
  std::optional<MeshFormat> format;  ///< nothing: told from content and extension
  DefectPolicy on_defect = DefectPolicy::repair;
  std::optional<double> weld;  ///< tolerance in mesh units, 0 for exact copies; nothing: as the format asks
};

/// What the command line calls a list of points, for messages.
struct ListNames {
  std::string file = "--generators", vertices = "--vertices";  ///< the options that name it
  std::string points = "generators";
};

/// Where the generators come from: exactly one of count, file, vertices, curves, radius, target_edge, error and
/// implied_count is set.
struct GeneratorOptions {
  ListNames names;
  std::optional<std::int32_t> count;       ///< >= 1
  Sampling sampling = Sampling::farthest;  ///< of `count` ones
  std::uint64_t seed = 0;
  std::string file;                                   ///< a list of generators, or "-" for standard input
  std::optional<GeneratorFormat> format;              ///< of the list; nothing: told from extension and content
  std::optional<std::vector<std::int64_t>> vertices;  ///< 0-based indices of the input file's vertices
  std::string curves;                                 ///< a file of curves, boundary or creases[:ANGLE]; empty: points
  std::optional<double> radius;                       ///< covering radius in mesh units, > 0
  std::optional<double> target_edge;                  ///< of a mesh of the generators, mesh units, > 0
  std::optional<ErrorBound> error;                    ///< as many as a mesh of them needs
  std::optional<double> max_snap;                     ///< largest snap distance allowed, mesh units, >= 0
  bool merge_coincident = false;
  std::optional<std::int32_t> implied_count;  ///< of --per-region and --levels, in place of `count`

  /// How many are to be sampled; nothing where no option says so.
  std::optional<std::int32_t> wanted() const { return count ? count : implied_count; }
  /// Whether the generators are those of a list: where the user wants them.
  bool are_listed() const { return vertices || !file.empty(); }
};

struct ComputeOptions {
  DiagramOptions diagram;  ///< its threads are those of the whole run
  bool verify = false;
  std::optional<std::int64_t> max_memory;  ///< bytes that the process may hold, > 0
};

struct OutputOptions {
  std::vector<std::string> files;    ///< the extension names the format; "-" is standard output
  std::vector<std::string> formats;  ///< of "-" or in `folder`: extensions without their dots
  std::string folder;                ///< gets a file for each input and format; empty: none
  std::string report;
  std::string diagram;
  std::string view;
  bool open = false;              ///< show the page of `view` in the browser
  bool views = false;             ///< into `folder`, a page for each input
  std::string summary;            ///< a row for each input of `folder`
  std::optional<UpAxis> up;       ///< of the pages
  bool no_curves = false;         ///< leave the bisectors out of OBJ, VTP and GLB
  bool ascii_ply = false;         ///< PLY as text
  bool prints = false;            ///< to standard output, where no file is named
  bool region_materials = false;  ///< in OBJ, a material for each region, not those of the input
  /// Further files of the command by the option, such as "--stats"; empty texts where not given.
  std::map<std::string, const std::string*> own;
};

enum class Shell { bash, zsh, fish };

inline const Choices<Shell> kShells{{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}};

/// The options that every command has.
struct GeneralOptions {
  bool short_help = false, help = false, version = false, description = false;  ///< questions
  std::optional<Shell> completion;                                              ///< another one
  std::string config;                                                           ///< the file of options; empty: none
  bool quiet = false, verbose = false;
};

/// The options that the commands share. A command adds its own in a struct that inherits these.
struct Options {
  InputOptions input;
  GeneratorOptions generators;
  GeneratorOptions targets;  ///< a list of points that distances are asked for
  bool has_diagram = true;   ///< otherwise the options that build, sample and write a diagram are not there
  ComputeOptions compute;
  OutputOptions output;
  GeneralOptions general;
  const OptionList* list = nullptr;  ///< describes these options and those of the command; null before they are read
  const Given* given = nullptr;      ///< what the user set of them
};

/// FreeSurfer names its surfaces lh.white or rh.pial: for --output-format, this format takes any name.
inline constexpr const char* kFreeSurfer = "fs";

/// The format of a file of `-o`: its extension, or for "-" that of standard output. A name without a known extension is
/// FreeSurfer's, where --output-format says so.
std::string format_of(const OutputOptions& output, const std::string& file);

/// The formats that a run writes to files of `-o`, to standard output, or into the folder.
std::vector<std::string> written_formats(const OutputOptions& output);

/// A file that a run writes, or "-" for standard output.
struct Target {
  std::string option, path;
};

/// The files of a run, of all its options but --summary, which is the last run's.
std::vector<Target> list_targets(const OutputOptions& output);

/// Whether a file or folder is named that gets a result.
bool names_file(const OutputOptions& output);

/// A value for the report; null where it is not given, or a text is empty.
template <class T, class Json = nlohmann::ordered_json>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

/// Whether a name stands for what can be read only once: "-", which is standard input, a pipe or a device.
bool is_read_once(const std::string& file);

/// The extension of `path` in lower case, without its dot; empty where it has none. GIFTI's have two parts.
std::string file_extension(const std::string& path);

bool contains(const std::vector<std::string>& texts, const std::string& text);

/// A text of the user's for a message: blanks for control characters, and "..." after `longest` bytes.
std::string printable(std::string text, std::size_t longest = 60);

}  // namespace gvd::app
