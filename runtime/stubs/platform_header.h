#pragma once

#include <string_view>

/// The headers that libraries include, as texts: stubs come with a copy.
namespace proskill::runtime::header {

extern const std::string_view platformH;
extern const std::string_view platformHpp;

} // namespace proskill::runtime::header
