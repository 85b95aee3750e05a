-- Marks in the texts at the places of a trace's steps: a step leads to where its text is now, however the text has been edited
-- since.
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

local function buffer_of(place)
  local buffer = vim.fn.bufadd(place.path)
  vim.fn.bufload(buffer)
  return buffer
end

local function text_at(buffer, line, first, last_line, last)
  return table.concat(vim.api.nvim_buf_get_text(buffer, line, first, last_line, last, {}), '\n')
end

local function place_mark(place)
  local buffer = buffer_of(place)
  local line, first, last_line, last = within(buffer, place)
  return {
    id = vim.api.nvim_buf_set_extmark(buffer, space, line, first, { end_row = last_line, end_col = last }),
    buffer = buffer, text = text_at(buffer, line, first, last_line, last),
  }
end

-- Marks these places, by number, instead of those before.
function M.set(places)
  M.clear()
  local marks = {}
  for number, place in pairs(places) do
    marks[number] = place_mark(place)
  end
  return marks
end

function M.clear()
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_is_loaded(buffer) then
      vim.api.nvim_buf_clear_namespace(buffer, space, 0, -1)
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

-- Where a marked place is now, with its buffer; nil if its text was removed. It is where it was if the buffer has lost its marks
-- as it was unloaded, or if a formatter has replaced the text by the same. A text that was loaded again may be shorter.
function M.now(mark, place)
  local buffer = buffer_of(place)
  local now = mark.buffer == buffer and place_of(mark, buffer)
  local removed = now and is_removed(mark, now)
  local line, first, last_line, last = within(buffer, now and not removed and now or place)
  if removed and text_at(buffer, line, first, last_line, last) ~= mark.text then
    return nil
  end
  return { buffer = buffer, line = line, first = first, last_line = last_line, last = last }
end

return M
