#include "tests/support/oracle/path_walk.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Statement;
using fiacre::StatementKind;

Evaluation PathWalk::in(Path& path) const {
  return {model, path.store, model.elaborated[instance].scope};
}

std::vector<Path> PathWalk::from(const Statement& statement, const Store& store) {
  found.clear();
  Path start;
  start.store = store;
  start.instance = instance;
  walk(std::move(start), {{&statement, std::nullopt}});
  return std::move(found);
}

void PathWalk::walk(Path path, Tasks tasks) {
  if (path.target || tasks.empty()) {
    found.push_back(std::move(path));
    return;
  }
  Task task = tasks.back();
  tasks.pop_back();
  if (task.statement->origin != 0 && !task.value) path.origins.push_back(task.statement->origin);
  if (task.statement->kind == StatementKind::While ||
      task.statement->kind == StatementKind::Foreach)
    return repeat(task, std::move(path), std::move(tasks));
  step(*task.statement, std::move(path), std::move(tasks));
}

void PathWalk::step(const Statement& statement, Path path, Tasks tasks) {
  switch (statement.kind) {
  case StatementKind::Null:
  case StatementKind::Comment: break;
  case StatementKind::Assign: assign(statement, path); break;
  case StatementKind::On:
    if (!in(path).truth(statement.values[0])) return;
    break;
  case StatementKind::Wait:
    if (path.wait) throw ModelError("two waits on one path");
    path.wait = statement.interval;
    break;
  case StatementKind::To:
  case StatementKind::Loop: leave(statement, path); break;
  case StatementKind::Tag: path.tags.push_back(statement.name); break;
  case StatementKind::Sequence:
    for (auto child = statement.children.rbegin(); child != statement.children.rend(); ++child)
      tasks.push_back({&*child, std::nullopt});
    break;
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::Select: return branch(statement, path, tasks);
  case StatementKind::Any: return any(statement, path, tasks, 0);
  case StatementKind::Send:
    choosePort(statement, path);
    for (std::size_t i = 0; i < statement.values.size(); ++i) {
      Store one = in(path).value(statement.values[i], &valueTypes(statement.name).at(i));
      path.message.insert(path.message.end(), one.begin(), one.end());
    }
    break;
  case StatementKind::Receive:
    choosePort(statement, path);
    path.takes = true;
    return any(statement, path, tasks, 0);
  default: throw ModelError("a statement that the offline models do not have");
  }
  walk(std::move(path), std::move(tasks));
}

void PathWalk::choosePort(const Statement& statement, Path& path) {
  if (path.port) throw ModelError("two communications on one path");
  path.port = model.elaborated[instance].ports.at(statement.name);
}

const std::vector<fiacre::Type>& PathWalk::valueTypes(const std::string& port) const {
  const auto& ports = model.elaborated[instance].process->ports;
  return std::ranges::find(ports, port, &fiacre::Port::name)->values;
}

void PathWalk::assign(const Statement& statement, Path& path) {
  Evaluation evaluation = in(path);
  std::vector<Place> places;
  std::vector<Store> values;
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    places.push_back(evaluation.place(statement.targets[i]).value());
    values.push_back(evaluation.value(statement.values[i], places[i].type));
  }
  for (std::size_t i = 0; i < places.size(); ++i) evaluation.assign(places[i], values[i]);
}

void PathWalk::leave(const Statement& statement, Path& path) {
  const auto& states = model.elaborated[instance].process->states;
  path.loops = statement.kind == StatementKind::Loop;
  if (path.loops) {
    path.target = static_cast<std::size_t>(path.store[instance]);
    return;
  }
  auto state = std::ranges::find(states, statement.name, &fiacre::State::name);
  if (state == states.end()) throw ModelError("unknown state " + statement.name);
  path.target = static_cast<std::size_t>(state - states.begin());
}

void PathWalk::branch(const Statement& statement, const Path& path, const Tasks& tasks) {
  if (statement.kind == StatementKind::Select) return select(statement, path, tasks);
  Path taken = path;
  const Statement* child = nullptr;
  if (statement.kind == StatementKind::If) {
    bool truth = in(taken).truth(statement.values[0]);
    if (truth) child = &statement.children[0];
    if (!truth && statement.children.size() > 1) child = &statement.children[1];
  } else {
    Evaluation evaluation = in(taken);
    Store tested = evaluation.value(statement.values[0]);
    const fiacre::Type& type = *evaluation.typeOf(statement.values[0]);
    for (std::size_t i = 0; i < statement.children.size() && !child; ++i)
      if (evaluation.matches(statement.values[i + 1], tested, type)) child = &statement.children[i];
    if (!child) return; // no pattern matches: the path ends
  }
  if (model.reading == Reading::Frac) taken.branches.push_back(child ? child : &statement);
  Tasks rest = tasks;
  if (child) rest.push_back({child, std::nullopt});
  walk(std::move(taken), std::move(rest));
}

void PathWalk::select(const Statement& statement, const Path& path, const Tasks& tasks) {
  const auto& groups = statement.priorityGroups;
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    const auto& child = statement.children[i];
    Path taken = path;
    taken.branches.push_back(&child);
    if (!groups.empty())
      taken.rank = {&statement,
                    std::ranges::count_if(groups, [i](auto first) { return first <= i; })};
    Tasks rest = tasks;
    rest.push_back({&child, std::nullopt});
    walk(std::move(taken), std::move(rest));
  }
}

// `x := any where c` and `port ? x where c`: tries every value of the type
void PathWalk::any(const Statement& statement, const Path& path, const Tasks& tasks,
                   std::size_t target) {
  Path taken = path;
  if (target == statement.targets.size()) {
    if (!statement.values.empty() && !in(taken).truth(statement.values[0])) return;
    return walk(std::move(taken), tasks);
  }
  Place place = in(taken).place(statement.targets[target]).value();
  for (const Store& value : valuesOf(model, *place.type)) {
    std::ranges::copy(value, taken.store.begin() + static_cast<std::ptrdiff_t>(place.offset));
    taken.message = path.message;
    taken.choices = path.choices;
    auto& noted = statement.kind == StatementKind::Any ? taken.choices : taken.message;
    noted.insert(noted.end(), value.begin(), value.end());
    any(statement, taken, tasks, target + 1);
  }
}

void PathWalk::repeat(const Task& task, Path path, Tasks tasks) {
  const Statement& statement = *task.statement;
  if (statement.kind == StatementKind::While) {
    if (in(path).truth(statement.values[0])) {
      tasks.push_back({&statement, 0});
      tasks.push_back({&statement.children[0], std::nullopt});
    }
    return walk(std::move(path), std::move(tasks));
  }
  Place counter = model.elaborated[instance].scope.at(statement.name);
  auto [low, high] = boundsOf(model, *counter.type);
  std::int64_t value = task.value.value_or(low);
  if (value <= high) {
    path.store[counter.offset] = value;
    tasks.push_back({&statement, value + 1});
    tasks.push_back({&statement.children[0], std::nullopt});
  }
  walk(std::move(path), std::move(tasks));
}

} // namespace proskill::oracle
