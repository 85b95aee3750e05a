-- The window beside a trace: all values after the current step, with diff marks.
local steps = require('proskill.steps')

local M = {}

local space = vim.api.nvim_create_namespace('proskill.values')
local buffer, window

local function is_open()
  return window and vim.api.nvim_win_is_valid(window)
end

local function heading(shown)
  local step = shown.trace.steps[shown.at]
  return ('%d/%d  %s'):format(shown.at, #shown.trace.steps,
                              step and steps.date(step) .. '  ' .. step.actor or 'start')
end

-- A line for each variable: `~ battery  Good → Low` if the step has changed it, otherwise `  battery
-- Low`.
local function lines_of(shown)
  local lines, changed = { heading(shown), '' }, {}
  local before = steps.values(shown.trace, math.max(shown.at - 1, 0))
  local after = steps.values(shown.trace, shown.at)
  local names = steps.variables(shown.trace)
  local width = 0
  for _, name in ipairs(names) do
    width = math.max(width, #name)
  end
  for _, name in ipairs(names) do
    local same = before[name] == after[name]
    local value = same and after[name] or before[name] .. ' → ' .. after[name]
    table.insert(lines, ('%s %-' .. width .. 's  %s'):format(same and ' ' or '~', name, value))
    if not same then
      table.insert(changed, { line = #lines - 1, first = 2 + width + 2 })
    end
  end
  return lines, changed
end

-- The width of the widest line of any step.
local function width_of(shown)
  local names, values = 0, 0
  for name, value in pairs(shown.trace.initial) do
    names, values = math.max(names, #name), math.max(values, #value)
  end
  for _, step in ipairs(shown.trace.steps) do
    for _, change in ipairs(step.changes) do
      values = math.max(values, #change.before + #' > ' + #change.after)
    end
  end
  return names + values + 5
end

function M.open(shown)
  local back = vim.api.nvim_get_current_win()
  vim.cmd('vertical botright new')
  window, buffer = vim.api.nvim_get_current_win(), vim.api.nvim_get_current_buf()
  vim.bo[buffer].buftype, vim.bo[buffer].bufhidden = 'nofile', 'wipe'
  vim.bo[buffer].swapfile = false
  pcall(vim.api.nvim_buf_set_name, buffer, 'proskill://values')
  vim.wo[window].number, vim.wo[window].relativenumber = false, false
  vim.wo[window].wrap, vim.wo[window].winfixwidth = false, true
  vim.wo[window].signcolumn, vim.wo[window].foldcolumn = 'no', '0'
  vim.api.nvim_set_current_win(back)
  vim.api.nvim_win_set_width(window, math.min(width_of(shown), math.floor(vim.o.columns / 2)))
  M.show(shown)
end

function M.show(shown)
  if not is_open() then
    return
  end
  local lines, changed = lines_of(shown)
  vim.bo[buffer].modifiable = true
  vim.api.nvim_buf_set_lines(buffer, 0, -1, false, lines)
  vim.bo[buffer].modifiable = false
  vim.api.nvim_buf_clear_namespace(buffer, space, 0, -1)
  for _, place in ipairs(changed) do
    vim.api.nvim_buf_set_extmark(buffer, space, place.line, 0,
                                 { line_hl_group = 'DiffChange' })
    vim.api.nvim_buf_set_extmark(buffer, space, place.line, place.first,
                                 { end_col = #lines[place.line + 1], hl_group = 'DiffText' })
  end
end

function M.close()
  if is_open() then
    vim.api.nvim_win_close(window, true)
  end
  window, buffer = nil, nil
end

return M
