#include "bridge/bt/read/read.h"

#include "bridge/bt/read/read_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace proskill::bridge::bt {
namespace {

struct File {
  std::filesystem::path path;
  Element root;
  bool isWellFormed = true;
};

/// Reads files in the order of their includes.
class FileReader {
public:
  FileReader(const analysis::FileSystem& disk, Errors& errors) : disk(disk), errors(errors) {}

  void file(const std::filesystem::path& path, const Place& from) {
    const auto canonical = disk.canonical(path);
    if (std::ranges::find(open, canonical) != open.end())
      return fail(from, fmt::format("`{}` includes itself", path.generic_string()));
    if (!seen.insert(canonical).second) return;
    if (seen.size() > kMostFiles) return fail(from, "too many files");
    const auto bytes = disk.read(path);
    if (!bytes)
      return fail(from, fmt::format("cannot read `{}`: {}", path.generic_string(), bytes.error()));
    auto document = readXml(*bytes, path);
    if (!document) return errors.push_back(document.error());
    open.push_back(canonical);
    includes(document->root, path);
    open.pop_back();
    files.push_back({path, std::move(document->root), document->isWellFormed});
  }

  std::vector<File> files; ///< included ones first

private:
  void includes(const Element& root, const std::filesystem::path& path) {
    for (const auto& element : root.children) {
      if (element.name != "include") continue;
      const auto* target = element.attribute("path");
      if (element.attribute("ros_pkg") != nullptr)
        fail(element.place, "`ros_pkg` is not supported: give a relative path");
      else if (target == nullptr || target->empty())
        fail(element.place, "`include` needs an attribute `path`");
      else if (std::filesystem::path(*target).is_absolute())
        fail(element.place, "the path of `include` must be relative");
      else
        file(path.parent_path() / *target, element.place);
    }
  }

  void fail(const Place& place, std::string message) {
    errors.push_back({place, std::move(message)});
  }

  const analysis::FileSystem& disk;
  Errors& errors;
  std::vector<std::filesystem::path> open;
  std::set<std::filesystem::path> seen;
};

/// Collects what the files declare.
class ForestReader {
public:
  explicit ForestReader(Errors& errors) : errors(errors) {}

  /// \param main the tree to execute; empty: as the last file says
  Forest read(const std::vector<File>& files, const std::string& main) {
    const bool isWhole = errors.empty(); // else the main tree may be in a file with an error
    for (const auto& file : files) {
      if (!file.isWellFormed)
        forest.notes.push_back({file.root.place, "not well-formed XML, but BehaviorTree.CPP reads "
                                                 "it: `&` or `<` in attributes, `--` in comments, "
                                                 "or something before the declaration"});
      head(file.root);
    }
    for (const auto& file : files) declarations(file.root);
    for (const auto& file : files) trees(file.root);
    if (isWhole) mainTree(files.back().root, main);
    return std::move(forest);
  }

private:
  void head(const Element& root) {
    if (root.name != "root")
      return fail(root, fmt::format("the outermost element must be `root`, not `{}`", root.name));
    const auto* format = root.attribute("BTCPP_format");
    if (format == nullptr || *format == "3")
      forest.hasFormat = false;
    else if (*format != "4")
      fail(root, "`BTCPP_format` must be 3 or 4");
    texts(root);
    for (const auto& element : root.children)
      if (element.name != "BehaviorTree" && element.name != "TreeNodesModel" &&
          element.name != "include")
        fail(element, fmt::format("`{}` is not allowed here", element.name));
  }

  /// BehaviorTree.CPP ignores texts, which are descriptions in models and elsewhere mostly typing
  /// errors.
  void texts(const Element& element) {
    if (element.text)
      forest.notes.push_back({*element.text, "a text between elements has no effect"});
    for (const auto& child : element.children)
      if (child.name != "TreeNodesModel") texts(child);
  }

  void declarations(const Element& root) {
    for (const auto& element : root.children) {
      if (element.name == "TreeNodesModel")
        for (const auto& model : element.children) declare(model);
      if (element.name == "BehaviorTree") announce(element);
    }
  }

  void declare(const Element& model) {
    const auto* id = model.attribute("ID");
    if (id == nullptr || id->empty()) return fail(model, "a model needs an attribute `ID`");
    if (builtIn(*id) != nullptr) return;
    for (const auto& port : model.children) declarePort(*id, port);
    if (model.name == "Action")
      forest.declared.emplace(*id, Kind::Action);
    else if (model.name == "Condition")
      forest.declared.emplace(*id, Kind::Condition);
    else if (model.name == "SubTree")
      forest.declared.emplace(*id, Kind::SubTree);
    else if (model.name != "Control" && model.name != "Decorator")
      fail(model, fmt::format("`{}` is not allowed in `TreeNodesModel`", model.name));
  }

  void declarePort(const std::string& type, const Element& port) {
    const auto* name = port.attribute("name");
    if (name == nullptr) return;
    const auto* byDefault = port.attribute("default");
    forest.ports[type].emplace(*name, PortModel{.isInput = port.name != "output_port",
                                                .isOutput = port.name != "input_port",
                                                .byDefault = byDefault ? *byDefault : ""});
  }

  /// A tree may be used before it is defined. \return its name, as BehaviorTree.CPP gives one
  static std::string idOf(const Element& element, std::size_t& nameless) {
    const auto* id = element.attribute("ID");
    if (id != nullptr && !id->empty()) return *id;
    return fmt::format("BehaviorTree_{}", nameless++);
  }

  void announce(const Element& element) {
    const auto id = idOf(element, announced);
    if (!forest.trees.emplace(id, Tree{id, element.place, {}}).second)
      fail(element, fmt::format("the tree `{}` is defined twice", id));
  }

  void trees(const Element& root) {
    for (const auto& element : root.children)
      if (element.name == "BehaviorTree") tree(element);
  }

  void tree(const Element& element) {
    const auto found = forest.trees.find(idOf(element, filled));
    if (element.children.size() != 1)
      return fail(element,
                  fmt::format("`BehaviorTree` must have 1 child, not {}", element.children.size()));
    auto root = NodeReader(forest, errors).node(element.children.front());
    if (found != forest.trees.end()) found->second.root = std::move(root);
  }

  void mainTree(const Element& root, const std::string& chosen) {
    forest.place = root.place;
    const auto* named = root.attribute("main_tree_to_execute");
    if (!chosen.empty() || named != nullptr) {
      forest.main = chosen.empty() ? *named : chosen;
      if (!forest.trees.contains(forest.main))
        fail(root, fmt::format("there is no tree `{}`", forest.main));
    } else if (forest.trees.size() == 1) {
      forest.main = forest.trees.begin()->first;
    } else {
      fail(root, forest.trees.empty() ? "there is no `BehaviorTree`"
                                      : "`root` needs `main_tree_to_execute`: there are several "
                                        "trees; `--main` chooses one");
    }
  }

  void fail(const Element& element, std::string message) {
    errors.push_back({element.place, std::move(message)});
  }

  Forest forest;
  Errors& errors;
  std::size_t announced = 0; ///< trees without a name
  std::size_t filled = 0;    ///< the same, once their nodes are read
};

} // namespace

std::expected<Forest, Errors> read(const analysis::FileSystem& files,
                                   const std::filesystem::path& root, const std::string& main) {
  Errors errors;
  FileReader reader(files, errors);
  reader.file(root, {root});
  if (reader.files.empty()) return std::unexpected(std::move(errors));
  auto forest = ForestReader(errors).read(reader.files, main);
  if (!errors.empty()) return std::unexpected(std::move(errors));
  return forest;
}

} // namespace proskill::bridge::bt
