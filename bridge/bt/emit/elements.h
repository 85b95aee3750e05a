#pragma once

#include "bridge/bt/read/xml.h"

namespace proskill::bridge::bt {

using Attributes = std::vector<std::pair<std::string, std::string>>;

[[nodiscard]] Element element(std::string name, Attributes attributes = {},
                              std::vector<Element> children = {});
/// `AlwaysSuccess` or `AlwaysFailure`.
[[nodiscard]] Element constant(bool succeeds);
/// A `Sequence`, or a `Fallback`, of two parts. Neither nests in its own kind.
[[nodiscard]] Element inOrder(bool isSequence, Element first, Element second);
/// A node with other results than those of its child.
[[nodiscard]] Element withResults(Element child, bool onSuccess, bool onFailure);
/// One part where the test succeeds, the other one where it fails.
[[nodiscard]] Element decide(Element test, Element onSuccess, Element onFailure);
/// The number of elements within each other.
[[nodiscard]] std::size_t depthOf(const Element& root);
/// A document, with two spaces for each level.
[[nodiscard]] std::string writeXml(const Element& root);

} // namespace proskill::bridge::bt
