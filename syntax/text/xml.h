#pragma once

#include <string>
#include <string_view>

/// Texts in XML (Extensible Markup Language 1.0, fifth edition). Characters that XML cannot hold,
/// and bytes that are not UTF-8, become U+FFFD.
namespace proskill::syntax {

/// A text between tags. Line ends and tabs stay what they are.
[[nodiscard]] std::string xmlText(std::string_view text);

/// The value of an attribute between double quotes. Line ends and tabs become references, since
/// parsers replace them by spaces otherwise (section 3.3.3).
[[nodiscard]] std::string xmlAttribute(std::string_view text);

} // namespace proskill::syntax
