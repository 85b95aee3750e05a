#include "report/sources.h"

#include "syntax/text/source.h"
#include "syntax/text/utf8.h"

namespace proskill::report {

std::string sourceDigest(std::string_view text) {
  return syntax::digestOf(syntax::withoutByteOrderMark(text));
}

OrderedJson sourcesJson(const analysis::Program& program) {
  OrderedJson json = OrderedJson::object();
  for (const auto& file : program.files)
    json[file.path.generic_string()] = sourceDigest(file.document.text());
  return json;
}

std::vector<std::string> editedSources(const OrderedJson& trace, const TextOfFile& textOf) {
  std::size_t left =
      1'000; // programs have fewer files; a trace of somebody else may name any number
  std::vector<std::string> edited;
  const auto sources = trace.is_object() ? trace.find("sources") : trace.end();
  if (sources == trace.end() || !sources->is_object()) return edited;
  for (const auto& [file, digest] : sources->items()) {
    if (!digest.is_string()) continue;
    if (left-- == 0) break;
    const auto text = textOf(file);
    if (text && sourceDigest(*text) != digest.get_ref<const std::string&>()) edited.push_back(file);
  }
  return edited;
}

} // namespace proskill::report
