#include "tests/analysis/findings.h"

#include "tests/support/memory_files.h"

namespace proskill::test {

namespace {

std::string_view letter(syntax::Severity severity) {
  switch (severity) {
  case syntax::Severity::Error: return "";
  case syntax::Severity::Warning: return "W";
  case syntax::Severity::Hint: return "H";
  }
  return "";
}

std::vector<syntax::Diagnostic> foundIn(const analysis::Program& program) {
  auto found = analysis::check(program);
  std::erase_if(
      found, [](const syntax::Diagnostic& it) { return syntax::info(it.code).id >= kFirstOfFlow; });
  return found;
}

std::string list(const analysis::Program& program) {
  std::string text;
  for (const syntax::Diagnostic& it : foundIn(program)) {
    const analysis::File& file = program.files[it.location.file];
    const auto range = it.location.range;
    if (!text.empty()) text += ", ";
    if (it.location.file != 0) text += file.path.generic_string() + ": ";
    text.append(syntax::info(it.code).id).append(letter(it.severity)).append(" ");
    text += file.document.text().substr(range.begin, range.length());
  }
  return text;
}

} // namespace

std::string findings(std::string text, analysis::Extent extent) {
  return list(analysis::load(MemoryFiles(), "main.proskill",
                             syntax::Document::parse(std::move(text)), extent));
}

std::string findings(std::map<std::string, std::string> files) {
  return list(analysis::load(MemoryFiles(std::move(files)), "main.proskill"));
}

std::vector<syntax::Diagnostic> diagnose(std::string text) {
  return analysis::check(
      analysis::load(MemoryFiles(), "main.proskill", syntax::Document::parse(std::move(text))));
}

const std::string kWorld = R"(
(defsv battery :states (Good Low Critical) :init Good)
(defsv camera :states (Off Low High) :init Off)
(defsv level :init 1 :min 1 :max 3)
(defevent drained :effects (battery Low))
(defevent charged :effects (battery Good))
(defresource arm)
(defskill takeoff
  :input ($height float $duration float)
  :action (takeoff $height $duration)
  :success at_altitude
  :failure (grounded emergency))
(defskill survey
  :invariant (powered (:guard (~ (battery Critical))))
  :action (survey)
  :interrupt (:effects (camera Off)))
)";

std::string mission(const std::string& statements) {
  return kWorld + "(defskill mission :success done :failure lost :body (" + statements + "))\n";
}

} // namespace proskill::test
