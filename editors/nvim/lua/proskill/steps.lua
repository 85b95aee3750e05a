-- A trace as data: its steps with their dates as text, and the values of all variables after each
-- step.
local natural = require('proskill.natural')
local place = require('proskill.place')

local M = {}

local function present(value)
  return value ~= vim.NIL and value or nil
end

-- From an answer to `proskill/trace` (with the encoding of its positions), or from a verdict of
-- `proskill verify --format json`.
function M.trace(from, encoding)
  local trace = {
    initial = from.initial, stale = from.stale == true, summary = from.summary or '', steps = {},
  }
  for _, step in ipairs(from.steps) do
    table.insert(trace.steps, {
      actor = step.actor, description = step.description, changes = step.changes,
      why = (step.why or ''):gsub('`', ''), relevant = step.relevant ~= false,
      earliest = present(step.earliest), latest = present(step.latest),
      place = encoding and place.of_protocol(step.location, encoding)
              or not encoding and place.of_program(step.location) or nil,
    })
  end
  return trace
end

-- All dates at which a step can happen: "1 … 5 s", ">120 s …".
function M.date(step)
  local from, to = step.earliest, step.latest
  local first = (from.strict and '>' or '') .. from.exact
  if not to then
    return first .. ' s …'
  end
  local last = (to.strict and '<' or '') .. to.exact
  return first == last and first .. ' s' or ('%s … %s s'):format(first, last)
end

function M.change(change)
  return ('%s: %s → %s'):format(change.variable, change.before, change.after)
end

function M.changes(step)
  return table.concat(vim.tbl_map(M.change, step.changes), ', ')
end

-- The values of all variables after this many steps, by name.
function M.values(trace, number)
  local values = vim.deepcopy(trace.initial)
  for index = 1, number do
    for _, change in ipairs(trace.steps[index].changes) do
      values[change.variable] = change.after
    end
  end
  return values
end

-- The variables' names: state variables first, then the skills' `status` and `res`.
function M.variables(trace)
  local names = vim.tbl_keys(trace.initial)
  table.sort(names, function(a, b)
    local of_skill, other = a:find('.', 1, true) ~= nil, b:find('.', 1, true) ~= nil
    if of_skill ~= other then
      return not of_skill
    end
    return natural.before(a, b)
  end)
  return names
end

return M
