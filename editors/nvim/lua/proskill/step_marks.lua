-- Marks in the texts at the places of a trace's steps: a step leads to where its text is now, however the text has been edited
-- since.
local loaded = require('proskill.loaded')

local M = {}

local space = vim.api.nvim_create_namespace('proskill.steps')

-- A place within the text of a buffer: it may be one of an older, longer text.
local function within(buffer, place)
  local last = vim.api.nvim_buf_line_count(buffer) - 1
  local function column(line, at)
    local text = vim.api.nvim_buf_get_lines(buffer, line, line + 1, false)[1] or ''
    return math.min(at, #text)
  end
  local first_line, last_line = math.min(place.line, last), math.min(place.last_line, last)
  return first_line, column(first_line, place.first), last_line, column(last_line, place.last)
end

local function text_at(buffer, line, first, last_line, last)
  return table.concat(vim.api.nvim_buf_get_text(buffer, line, first, last_line, last, {}), '\n')
end

local function mark_of(buffer, place)
  local line, first, last_line, last = within(buffer, place)
  return {
    id = vim.api.nvim_buf_set_extmark(buffer, space, line, first, { end_row = last_line, end_col = last }),
    text = text_at(buffer, line, first, last_line, last),
  }
end

local places = {} -- by the number of the step
local marks = {} -- by buffer and place, in the buffers that are loaded

local function key_of(place)
  return table.concat({ place.line, place.first, place.last_line, place.last }, ':')
end

-- Steps at one place share a mark.
local function mark_all(path, buffer)
  marks[buffer] = {}
  for _, place in pairs(places) do
    local key = key_of(place)
    if place.path == path and not marks[buffer][key] then
      marks[buffer][key] = mark_of(buffer, place)
    end
  end
end

function M.clear()
  places, marks = {}, {}
  loaded.clear(space)
end

-- Marks these places, by number, instead of those before. A file that is not open is marked when a step leads into it.
function M.set(new)
  M.clear()
  places = new
  local paths = {}
  for _, place in pairs(new) do
    paths[place.path] = true
  end
  for path in pairs(paths) do
    local buffer = vim.fn.bufadd(path)
    if vim.api.nvim_buf_is_loaded(buffer) then
      mark_all(path, buffer)
    end
  end
end

-- Whether the text of a mark was removed. Where the lines around it were replaced, its ends are in reverse order.
local function is_removed(mark, now)
  if now.line == now.last_line then
    return now.first > now.last or now.first == now.last and mark.text ~= ''
  end
  return now.line > now.last_line
end

local function place_of(mark, buffer)
  local line, first, details = unpack(vim.api.nvim_buf_get_extmark_by_id(buffer, space, mark.id, { details = true }))
  return line and { line = line, first = first, last_line = details.end_row, last = details.end_col }
end

-- Where the place with this number is now, with its buffer; nil if there is none, or if its text was removed. It is where it was
-- if the buffer has lost its marks as it was unloaded, or if a formatter has replaced the text by the same. A text that was
-- loaded again may be shorter.
function M.now(number)
  local place = places[number]
  if not place then
    return nil
  end
  local buffer = vim.fn.bufadd(place.path)
  vim.fn.bufload(buffer)
  if not marks[buffer] then
    mark_all(place.path, buffer)
  end
  local mark = marks[buffer][key_of(place)]
  local now = place_of(mark, buffer)
  local removed = now and is_removed(mark, now)
  local line, first, last_line, last = within(buffer, now and not removed and now or place)
  if removed and text_at(buffer, line, first, last_line, last) ~= mark.text then
    return nil
  end
  return { buffer = buffer, line = line, first = first, last_line = last_line, last = last }
end

return M
