#pragma once

#include "bridge/text/place.h"

#include <expected>
#include <string_view>
#include <utility>

namespace proskill::bridge::bt {

struct Element {
  std::string name;
  Place place;
  std::vector<std::pair<std::string, std::string>> attributes; ///< in the order of the text
  std::vector<Element> children;

  /// The value of an attribute, or null.
  [[nodiscard]] const std::string* attribute(std::string_view called) const;
};

inline constexpr std::size_t kDeepestXml = 250;
inline constexpr std::size_t kLargestXml = 16 << 20; ///< bytes
inline constexpr std::size_t kMostElements = 200'000;

/// Reads a document. Declarations of document types, and so of entities, are rejected; what is
/// between the elements must be white space or comments, but for the descriptions in models.
/// \return the root element, or the first error
[[nodiscard]] std::expected<Element, Error> readXml(std::string_view text,
                                                    const std::filesystem::path& file);

} // namespace proskill::bridge::bt
