#pragma once

#include "analysis/program/file_system.h"
#include "syntax/document.h"
#include "syntax/tree/constants.h"

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace proskill::analysis {

using syntax::FileId;
using syntax::Location;

struct File {
  std::filesystem::path path; ///< as a user writes it or an editor names it
  syntax::Document document;
  std::string canonical{}; ///< the spelling that identifies the file; empty if nobody needs it
};

/// A definition: its form and its file. Valid as long as the program.
template <class Node> struct Definition {
  const syntax::Form* form = nullptr;
  FileId file = 0;

  [[nodiscard]] std::string_view name() const { return form->name.text; }
  [[nodiscard]] const Node& node() const { return *form->as<Node>(); }
  const Node* operator->() const { return form->as<Node>(); }
  /// For reading all definitions after each edit, see syntax::Form.
  [[nodiscard]] const Node& nodeAsRead() const { return *form->asRead<Node>(); }
  [[nodiscard]] Location atAsRead(syntax::Range range) const {
    return at(range.moved(form->offset()));
  }
  [[nodiscard]] Location at(syntax::Range range) const { return {file, range}; }
};

/// The definitions of one namespace, in the order of the program, and by name (the first with each
/// name).
template <class Node> struct Table {
  std::vector<Definition<Node>> all;
  std::unordered_map<std::string_view, std::size_t> byName;

  [[nodiscard]] const Definition<Node>* find(std::string_view name) const {
    auto found = byName.find(name);
    return found == byName.end() ? nullptr : &all[found->second];
  }
};

/// How much of a program the root file contains. A fragment is a file that other files include,
/// opened on its own: names that it does not define may be defined by a root that is not known
/// here.
enum class Extent : std::uint8_t { Whole, Fragment };

/// A root file with all its includes, forms in reading order.
struct Program {
  Extent extent = Extent::Whole;
  std::vector<File> files; ///< files[0] is the root
  Table<syntax::Constant> constants;
  Table<syntax::StateVariable> stateVariables;
  Table<syntax::Event> events;
  Table<syntax::Skill> skills;
  Table<syntax::Resource> resources;
  Table<syntax::Property> properties;
  Table<syntax::Environment> environments;
  Table<syntax::Platform> platforms;
  std::vector<syntax::Diagnostic> diagnostics; ///< of loading and parsing
  /// Those of `constants` that can be used. The definitions in the tables have their numbers.
  syntax::ConstantValues constantValues;
  std::deque<syntax::Form> filled; ///< forms of the files with the numbers of their constants

  Program() = default;
  Program(Program&&) = default;
  Program& operator=(Program&&) = default;
  Program(const Program&) = delete; ///< definitions refer to the files
  Program& operator=(const Program&) = delete;
};

/// Loads `root` and what it includes. Never fails: files that cannot be read become diagnostics.
[[nodiscard]] Program load(const FileSystem& files, const std::filesystem::path& root,
                           Extent extent = Extent::Whole);

/// The same with the root document that an editor has open; only includes are read.
[[nodiscard]] Program load(const FileSystem& files, const std::filesystem::path& root,
                           syntax::Document document, Extent extent = Extent::Whole);

/// All diagnostics of a program, including those of loading, in the order of the files.
[[nodiscard]] std::vector<syntax::Diagnostic> check(const Program& program);

/// The mission: the composite skill that no other skill calls and that is not a monitor.
struct MainSkill {
  const Definition<syntax::Skill>* skill = nullptr; ///< null: a library of skills, or ambiguous
  std::vector<const Definition<syntax::Skill>*> candidates;
};
[[nodiscard]] MainSkill mainSkill(const Program& program);
class CallGraph;
/// The same if the program's calls are known already.
[[nodiscard]] MainSkill mainSkill(const Program& program, const CallGraph& calls);

} // namespace proskill::analysis
