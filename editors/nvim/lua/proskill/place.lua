-- Places in texts, from the protocol and from `proskill verify`: { path, line, first, last_line,
-- last }, lines from 0, columns in bytes from 0.
local M = {}

local function line_of(path, line)
  local buffer = vim.fn.bufadd(path)
  vim.fn.bufload(buffer)
  return vim.api.nvim_buf_get_lines(buffer, line, line + 1, false)[1] or ''
end

-- Number of units of a character, by its first byte.
local units = {
  ['utf-8'] = function(length) return length end,
  ['utf-16'] = function(length) return length == 4 and 2 or 1 end,
  ['utf-32'] = function() return 1 end,
}

-- Converts a column in units of an encoding to bytes.
function M.bytes(text, column, encoding)
  local at, count = 0, 0
  while at < #text and count < column do
    local lead = text:byte(at + 1)
    local length = lead < 0x80 and 1 or lead < 0xe0 and 2 or lead < 0xf0 and 3 or 4
    count = count + units[encoding](length)
    at = math.min(at + length, #text)
  end
  return at
end

local function place(path, from_line, from, to_line, to, encoding)
  path = vim.fn.fnamemodify(path, ':p')
  return {
    path = path,
    line = from_line, first = M.bytes(line_of(path, from_line), from, encoding),
    last_line = to_line, last = M.bytes(line_of(path, to_line), to, encoding),
  }
end

-- A `Location` of the protocol, or nil.
function M.of_protocol(location, encoding)
  if not location or location == vim.NIL then
    return nil
  end
  local from, to = location.range.start, location.range['end']
  return place(vim.uri_to_fname(location.uri), from.line, from.character, to.line, to.character,
               encoding)
end

-- A place of `proskill … --format json`, or nil.
function M.of_program(location)
  if not location or location == vim.NIL then
    return nil
  end
  local from, to = location.begin, location['end']
  return place(location.file, from.line - 1, from.column - 1, to.line - 1, to.column - 1, 'utf-32')
end

-- An item of the quickfix list, with more fields.
function M.item(where, more)
  local item = vim.deepcopy(more)
  if where then
    item.filename = where.path
    item.lnum, item.col = where.line + 1, where.first + 1
    item.end_lnum, item.end_col = where.last_line + 1, where.last + 1
  end
  return item
end

return M
