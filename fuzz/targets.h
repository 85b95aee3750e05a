#pragma once

#include <string_view>

/// What must be true whatever bytes come. Each function throws where it is not; libFuzzer looks for
/// such bytes, and tests/fuzz/ tries those that were found.
namespace proskill::fuzz {

/// As a program: read, checked, laid out, edited.
void proskill(std::string_view bytes);
/// As a model in Fiacre: read, checked, printed, laid out.
void fiacre(std::string_view bytes);
/// As what a client sends to the language server. The first byte says into how large pieces the
/// rest is cut.
void protocol(std::string_view bytes);

/// As what a browser sends to `proskill view`.
void http(std::string_view bytes);
/// As what the tools of the Tina toolbox write.
void tina(std::string_view bytes);

/// \throws std::logic_error where something is not as it must be
void expect(bool condition, std::string_view what);

} // namespace proskill::fuzz
