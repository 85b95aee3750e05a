#pragma once

#include "lsp/workspace/workspace.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace proskill::lsp {

/// The notebooks that the client has open. The cells of one that are written in ProSkill are one
/// program, in the order of the notebook: the workspace holds them as texts, and for each notebook
/// a text of the server's own that includes them. Of the main thread.
class Notebooks {
public:
  using Path = std::filesystem::path;

  explicit Notebooks(Workspace& workspace) : workspace(workspace) {}

  struct Outcome {
    std::vector<Path> changed;         ///< texts, that of the notebook among them
    std::vector<std::string> problems; ///< of the message, as sentences for the user
  };
  /// Invalid parts of a message are reported; valid parts are applied.
  Outcome open(const Json& params);
  Outcome change(const Json& params);
  Outcome close(const Json& params);

private:
  struct Notebook {
    std::string uri;
    std::vector<Path> cells;   ///< all of them, in order
    std::set<Path> open;       ///< the texts of those in ProSkill
    std::set<Path> unserved{}; ///< those in other languages
  };

  void restructure(Notebook& notebook, const Json& structure, Outcome& outcome);
  void openCell(Notebook& notebook, const Json& text, Outcome& outcome);
  void changeCell(Notebook& notebook, const Json& change, Outcome& outcome);
  void closeCell(Notebook& notebook, const Json& text, Outcome& outcome);
  void join(const Path& path, Outcome& outcome);
  void drop(const Path& path, Outcome& outcome);

  Workspace& workspace;
  std::map<Path, Notebook> notebooks;
};

} // namespace proskill::lsp
