#pragma once

#include "bridge/text/place.h"

#include <expected>
#include <optional>
#include <string_view>
#include <utility>

namespace proskill::bridge::bt {

struct Element {
  std::string name;
  Place place;
  std::vector<std::pair<std::string, std::string>> attributes; ///< in the order of the text
  std::vector<Element> children;
  std::optional<Place> text; ///< the first one between its children, if there is any

  /// The value of an attribute, or null.
  [[nodiscard]] const std::string* attribute(std::string_view called) const;
};

struct Document {
  Element root;
  bool isWellFormed = true; ///< otherwise it is one that BehaviorTree.CPP reads all the same
};

inline constexpr std::size_t kDeepestXml = 250;
inline constexpr std::size_t kLargestXml = 16 << 20; ///< bytes
inline constexpr std::size_t kMostElements = 200'000;

/// Reads a document in UTF-8, UTF-16, ISO-8859-1 or US-ASCII, as it says; as UTF-8 if it says
/// something else. Declarations of document types, and so of entities, are rejected.
/// \return the document, or the first error
[[nodiscard]] std::expected<Document, Error> readXml(std::string_view text,
                                                     const std::filesystem::path& file);

} // namespace proskill::bridge::bt
