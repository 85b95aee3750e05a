#include "bridge/text/leaves.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proskill::bridge {
namespace {

using Json = nlohmann::json;

constexpr double kLongest = 1e6; // seconds

/// A reader of one text; the first thing that is wrong ends it.
struct Wrong {
  std::string message;
};

/// The number as ProSkill writes it: at most three decimals.
std::expected<std::string, Wrong> seconds(const Json& value, const std::string& where) {
  if (!value.is_number() || value.get<double>() < 0 || value.get<double>() > kLongest)
    return std::unexpected(Wrong{where + " must be a number of seconds, at most 1e6"});
  auto text = fmt::format("{:.3f}", value.get<double>());
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::optional<Wrong> readDuration(const Json& value, const std::string& where, Leaf& leaf) {
  if (!value.is_array() || value.size() != 2)
    return Wrong{where + " must be a list of two numbers, the second one possibly null"};
  const auto least = seconds(value[0], where);
  if (!least) return least.error();
  leaf.least = *least;
  leaf.hasDuration = true;
  if (value[1].is_null()) return std::nullopt;
  const auto most = seconds(value[1], where);
  if (!most) return most.error();
  if (value[0].get<double>() > value[1].get<double>())
    return Wrong{where + ": the second number is less than the first"};
  leaf.most = *most;
  return std::nullopt;
}

std::optional<Wrong> readOutcomes(const Json& value, const std::string& where, Leaf& leaf) {
  leaf.succeeds = leaf.fails = false;
  if (value.is_array())
    for (const auto& outcome : value) {
      if (outcome == "success")
        leaf.succeeds = true;
      else if (outcome == "failure")
        leaf.fails = true;
      else
        return Wrong{where + " may contain \"success\" and \"failure\""};
    }
  if (!leaf.succeeds && !leaf.fails)
    return Wrong{where + " must be a list of \"success\" and \"failure\""};
  return std::nullopt;
}

std::optional<Wrong> readField(const std::string& key, const Json& value, const std::string& where,
                               Leaf& leaf) {
  if (key == "duration") return readDuration(value, where, leaf);
  if (key == "outcomes") return readOutcomes(value, where, leaf);
  if (key == "changes" && value.is_boolean())
    leaf.changes = value.get<bool>();
  else if (key == "kind" && value == "action")
    leaf.isCondition = false;
  else if (key == "kind" && value == "condition")
    leaf.isCondition = true;
  else
    return Wrong{where + " is not a field of a leaf, or has a wrong value"};
  return std::nullopt;
}

std::expected<Leaf, Wrong> readLeaf(const Json& fields, const std::string& name) {
  Leaf leaf;
  if (!fields.is_object()) return std::unexpected(Wrong{"/leaves/" + name + " must be an object"});
  for (const auto& [key, value] : fields.items())
    if (auto wrong = readField(key, value, "/leaves/" + name + "/" + key, leaf))
      return std::unexpected(*wrong);
  return leaf;
}

} // namespace

std::string Leaf::interval() const {
  if (least == "0" && most.empty()) return "";
  return "[" + least + "," + (most.empty() ? "...[" : most + "]");
}

std::expected<Leaves, std::string> Leaves::read(std::string_view text) {
  // Deep nesting cannot exhaust the stack: the parser has a stack of its own.
  const auto json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::unexpected("the file is not JSON");
  if (!json.is_object()) return std::unexpected("the file must contain an object");
  Leaves leaves;
  for (const auto& [key, value] : json.items()) {
    if (key == "tick") {
      const auto tick = seconds(value, "/tick");
      if (!tick) return std::unexpected(tick.error().message);
      if (*tick == "0") return std::unexpected("/tick must be at least 0.001");
      leaves.tick = *tick;
    } else if (key == "leaves" && value.is_object()) {
      for (const auto& [name, fields] : value.items()) {
        const auto leaf = readLeaf(fields, name);
        if (!leaf) return std::unexpected(leaf.error().message);
        leaves.known.emplace(name, *leaf);
      }
    } else {
      return std::unexpected("/" + key + " is not a field of this file, or has a wrong value");
    }
  }
  return leaves;
}

void Leaves::assumeInstant(const std::string& type) {
  const auto [leaf, isNew] = known.try_emplace(type);
  if (isNew) used.insert(type); // the file does not have it
  if (!leaf->second.hasDuration) leaf->second.most = "0";
}

const Leaf& Leaves::of(const std::string& name, const std::string& type) const {
  for (const auto* key : {&name, &type})
    if (const auto found = known.find(*key); !key->empty() && found != known.end()) {
      used.insert(*key);
      return found->second;
    }
  return any;
}

std::vector<std::string> Leaves::unused() const {
  std::vector<std::string> names;
  for (const auto& [name, leaf] : known)
    if (!used.contains(name)) names.push_back(name);
  return names;
}

} // namespace proskill::bridge
