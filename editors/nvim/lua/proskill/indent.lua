-- Indentation by queries/proskill/indents.scm, in the formatter's style. Unfinished text has
-- unclosed parentheses, so the innermost open one counts, not the node around the line.
local treesitter = require('proskill.treesitter')

local M = {}

local function previous_line(buffer, line)
  for above = line - 1, 0, -1 do
    local text = vim.api.nvim_buf_get_lines(buffer, above, above + 1, true)[1]
    if text:find('%S') then
      return above, #text
    end
  end
end

-- The child of the root in which the text before a line ends.
local function definition_before(buffer, root, line)
  local above, width = previous_line(buffer, line)
  if not above then
    return nil
  end
  local node = root:descendant_for_range(above, width - 1, above, width)
  while node and node:parent() and node:parent():id() ~= root:id() do
    node = node:parent()
  end
  while node and (node:id() == root:id() or node:type() == 'comment') do
    node = node:id() ~= root:id() and node:prev_named_sibling() or nil
  end
  return node
end

-- The last parenthesis before a line that is still open there, as its token.
local function open_parenthesis(node, line, stack)
  for child in node:iter_children() do
    if child:start() >= line then
      return
    elseif child:type() == '(' then
      table.insert(stack, child)
    elseif child:type() == ')' then
      table.remove(stack)
    else
      open_parenthesis(child, line, stack)
    end
  end
end

-- By node: the name and the step of the capture.
local function captures_of(buffer, node)
  local found = {}
  local query = treesitter.query('indents')
  local first, _, last = node:range()
  for id, captured, metadata in query:iter_captures(node, buffer, first, last + 1) do
    local name = query.captures[id]
    if name:find('^indent') then
      found[captured:id()] = { name = name, step = tonumber(metadata['indent.step']) }
    end
  end
  return found
end

local function starts_in(node, line)
  return node:start() == line
end

-- Whether a line begins with a keyword of the surrounding statement.
local function is_branch(node, line, captures)
  local clause
  for child in node:iter_children() do
    local word = child:child(0)
    if word and starts_in(word, line) and captures[word:id()] then
      clause = captures[word:id()]
    end
  end
  return clause and clause.name == 'indent.branch' and clause.step
end

-- The last part of a form that begins before a line and has no parentheses of its own: a field, or
-- a tag with its clause.
local function group_before(form, line, captures)
  local last
  for child in form:iter_children() do
    if child:start() < line and child:type() ~= 'comment' then
      last = child
    end
  end
  local capture = last and captures[last:id()]
  local first = last and last:child(0)
  if capture and capture.name == 'indent.begin' and first and first:type() ~= '(' then
    return last, capture.step
  end
end

-- Whether a line in or after a group continues the group.
local function goes_on(group, line, blank)
  local _, _, last = group:range()
  if last >= line then
    return true
  end
  return blank and group:named_child_count() == 0
end

local function column(node)
  local _, at = node:start()
  return at
end

-- The second part of a form, if it is on the line of the first.
local function second_part(form)
  local head, second = form:child(1), form:child(2)
  if head and second and second:start() == head:start() and second:type() ~= ')' then
    return second
  end
end

-- The indentation of a line, counted from 0.
function M.of(buffer, line)
  local root = treesitter.root(buffer)
  local text = vim.api.nvim_buf_get_lines(buffer, line, line + 1, true)[1]
  local begin = (text:find('%S') or 1) - 1
  if not root then
    return 0
  end
  local definition = definition_before(buffer, root, line)
  if not definition then
    return 0
  end
  local at_line = root:descendant_for_range(line, begin, line, begin + 1)
  if at_line and at_line:type() == '(' and at_line:parent():parent()
     and at_line:parent():parent():id() == root:id() then
    return 0
  end
  local stack = {}
  open_parenthesis(definition, line, stack)
  local parenthesis = stack[#stack]
  if not parenthesis then
    return 0
  end
  local form = parenthesis:parent()
  local captures = captures_of(buffer, definition)
  local capture = captures[form:id()] or {}
  local base = column(parenthesis)
  local branch = is_branch(form, line, captures)
  if branch then
    return base + branch
  end
  local group, step = group_before(form, line, captures)
  if group and goes_on(group, line, text:find('%S') == nil or text:find('^%s*%(')) then
    return column(group) + step
  end
  if capture.step then
    return base + capture.step
  end
  local second = second_part(form)
  return second and column(second) or base + 1
end

function M.expression()
  return M.of(vim.api.nvim_get_current_buf(), vim.v.lnum - 1)
end

return M
