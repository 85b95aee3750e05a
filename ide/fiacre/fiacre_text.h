#pragma once

#include "fiacre/syntax/parse.h"
#include "ide/answers/fold.h"
#include "ide/answers/hover.h"
#include "ide/answers/token.h"
#include "ide/completion/completion.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Editor features for Fiacre texts; each is a function of the text and a place. A text with syntax
/// errors is answered as far as possible.
namespace proskill::ide {

/// Whether names of this kind are visible only in their process, component or function.
[[nodiscard]] bool isLocalName(fiacre::NameKind kind);

/// An entry of a text's outline.
struct FiacreEntry {
  std::string name;
  std::string detail; ///< a type, or the number of ports
  fiacre::NameKind kind = fiacre::NameKind::Process;
  syntax::Range range;     ///< of the whole declaration
  syntax::Range selection; ///< of its name, within `range`
  std::vector<FiacreEntry> children;
};

/// A parsed text with the declaration of each name.
class FiacreText {
public:
  /// \param text must outlive this
  explicit FiacreText(std::string_view text);
  FiacreText(const FiacreText&) = delete;
  FiacreText& operator=(const FiacreText&) = delete;

  /// The declaration of the name at a place; the place may be just after the name.
  [[nodiscard]] std::optional<syntax::Range> definition(syntax::Offset at) const;

  /// All places of the name, in the order of the text; its declaration only on request.
  struct Use {
    syntax::Range range;
    bool declares = false;
  };
  [[nodiscard]] std::vector<Use> uses(syntax::Offset at, bool withDeclaration) const;

  /// For each name in the order of the text: the index of its declaration, or kNowhere.
  [[nodiscard]] const std::vector<std::size_t>& meanings() const { return declarations; }

  /// The name of the model's main component where it is named as such; nothing if the text names
  /// none.
  [[nodiscard]] std::optional<syntax::Range> model() const;
  /// The declarations of the asserted properties.
  [[nodiscard]] std::vector<syntax::Range> asserted() const;

  /// The declaration and the comment above it.
  [[nodiscard]] std::optional<Hover> hover(syntax::Offset at) const;
  [[nodiscard]] std::vector<FiacreEntry> outline() const;
  [[nodiscard]] std::vector<Token> tokens() const;
  [[nodiscard]] std::vector<Fold> folds() const;
  /// The keywords, and the names that are visible at a place.
  [[nodiscard]] Completions complete(syntax::Offset at, CompletionTrigger trigger = {}) const;

private:
  using Place = std::size_t; ///< index in `mentions()`
  static constexpr Place kNowhere = static_cast<Place>(-1);

  [[nodiscard]] const std::vector<fiacre::Mention>& mentions() const { return parsed.mentions; }
  [[nodiscard]] std::string_view nameOf(const fiacre::Mention& mention) const;
  [[nodiscard]] Place mentionAt(syntax::Offset at) const;
  [[nodiscard]] const fiacre::Block* blockOf(const fiacre::Mention& mention) const;
  [[nodiscard]] const fiacre::Block* blockNamed(std::string_view name) const;
  [[nodiscard]] const fiacre::Block* atPath(const fiacre::PathTaken& path) const;
  void resolve();
  [[nodiscard]] const std::vector<Place>& declarationsOf(std::string_view name) const;
  [[nodiscard]] Place find(const fiacre::Mention& mention) const;
  [[nodiscard]] Place declaredIn(const fiacre::Block& block, std::string_view name,
                                 fiacre::NameKind kind) const;
  [[nodiscard]] Place declaredGlobally(std::string_view name, fiacre::NameKind kind) const;
  // fiacre_hover.cpp
  [[nodiscard]] std::string declarationText(Place declaration) const;
  [[nodiscard]] std::string itemText(const fiacre::Mention& name) const;
  [[nodiscard]] std::string headText(const fiacre::Block& block) const;
  [[nodiscard]] std::string commentsOf(std::uint32_t begin) const;
  [[nodiscard]] bool isKnownAt(Place declaration, const fiacre::Block* block) const;

  std::string_view text;
  fiacre::Parsed parsed;
  std::vector<fiacre::Token> words;                      ///< including comments
  std::map<std::string_view, std::vector<Place>> byName; ///< the declarations of a name
  std::vector<Place> declarations;                       ///< by mention
  std::vector<const fiacre::Block*> blocks;              ///< by mention; null: outside of blocks
};

} // namespace proskill::ide
