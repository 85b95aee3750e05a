#include "cli/output/difference_report.h"

#include "tina/versions.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace proskill::cli {

namespace {

/// Text in a fence that is longer than any in the text.
std::string fenced(std::string_view text, std::string_view language = "") {
  constexpr std::size_t kMost = 200'000;
  std::string cut(text.substr(0, kMost));
  if (text.size() > kMost) cut += fmt::format("\n[{} more bytes]", text.size() - kMost);
  std::string fence = "```";
  while (cut.find(fence) != std::string::npos) fence += '`';
  return fmt::format("{}{}\n{}{}{}\n\n", fence, language, cut, cut.ends_with('\n') ? "" : "\n",
                     fence);
}

std::string table(const std::vector<Difference>& differences) {
  std::string text = "| property | the engine | Tina |\n| --- | --- | --- |\n";
  for (const auto& difference : differences)
    text += fmt::format("| {} | {} | {} |\n",
                        difference.property.empty() ? "(the model)" : difference.property,
                        difference.engine, difference.tina);
  return text + "\n";
}

std::string saidBy(const std::vector<tina::Call>& calls) {
  std::string text;
  for (const auto& call : calls) {
    text += fmt::format("`{}` {}.\n\n", call.command, call.ended);
    if (!call.out.empty()) text += fenced(call.out);
    if (!call.err.empty()) text += "On standard error:\n\n" + fenced(call.err);
  }
  return text;
}

std::string asText(const report::VerifyReport& report) {
  std::ostringstream out;
  writeText(out, report, false);
  return out.str();
}

} // namespace

std::vector<Difference> differencesBetween(const ide::VerificationReport& engine,
                                           const ide::VerificationReport& tina) {
  std::vector<Difference> all;
  for (std::size_t i = 0; i < engine.rows.size(); ++i) {
    const auto& ours = engine.rows[i];
    const auto& theirs = tina.rows[i];
    const auto verdict = [](const ide::VerdictRow& row) {
      return std::string(ide::toString(row.verdict));
    };
    if (ours.verdict == ide::Verdict::Inconclusive || theirs.verdict == ide::Verdict::Inconclusive)
      continue;
    if (ours.verdict != theirs.verdict)
      all.push_back({ours.check->name, verdict(ours), verdict(theirs)});
    else if (ours.trace && !theirs.trace && !theirs.reason.empty())
      all.push_back({ours.check->name, verdict(ours) + ", with a trace",
                     verdict(theirs) + ", but " + theirs.reason});
  }
  return all;
}

std::string agreement(const ide::VerificationReport& engine, const ide::VerificationReport& tina) {
  std::size_t compared = 0;
  for (std::size_t i = 0; i < engine.rows.size(); ++i)
    if (engine.rows[i].verdict != ide::Verdict::Inconclusive &&
        tina.rows[i].verdict != ide::Verdict::Inconclusive)
      ++compared;
  const auto all = engine.rows.size();
  auto text = fmt::format("the engine and Tina agree on {} of {} properties", compared, all);
  if (compared < all) text += fmt::format("; {} cannot be compared", all - compared);
  return text;
}

std::string namesOf(const std::vector<Difference>& differences) {
  constexpr std::size_t kFew = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(kFew, differences.size()); ++i)
    text += (i == 0 ? "" : ", ") +
            (differences[i].property.empty() ? "the model" : differences[i].property);
  if (differences.size() > kFew) text += fmt::format(" and {} more", differences.size() - kFew);
  return text;
}

std::string differenceReport(const report::VerifyReport& engine, const TinaRun& tina,
                             const std::vector<Difference>& differences) {
  const bool failed = !tina.said;
  const auto& calls = failed ? tina.said.error().calls : tina.said->outcome.calls;
  std::string text = "# The engine of ProSkill and Tina differ\n\n" + table(differences);
  text += "## Versions\n\n- ProSkill " PROSKILL_VERSION "\n";
  for (const auto& line : tina::versions(tina.tools)) text += "- " + line + "\n";
  text += "\n## The program\n\n";
  for (const auto& file : engine.program.files)
    text += fmt::format("{}:\n\n{}", file.path.generic_string(), fenced(file.document.text()));
  text += "## The model that the tools were given\n\n";
  text += fenced(failed ? tina.said.error().model : tina.said->outcome.model);
  text += "## What the engine says\n\n" + fenced(asText(engine));
  if (!failed)
    text += "## What is read from Tina's output\n\n" +
            fenced(asText({engine.program, engine.model, tina.said->report, engine.mainSkill}));
  text += "## What Tina says\n\n" + saidBy(calls);
  return text;
}

std::filesystem::path unusedName(const std::filesystem::path& path) {
  std::error_code error;
  auto free = path;
  for (int i = 2; std::filesystem::exists(free, error); ++i)
    free = path.parent_path() /
           fmt::format("{}-{}{}", path.stem().string(), i, path.extension().string());
  return free;
}

} // namespace proskill::cli
