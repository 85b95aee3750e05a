#pragma once

#include <string_view>

/// Texts of the headers that libraries include; stubs come with a copy.
namespace proskill::runtime::header {

extern const std::string_view platformH;
extern const std::string_view platformHpp;

} // namespace proskill::runtime::header
