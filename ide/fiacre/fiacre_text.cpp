#include "ide/fiacre/fiacre_text.h"

#include "fiacre/syntax/lexer.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using fiacre::Block;
using fiacre::Mention;
using fiacre::NameKind;

/// Whether a declaration of one kind can match a mention of another.
bool fits(NameKind declared, NameKind mentioned) {
  if (declared == mentioned) return true;
  switch (mentioned) {
  case NameKind::Process: return declared == NameKind::Component;
  case NameKind::Port: return declared == NameKind::Event;
  case NameKind::Value:
    switch (declared) {
    case NameKind::Variable:
    case NameKind::Parameter:
    case NameKind::Port:
    case NameKind::Constant:
    case NameKind::Constructor:
    case NameKind::Function:
    case NameKind::Extern:
    case NameKind::Event: return true;
    default: return false;
    }
  default: return false;
  }
}

} // namespace

bool isLocalName(NameKind kind) {
  switch (kind) {
  case NameKind::State:
  case NameKind::Variable:
  case NameKind::Parameter:
  case NameKind::Port:
  case NameKind::Tag: return true;
  default: return false;
  }
}

FiacreText::FiacreText(std::string_view read)
    : text(read), parsed(fiacre::parse(read)), words(fiacre::tokenizeWithComments(read)) {
  resolve();
}

std::string_view FiacreText::nameOf(const Mention& mention) const {
  return text.substr(mention.begin, mention.end - mention.begin);
}

const Block* FiacreText::blockOf(const Mention& mention) const {
  const auto behind = std::ranges::upper_bound(parsed.blocks, mention.begin, {}, &Block::begin);
  if (behind == parsed.blocks.begin()) return nullptr;
  const auto& block = behind[-1];
  return mention.end <= block.end ? &block : nullptr;
}

FiacreText::Place FiacreText::mentionAt(syntax::Offset at) const {
  const auto found = std::ranges::find_if(
      mentions(), [&](const Mention& each) { return each.begin <= at && at <= each.end; });
  if (found == mentions().end()) return kNowhere;
  // of two tokens that touch, the one that begins here
  const auto next = found + 1;
  const bool second = next != mentions().end() && next->begin == at;
  return static_cast<Place>((second ? next : found) - mentions().begin());
}

const std::vector<FiacreText::Place>& FiacreText::declarationsOf(std::string_view name) const {
  static const std::vector<Place> none;
  const auto found = byName.find(name);
  return found == byName.end() ? none : found->second;
}

FiacreText::Place FiacreText::declaredIn(const Block& block, std::string_view name,
                                         NameKind kind) const {
  for (const auto i : declarationsOf(name))
    if (isLocalName(mentions()[i].kind) && blocks[i] == &block && fits(mentions()[i].kind, kind))
      return i;
  return kNowhere;
}

FiacreText::Place FiacreText::declaredGlobally(std::string_view name, NameKind kind) const {
  for (const auto i : declarationsOf(name))
    if (!isLocalName(mentions()[i].kind) && fits(mentions()[i].kind, kind)) return i;
  return kNowhere;
}

/// The process or component with this name.
const Block* FiacreText::blockNamed(std::string_view name) const {
  const auto place = declaredGlobally(name, NameKind::Process);
  return place == kNowhere ? nullptr : blocks[place];
}

/// The block that a path of positions in `par` leads to, from the model or an observer.
const Block* FiacreText::atPath(const fiacre::PathTaken& path) const {
  const auto& observers = parsed.program.observers;
  const bool observes =
      std::ranges::find(observers, path.begins, &fiacre::Attachment::observer) != observers.end();
  std::string_view name = observes ? path.begins : parsed.program.main;
  const std::vector<fiacre::Instance>* within = nullptr;
  for (const auto step : path.places) {
    const auto& components = parsed.program.components;
    if (!within) {
      const auto found = std::ranges::find(components, name, &fiacre::Component::name);
      if (found == components.end()) return nullptr;
      within = &found->instances;
    }
    if (step > within->size()) return nullptr;
    const auto& part = (*within)[step - 1];
    name = part.process;
    within = part.parts.empty() ? nullptr : &part.parts;
  }
  return within ? nullptr : blockNamed(name);
}

FiacreText::Place FiacreText::find(const Mention& mention) const {
  const auto name = nameOf(mention);
  const auto* block = mention.path != 0 ? atPath(parsed.paths[mention.path]) : blockOf(mention);
  if (block)
    if (const auto local = declaredIn(*block, name, mention.kind); local != kNowhere) return local;
  return declaredGlobally(name, mention.kind);
}

void FiacreText::resolve() {
  for (Place i = 0; i < mentions().size(); ++i) {
    blocks.push_back(blockOf(mentions()[i]));
    if (mentions()[i].declares) byName[nameOf(mentions()[i])].push_back(i);
  }
  // a tag is declared by its first mention, so declarations are searched, too
  for (Place i = 0; i < mentions().size(); ++i) {
    const auto& mention = mentions()[i];
    const bool known = mention.declares && mention.kind != NameKind::Tag;
    declarations.push_back(known ? i : find(mention));
  }
}

std::optional<syntax::Range> FiacreText::definition(syntax::Offset at) const {
  const auto place = mentionAt(at);
  if (place == kNowhere || declarations[place] == kNowhere) return std::nullopt;
  const auto& found = mentions()[declarations[place]];
  return syntax::Range{found.begin, found.end};
}

std::vector<FiacreText::Use> FiacreText::uses(syntax::Offset at, bool withDeclaration) const {
  const auto place = mentionAt(at);
  if (place == kNowhere || declarations[place] == kNowhere) return {};
  std::vector<Use> result;
  for (Place i = 0; i < mentions().size(); ++i) {
    const auto& each = mentions()[i];
    const bool declares = i == declarations[place];
    if (declarations[i] == declarations[place] && (withDeclaration || !declares))
      result.push_back({{each.begin, each.end}, declares});
  }
  return result;
}

std::optional<syntax::Range> FiacreText::model() const {
  const auto isModel = [&](const Mention& each) {
    return !each.declares && each.kind == NameKind::Component && each.path == 0 &&
           nameOf(each) == parsed.program.main && !blockOf(each);
  };
  const auto found = std::ranges::find_if(mentions(), isModel);
  if (found == mentions().end()) return std::nullopt;
  return syntax::Range{found->begin, found->end};
}

std::vector<syntax::Range> FiacreText::asserted() const {
  std::vector<syntax::Range> result;
  for (const auto& each : mentions()) {
    if (!each.declares || each.kind != NameKind::Property) continue;
    const auto& properties = parsed.program.properties;
    const auto property = std::ranges::find(properties, nameOf(each), &fiacre::Property::name);
    if (property != properties.end() && property->asserted)
      result.push_back({each.begin, each.end});
  }
  return result;
}

} // namespace proskill::ide
