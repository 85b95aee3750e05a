#pragma once

#include "lsp/workspace/workspace.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace proskill::lsp {

/// What makes a lost cell known again, as the end of a sentence for the user.
inline constexpr const char* kReopenNotebook = "; please close the notebook and open it again";

/// The notebooks that the client has open. The ProSkill cells of a notebook form one program, in
/// the order of the notebook. The workspace holds the cells as texts, and for each notebook a text
/// of the server's own that includes them. For the main thread.
class Notebooks {
public:
  using Path = std::filesystem::path;

  explicit Notebooks(Workspace& workspace) : workspace(workspace) {}

  struct Outcome {
    std::vector<Path> changed;         ///< texts, including the notebook's own
    std::vector<std::string> problems; ///< of the message, as sentences for the user
  };
  /// Invalid parts of a message are reported; valid parts are applied.
  /// \param hasHalves the message contains halves of characters, which were replaced by U+FFFD
  Outcome open(const Json& params, bool hasHalves = false);
  Outcome change(const Json& params, bool hasHalves = false);
  Outcome close(const Json& params);

private:
  struct Notebook {
    std::string uri;
    std::vector<Path> cells;   ///< all cells, in order
    std::set<Path> open;       ///< texts of the cells in ProSkill, also lost ones
    std::set<Path> unserved{}; ///< texts of cells in other languages
  };

  void restructure(Notebook& notebook, const Json& structure, bool hasHalves, Outcome& outcome);
  void openCell(Notebook& notebook, const Json& text, bool hasHalves, Outcome& outcome);
  void changeCell(Notebook& notebook, const Json& change, bool hasHalves, Outcome& outcome);
  void closeCell(Notebook& notebook, const Json& text, Outcome& outcome);
  void join(const Path& path, Outcome& outcome);
  void drop(const Path& path, Outcome& outcome);

  Workspace& workspace;
  std::map<Path, Notebook> notebooks;
};

} // namespace proskill::lsp
