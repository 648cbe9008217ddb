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

/// The numbers of an accessor, `size` for each of its elements.
struct Accessor {
  std::vector<double> numbers;
  std::size_t size = 1;
};

/// A glTF file: its description, and the numbers of its buffers. The bytes must outlive it.
///
/// All functions throw Error{unreadable_input} with a message that begins with `name`, and the exceptions of
/// nlohmann::json if a member is missing or has a wrong type. Every buffer is read only once.
class GltfFile {
 public:
  /// `folder`: where files with buffers lie, if they may be read (see `read_gltf_buffer`).
  GltfFile(std::string_view bytes, std::string_view name, const std::optional<std::filesystem::path>& folder);

  const nlohmann::json& description() const { return gltf_; }
  const std::string& name() const { return name_; }
  /// Counts bytes that the file expands to.
  void spend(std::uint64_t bytes) { limit_.spend(bytes); }

  /// The array `key` of the description; empty if there is none.
  const nlohmann::json& array(const char* key) const;
  const nlohmann::json& item(const char* key, std::size_t i) const;
  /// A member that must be a whole number from 0, or `otherwise` if it is missing.
  std::size_t number(const nlohmann::json& object, const char* key, std::optional<std::size_t> otherwise = {}) const;
  /// A value that must be a whole number from 0.
  std::size_t index(const nlohmann::json& value, const char* what) const;
  /// Reads an accessor of numbers, or of vectors of two or three numbers. Normalized integers are converted to
  /// fractions; -128 counts as -127.
  Accessor read_accessor(std::size_t a);
  /// The other files to which it refers for buffers and images.
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
  std::map<std::string_view, std::string> contents_;  // by address; `gltf_` owns the addresses
};

}  // namespace gvd
