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
  std::vector<std::string> paths;    ///< of all runs; each is a file, or "-" for standard input
  std::string path;                  ///< of this run
  std::optional<MeshFormat> format;  ///< nothing: content and extension decide
  DefectPolicy on_defect = DefectPolicy::repair;
  std::optional<GeneratorFormat> list_format;  ///< of a file of points; nothing: extension and content decide
  std::optional<double> weld;  ///< tolerance in mesh units, 0 for exact copies; nothing: as usual for the format
  std::optional<ErrorBound> drop_smaller_than;  ///< components that are smaller are left out
};

struct ComputeOptions {
  int threads = 0;  ///< 0: as many as there are cores
  bool verify = false;
  std::optional<std::int64_t> max_memory;  ///< limit for the memory of the process in bytes, > 0
};

struct OutputOptions {
  std::vector<std::string> files;    ///< the extension names the format; "-" is standard output
  std::vector<std::string> formats;  ///< for "-" or for files in `folder`: extensions without their dots
  std::string folder;                ///< the folder for a file for each input and format; empty: none
  std::string report;
  std::string diagram;
  std::string view;
  bool open = false;              ///< show the page of `view` in the browser
  bool views = false;             ///< write a page for each input into `folder`
  std::string summary;            ///< table with a row for each input, with `folder`
  std::optional<UpAxis> up;       ///< of the pages
  bool no_curves = false;         ///< leave the bisectors out of OBJ, VTP and GLB
  bool ascii_ply = false;         ///< PLY as text
  bool prints = false;            ///< write to standard output if no file is named
  bool region_materials = false;  ///< in OBJ, write a material for each region instead of the input's materials
  /// Further files of the command, by the name of the option, such as "stats"; an empty text if the option is not
  /// given.
  std::map<std::string, const std::string*> own;
};

enum class Shell { bash, zsh, fish };

inline const Choices<Shell> kShells{{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}};

/// The options that every command has.
struct GeneralOptions {
  bool short_help = false, help = false, version = false, description = false;  ///< questions
  std::optional<Shell> completion;                                              ///< another question
  std::string config;                                                           ///< the file of options; empty: none
  bool quiet = false, verbose = false;
};

/// Stand for the descriptions of a run that has none, and for no given options.
inline const OptionList kNoOptions;
inline const Given kNothingGiven;

/// The options that all commands share. A command adds its own in a struct that inherits these.
struct Options {
  InputOptions input;
  bool has_diagram = true;  ///< if false, there are no options that sample, compute and write a diagram
  ComputeOptions compute;
  OutputOptions output;
  GeneralOptions general;
  const OptionList* list = &kNoOptions;  ///< describes these options and the command's own, after they were read
  const Given* given = &kNothingGiven;   ///< which of them the user has set
};

/// The seed of random choices; 0 if the command has none.
std::uint64_t seed_of(const Options& options);

/// FreeSurfer calls its surfaces lh.white or rh.pial, so with --output-format this format accepts any name.
inline constexpr const char* kFreeSurfer = "fs";

/// The format of a file of `-o`: its extension, or the format of standard output for "-". A name without a known
/// extension is FreeSurfer's if --output-format says so.
std::string format_of(const OutputOptions& output, const std::string& file);

/// The formats that a run writes to files of `-o`, to standard output, or into the folder.
std::vector<std::string> written_formats(const OutputOptions& output);

/// Whether one of these formats carries some of `any`.
bool writes(const OutputOptions& output, Content any);

/// A file that a run writes, or "-" for standard output.
struct Target {
  std::string option, path;
  bool has_materials = false;  ///< whether it is not the file itself, but the file of materials beside it
};

/// The option with its file, for messages, with placeholders.
std::string name_of(const Target& target);

/// The files that a run writes, except --summary, which belongs to all runs.
std::vector<Target> list_targets(const OutputOptions& output);

/// Whether the options name a file or folder for results.
bool names_file(const OutputOptions& output);

/// Whether a file can be read only once, because it is "-" (standard input), a pipe or a device.
bool is_read_once(const std::string& file);

/// A canonical name, the same for every spelling of a path ("a.ply", "./a.ply", or a link to it, whether or not the
/// file exists). It serves to keep outputs from replacing files that are needed.
std::string one_name(const std::string& path);

/// The extension of `path` in lower case, without its dot; empty if it has none. GIFTI's extensions have two parts.
std::string file_extension(const std::string& path);

bool contains(const std::vector<std::string>& texts, const std::string& text);

}  // namespace gvd::app
