#include "viz/dot/ids.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace proskill::viz {
namespace {

/// Maps names of one graph to numbers, separately for graphs, nodes and edges. Names are strings of
/// cgraph, since cgraph uses what it stores with them.
class Ids {
public:
  explicit Ids(Agraph_t* named) : graph(named) {}

  bool find(int kind, char* name, IDTYPE& id, bool create) {
    if (name != nullptr) {
      const auto found = byName.find({kindOf(kind), name});
      if (found != byName.end()) {
        id = found->second;
        return true;
      }
    }
    if (!create) return false;
    id = next++;
    if (name == nullptr) return true;
    byName[{kindOf(kind), name}] = id;
    byId[id] = agstrdup(graph, name);
    return true;
  }

  [[nodiscard]] char* name(IDTYPE id) const {
    const auto found = byId.find(id);
    return found == byId.end() ? nullptr : found->second;
  }

  void forget(int kind, IDTYPE id) {
    const auto found = byId.find(id);
    if (found == byId.end()) return;
    byName.erase({kindOf(kind), found->second});
    agstrfree(graph, found->second);
    byId.erase(found);
  }

private:
  /// cgraph's two half-edges are one edge.
  static int kindOf(int kind) { return kind == AGINEDGE ? AGOUTEDGE : kind; }

  Agraph_t* graph;
  std::map<std::pair<int, std::string>, IDTYPE> byName;
  std::map<IDTYPE, char*> byId;
  IDTYPE next = 1;
};

Ids& idsOf(void* state) { return *static_cast<Ids*>(state); }

void* open(Agraph_t* graph, Agdisc_t*) { return std::make_unique<Ids>(graph).release(); }
void close(void* state) { const std::unique_ptr<Ids> ids(static_cast<Ids*>(state)); }
long map(void* state, int kind, char* name, IDTYPE* id, int create) {
  return idsOf(state).find(kind, name, *id, create != 0) ? 1 : 0;
}
/// Not supported: identifiers are always names.
long allocate(void*, int, IDTYPE) { return 0; }
void release(void* state, int kind, IDTYPE id) { idsOf(state).forget(kind, id); }
char* print(void* state, int, IDTYPE id) { return idsOf(state).name(id); }
void registerId(void*, int, void*) {}

} // namespace

Agiddisc_t* sequentialIds() {
  static Agiddisc_t discipline{open, map, allocate, release, print, close, registerId};
  return &discipline;
}

} // namespace proskill::viz
