#include "bridge/gen/read/read.h"

#include "bridge/text/file_reader.h"
#include "syntax/text/quote.h"

#include <fmt/format.h>

namespace proskill::bridge::gen {
namespace {

using Interfaces = std::map<std::string, Component, std::less<>>;

auto serviceIn(auto& component, std::string_view name) {
  return std::ranges::find_if(component.services,
                              [&](const Service& service) { return service.name.text == name; });
}

/// A component may say more about a service of an interface, such as its codels.
void refine(Service& own, const Service& declared) {
  if (own.parameters.empty()) own.parameters = declared.parameters;
  if (own.codels.empty()) own.codels = declared.codels;
  append(own.exceptions, declared.exceptions);
  append(own.interrupts, declared.interrupts);
  append(own.before, declared.before);
  append(own.after, declared.after);
}

/// Adds what the interfaces declare that a component or an interface provides.
void provide(Component& component, const Interfaces& interfaces) {
  for (const auto& name : component.provides) {
    const auto found = interfaces.find(name.text);
    if (found == interfaces.end()) continue;
    append(component.exceptions, found->second.exceptions);
    for (const auto& service : found->second.services) {
      const auto own = serviceIn(component, service.name.text);
      if (own == component.services.end())
        component.services.push_back(service);
      else
        refine(*own, service);
    }
  }
}

Error twice(const Word& name, std::string_view what) {
  return {name.place, fmt::format("{} is the name of two {}", syntax::backquoted(name.text), what)};
}

class Checks {
public:
  /// \param isWhole all includes were read, so each name must be declared
  Checks(const Component& component, bool isWhole, Errors& errors)
      : component(component), isWhole(isWhole), errors(errors) {}

  void run() {
    std::set<std::string> names;
    for (const auto& service : component.services) {
      if (!names.insert(service.name.text).second)
        errors.push_back(twice(service.name, "services"));
      for (const auto* list : {&service.interrupts, &service.before, &service.after})
        for (const auto& word : *list) this->service(word);
      for (const auto& word : service.exceptions) exception(word);
      if (service.kind == ServiceKind::Activity) states(service);
    }
  }

private:
  void fail(const Word& word, std::string_view what) {
    errors.push_back({word.place, syntax::backquoted(word.text) + " " + std::string(what)});
  }

  void service(const Word& word) {
    if (isWhole && serviceIn(component, word.text) == component.services.end())
      fail(word, "is not a service of this component");
  }

  void exception(const Word& word) {
    if (isWhole && !has(component.exceptions, word.text))
      fail(word, "is not declared as an exception");
  }

  void states(const Service& service) {
    std::set<std::string> known{"ether"};
    for (const auto& codel : service.codels)
      for (const auto& state : codel.states)
        if (!known.insert(state.text).second) fail(state, "has two codels");
    if (!service.codels.empty() && !known.contains("start"))
      fail(service.name, "has no codel for the state `start`");
    for (const auto& codel : service.codels)
      for (const auto& step : codel.steps)
        if (!known.contains(step.state.text)) fail(step.state, "has no codel");
  }

  const Component& component;
  const bool isWhole;
  Errors& errors;
};

} // namespace

std::expected<Components, Errors> read(const analysis::FileSystem& files,
                                       const std::filesystem::path& root) {
  Components components;
  Interfaces interfaces;
  std::vector<Word> exceptions; // outside of components
  std::set<std::string> interfaceNames;
  std::set<std::string> componentNames;
  Errors errors;
  FileReader reader(files, parse, [&](Parsed parsed) {
    append(exceptions, parsed.exceptions);
    append(components.ignored, parsed.ignored);
    for (auto& component : parsed.components) {
      provide(component, interfaces);
      auto& names = component.isInterface ? interfaceNames : componentNames;
      if (!names.insert(component.name.text).second)
        errors.push_back(
            twice(component.name, component.isInterface ? "interfaces" : "components"));
      else if (component.isInterface)
        interfaces.emplace(component.name.text, component);
      else
        components.all.push_back(std::move(component));
    }
  });
  reader.root(root);
  reader.errors.insert(reader.errors.end(), errors.begin(), errors.end());
  for (auto& component : components.all) append(component.exceptions, exceptions);
  for (const auto& component : components.all)
    Checks(component, reader.missing.empty(), reader.errors).run();
  if (components.all.empty() && reader.errors.empty())
    reader.errors.push_back({{root, 1, 1}, "there is no `component`"});
  if (!reader.errors.empty()) return std::unexpected(std::move(reader.errors));
  components.missing = std::move(reader.missing);
  return components;
}

} // namespace proskill::bridge::gen
