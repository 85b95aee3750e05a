#pragma once

#include <string_view>

/// Texts of the headers that libraries include; stubs come with a copy.
namespace proskill::runtime::header {

extern const std::string_view platformH;
extern const std::string_view platformHpp;
extern const std::string_view hostH; ///< of a project for Hippo
extern const std::string_view hostC;
extern const std::string_view typesTxt;
extern const std::string_view mainC;

} // namespace proskill::runtime::header
