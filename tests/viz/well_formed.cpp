#include "tests/viz/well_formed.h"

#include "viz/dot/label.h"

#include <regex>
#include <string_view>
#include <vector>

namespace proskill::viz::test {
namespace {

const std::string kName = "[A-Za-z_:][-A-Za-z0-9_:.]*";
const std::regex kOpen("^<(" + kName + ")(\\s+" + kName + "=\"[^<\"]*\")*\\s*(/?)>$");
const std::regex kClose("^</(" + kName + ")\\s*>$");
const std::regex kEntity("^&(#[0-9]+|#x[0-9A-Fa-f]+|amp|lt|gt|quot|apos);");

/// Every `&` begins an entity of XML.
bool entitiesAreGood(std::string_view text) {
  for (auto at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
    const std::string rest(text.substr(at, 12));
    if (!std::regex_search(rest, kEntity)) return false;
  }
  return true;
}

std::string readTag(const std::string& tag, std::vector<std::string>& open) {
  std::smatch match;
  if (std::regex_match(tag, match, kClose)) {
    if (open.empty() || open.back() != match[1]) return "closes nothing: " + tag;
    open.pop_back();
    return "";
  }
  if (!std::regex_match(tag, match, kOpen)) return "no tag: " + tag;
  if (match[3].length() == 0) open.push_back(match[1]);
  return "";
}

} // namespace

std::string whyNotWellFormed(const std::string& xml) {
  std::string lines = xml;
  for (auto& c : lines)
    if (c == '\n') c = ' ';
  if (clean(lines) != lines) return "a character that XML has not";
  if (!entitiesAreGood(xml)) return "an entity that XML has not";
  std::vector<std::string> open;
  bool root = false;
  for (std::size_t at = 0; (at = xml.find('<', at)) != std::string::npos;) {
    const std::string_view rest = std::string_view(xml).substr(at);
    const bool comment = rest.starts_with("<!--");
    const auto end = comment ? rest.find("-->") : rest.find('>');
    if (end == std::string_view::npos) return "a tag has no end";
    const std::string tag(rest.substr(0, end + (comment ? 3 : 1)));
    at += tag.size();
    if (comment && tag.find("--", 4) != tag.size() - 3) return "-- in a comment";
    if (comment || tag.starts_with("<?") || tag.starts_with("<!DOCTYPE")) continue;
    if (open.empty() && root) return "two roots";
    root = true;
    if (auto why = readTag(tag, open); !why.empty()) return why;
  }
  return root && open.empty() ? "" : "a tag is left open";
}

} // namespace proskill::viz::test
