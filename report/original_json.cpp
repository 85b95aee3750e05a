#include "report/original_json.h"

#include "report/uri.h"

namespace proskill::report {

OrderedJson originalJson(const analysis::Original& original) {
  return {{"file", original.file.generic_string()},
          {"line", original.line},
          {"column", original.column},
          {"what", original.what}};
}

OrderedJson sarifOriginal(const analysis::Original& original) {
  const OrderedJson region{{"startLine", original.line}, {"startColumn", original.column}};
  return {{"physicalLocation",
           {{"artifactLocation", {{"uri", toUriReference(original.file)}}}, {"region", region}}},
          {"message", {{"text", "from here: " + original.what}}}};
}

} // namespace proskill::report
