#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gvd/generator_list.hpp"
#include "gvd/io/view.hpp"
#include "gvd/option_list.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/sampling.hpp"
#include "gvd/soup.hpp"
#include "gvd/text.hpp"

// The options of the commands as plain values, with their defaults.
namespace gvd::app {

/// Where the mesh comes from.
struct InputOptions {
  std::vector<std::string> paths;    ///< of all runs; each a file, or "-" for standard input
  std::string path;                  ///< of this run
  std::optional<MeshFormat> format;  ///< nothing: told from content and extension
  DefectPolicy on_defect = DefectPolicy::repair;
  std::optional<GeneratorFormat> list_format;  ///< of a file of points; nothing: told from extension and content
  std::optional<double> weld;  ///< tolerance in mesh units, 0 for exact copies; nothing: as the format asks
  std::optional<ErrorBound> drop_smaller_than;
};

struct ComputeOptions {
  int threads = 0;  ///< 0: one a core
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
  /// Further files of the command by the name of the option, such as "stats"; empty texts where not given.
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

/// The options of a run that describes none, and that none is given.
inline const OptionList kNoOptions;
inline const Given kNothingGiven;

/// The options that the commands share. A command adds its own in a struct that inherits these.
struct Options {
  InputOptions input;
  bool has_diagram = true;  ///< otherwise the options that build, sample and write a diagram are not there
  ComputeOptions compute;
  OutputOptions output;
  GeneralOptions general;
  const OptionList* list = &kNoOptions;  ///< describes these options and those of the command, once they are read
  const Given* given = &kNothingGiven;   ///< what the user set of them
};

/// The seed of the random choices; 0 where the command has none.
std::uint64_t seed_of(const Options& options);

/// FreeSurfer names its surfaces lh.white or rh.pial: for --output-format, this format takes any name.
inline constexpr const char* kFreeSurfer = "fs";

/// The format of a file of `-o`: its extension, or for "-" that of standard output. A name without a known extension is
/// FreeSurfer's, where --output-format says so.
std::string format_of(const OutputOptions& output, const std::string& file);

/// The formats that a run writes to files of `-o`, to standard output, or into the folder.
std::vector<std::string> written_formats(const OutputOptions& output);

/// Whether one of them carries any of `any`.
bool writes(const OutputOptions& output, Content any);

/// A file that a run writes, or "-" for standard output.
struct Target {
  std::string option, path;
  bool has_materials = false;  ///< it is not the file of the option, but has the materials beside it
};

/// The option with its file, for messages: with placeholders.
std::string name_of(const Target& target);

/// The files of a run, of all its options but --summary, which is the last run's.
std::vector<Target> list_targets(const OutputOptions& output);

/// Whether a file or folder is named that gets a result.
bool names_file(const OutputOptions& output);

/// Whether a name stands for what can be read only once: "-", which is standard input, a pipe or a device.
bool is_read_once(const std::string& file);

/// The same name for every spelling of a path ("a.ply", "./a.ply", a link to it, whether or not that exists): no file
/// may replace another that is needed.
std::string one_name(const std::string& path);

/// The extension of `path` in lower case, without its dot; empty where it has none. GIFTI's have two parts.
std::string file_extension(const std::string& path);

bool contains(const std::vector<std::string>& texts, const std::string& text);

}  // namespace gvd::app
