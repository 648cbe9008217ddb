#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/reading/stored_numbers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {

/// Numbers of an accessor: `size` for each of its elements.
struct Accessor {
  std::vector<double> numbers;
  std::size_t size = 1;
};

/// A glTF file: its description, and the numbers of its buffers. The bytes must outlive it.
///
/// All functions throw Error{unreadable_input} that begins with `name`, and the exceptions of nlohmann::json where a
/// member is missing or has another type. Every buffer is read once.
class GltfFile {
 public:
  /// `folder`: where files with buffers lie, if they may be read (see read_gltf_buffer).
  GltfFile(std::string_view bytes, std::string_view name, const std::optional<std::filesystem::path>& folder);

  const nlohmann::json& description() const { return gltf_; }
  const std::string& name() const { return name_; }
  /// Counts what the file unfolds to.
  void spend(std::uint64_t bytes) { limit_.spend(bytes); }

  /// A list of the description; empty where there is none.
  const nlohmann::json& array(const char* key) const;
  const nlohmann::json& item(const char* key, std::size_t i) const;
  /// A member that is a whole number from 0.
  std::size_t number(const nlohmann::json& object, const char* key, std::optional<std::size_t> otherwise = {}) const;
  /// A value that is a whole number from 0.
  std::size_t index(const nlohmann::json& value, const char* what) const;
  /// Numbers or vectors of two or three numbers; those that stand for fractions are divided, -128 as -127.
  Accessor read_accessor(std::size_t a);
  /// The files beside this one that it refers to, with buffers and images.
  std::vector<std::filesystem::path> other_files() const;

  [[noreturn]] void refuse(const std::string& message) const;

 private:
  std::uint32_t word(std::size_t at) const;
  std::string_view read_chunks();
  void check_version() const;
  StoredNumber stored_number(std::size_t component_type) const;
  std::string_view find_buffer(std::size_t b);
  std::string_view find_view(std::size_t v);

  std::string_view bytes_, binary_;
  bool is_binary_ = false;
  std::string name_;
  std::optional<std::filesystem::path> folder_;
  ExpansionLimit limit_;
  nlohmann::json gltf_;
  std::map<std::size_t, std::string_view> buffers_;
  std::map<std::string_view, std::string> contents_;  // by address, which `gltf_` holds
};

}  // namespace gvd
