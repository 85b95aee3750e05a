-- :ProskillTrace: shows a trace in the quickfix list, marks its current step in the program, and shows the values after the
-- step beside it, with the changes marked.
local client = require('proskill.client')
local config = require('proskill.config')
local loaded = require('proskill.loaded')
local message = require('proskill.message')
local place = require('proskill.place')
local step_marks = require('proskill.step_marks')
local steps = require('proskill.steps')
local values = require('proskill.values')
local verify = require('proskill.verify')

local M = {}

local space = vim.api.nvim_create_namespace('proskill.trace')

-- The trace on display: { trace, name, description, verdict, list (its quickfix identifier), at, window }. Step 0 is the start.
M.shown = nil

for group, link in pairs({
  ProskillStepAside = 'Comment', ProskillStep = 'Visual', ProskillStepChange = 'DiffText', ProskillStepNote = 'Comment',
  ProskillStepSign = 'Search',
}) do
  vim.cmd(('highlight default link %s %s'):format(group, link))
end

local function items(shown)
  local summary = shown.verdict .. (shown.trace.summary ~= '' and '. ' .. shown.trace.summary:gsub('`', '') or '')
  local start = ('start  %s: %s'):format(shown.description, summary)
  local result = { place.item(shown.place, { text = start, nr = 0 }) }
  for number, step in ipairs(shown.trace.steps) do
    local changes = steps.changes(step)
    table.insert(result, place.item(step.place, {
      nr = number,
      text = ('%s  %s: %s%s'):format(steps.date(step), step.actor, step.description,
                                     changes ~= '' and '  [' .. changes .. ']' or ''),
    }))
  end
  return result
end

-- In the list a line is `mission.proskill:12: 3  1 … 5 s  takeoff: …`.
local function line_of_list(info)
  local list = vim.fn.getqflist({ id = info.id, items = 1 }).items
  local lines = {}
  for index = info.start_idx, info.end_idx do
    local item = list[index]
    local where = item.bufnr > 0
      and ('%s:%d'):format(vim.fn.fnamemodify(vim.fn.bufname(item.bufnr), ':t'), item.lnum) or ''
    table.insert(lines, ('%s| %d  %s'):format(where, item.nr, item.text))
  end
  return lines
end

-- Changes come first, since long lines are cut off at the end.
local function note(shown, step)
  local notes = { { ('  step %d of %d '):format(shown.at, #shown.trace.steps), 'ProskillStepNote' } }
  for _, change in ipairs(step and step.changes or {}) do
    table.insert(notes, { ' ' .. steps.change(change) .. ' ', 'ProskillStepChange' })
  end
  if step then
    local why = step.why ~= '' and ' · why: ' .. step.why or ''
    table.insert(notes, { (' %s · %s%s'):format(steps.date(step), step.description, why), 'ProskillStepNote' })
  end
  return notes
end

local function place_of(shown, number)
  return number == 0 and shown.place or shown.trace.steps[number] and shown.trace.steps[number].place
end

-- The places are those of the present text.
local function set_marks(shown)
  local places = {}
  for number = 0, #shown.trace.steps do
    places[number] = place_of(shown, number)
  end
  step_marks.set(places)
end

local function mark(shown, step)
  local where = step_marks.now(shown.at)
  if not where then
    return
  end
  vim.api.nvim_buf_set_extmark(where.buffer, space, where.line, where.first, {
    end_row = where.last_line, end_col = where.last, hl_group = 'ProskillStep', priority = 150,
    sign_text = '▶', sign_hl_group = 'ProskillStepSign',
  })
  vim.api.nvim_buf_set_extmark(where.buffer, space, where.line, where.first, {
    virt_text = note(shown, step), virt_text_pos = 'eol',
  })
end

-- Shows a step's place in the program's window, wherever the cursor is.
local function scroll(shown)
  local where = step_marks.now(shown.at)
  if not where or not vim.api.nvim_win_is_valid(shown.window) then
    return
  end
  vim.api.nvim_win_call(shown.window, function()
    if vim.api.nvim_win_get_buf(shown.window) ~= where.buffer then
      vim.bo[where.buffer].buflisted = true
      vim.cmd('hide buffer ' .. where.buffer)
    end
    vim.api.nvim_win_set_cursor(shown.window, { where.line + 1, where.first })
    vim.cmd('normal! zv')
  end)
end

-- Dims the lines of irrelevant steps.
local function dim(shown, buffer)
  for number, step in ipairs(shown.trace.steps) do
    if not step.relevant then
      vim.api.nvim_buf_set_extmark(buffer, space, number, 0, {
        end_row = number + 1, hl_group = 'ProskillStepAside', hl_eol = false, priority = 200,
      })
    end
  end
end

local function render(number)
  local shown = M.shown
  shown.at = number
  local step = shown.trace.steps[number]
  loaded.clear(space)
  mark(shown, step)
  if shown.buffer and vim.api.nvim_buf_is_valid(shown.buffer) then
    dim(shown, shown.buffer)
  end
  values.show(shown)
end

-- Goes to a step; does nothing if the trace has no such step.
function M.go(number)
  local shown = M.shown
  if not shown or number < 0 or number > #shown.trace.steps then
    return
  end
  vim.fn.setqflist({}, 'a', { id = shown.list, idx = number + 1 })
  render(number)
  scroll(shown)
end

-- Moves by this many steps; after `toggle_relevant`, only relevant ones count.
local function move(by)
  local shown = M.shown
  if not shown then
    return
  end
  local number, left, direction = shown.at, math.abs(by), by < 0 and -1 or 1
  local last = #shown.trace.steps
  while left > 0 and number + direction >= 0 and number + direction <= last do
    number = number + direction
    local step = shown.trace.steps[number]
    if not shown.only_relevant or not step or step.relevant then
      left = left - 1
    end
  end
  local step = shown.trace.steps[number]
  if left == 0 or (shown.only_relevant and step and step.relevant) then
    M.go(number)
  end
end

function M.next(count) move(count or 1) end

function M.previous(count) move(-(count or 1)) end

-- Whether `next` and `previous` skip irrelevant steps.
function M.toggle_relevant()
  local shown = M.shown
  if not shown then
    return
  end
  shown.only_relevant = not shown.only_relevant
  message.info(shown.only_relevant and 'only the steps that matter' or 'all steps')
end

-- :cnext and similar commands fire no event, so this checks after each move of the cursor.
local function follow()
  local shown = M.shown
  if not shown then
    return
  end
  local list = vim.fn.getqflist({ id = 0, idx = 0 })
  if list.id ~= shown.list then
    return
  end
  if vim.bo.buftype == 'quickfix' and config.get().follow
     and vim.fn.getloclist(0, { filewinid = 0 }).filewinid == 0 then
    local number = vim.fn.line('.') - 1
    if number ~= shown.at then
      M.go(number)
    end
  elseif list.idx - 1 ~= shown.at then
    render(list.idx - 1)
  end
end

-- Without a server nobody else says that the text has changed.
local function notice_edit()
  if M.shown then
    M.title(client.are_current(M.shown.texts) and '' or ' (of an older text)')
  end
end

local function watch(shown)
  local group = vim.api.nvim_create_augroup('proskill.trace', {})
  vim.api.nvim_create_autocmd({ 'CursorMoved', 'BufEnter', 'WinEnter' },
                              { group = group, callback = follow })
  if not shown.source then
    vim.api.nvim_create_autocmd({ 'TextChanged', 'TextChangedI' }, { group = group, callback = notice_edit })
  end
end

-- :ProskillTraceClose
function M.close()
  if not M.shown then
    return
  end
  M.shown.unmap()
  M.shown = nil
  vim.api.nvim_create_augroup('proskill.trace', {})
  loaded.clear(space)
  step_marks.clear()
  values.close()
  vim.cmd('cclose')
end

-- In the quickfix window, while the trace is shown.
local function map_keys(buffer)
  for key, action in pairs({ [']'] = M.next, ['['] = M.previous, m = M.toggle_relevant, q = M.close }) do
    vim.keymap.set('n', key, function() action(vim.v.count1) end, { buffer = buffer, nowait = true })
  end
  return function()
    for _, key in ipairs({ ']', '[', 'm', 'q' }) do
      pcall(vim.keymap.del, 'n', key, { buffer = buffer })
    end
  end
end

-- Adds these words to the title of the list.
function M.title(more)
  vim.fn.setqflist({}, 'a', { id = M.shown.list, title = 'trace of ' .. M.shown.name .. more })
  vim.cmd('redrawstatus!')
end

-- The same steps at other places of the text: the cursor, the window of the program and the step stay.
function M.renew(trace)
  local shown = M.shown
  shown.trace = trace
  set_marks(shown)
  vim.fn.setqflist({}, 'r', {
    id = shown.list, title = 'trace of ' .. shown.name, items = items(shown), idx = shown.at + 1, quickfixtextfunc = line_of_list,
  })
  render(shown.at)
  vim.cmd('redrawstatus!')
end

-- `texts`: as they were when the trace was requested. `source`: the buffer whose program it is; nil if no server
-- verifies it.
local function open(verdict, trace, texts, source)
  if M.shown then
    M.close()
  end
  local stale = trace.stale or not client.are_current(texts)
  local shown = {
    trace = trace, at = 0, source = source, texts = texts, window = vim.api.nvim_get_current_win(),
    name = verdict.name, description = verdict.description, verdict = verdict.verdict, place = verdict.place,
  }
  vim.fn.setqflist({}, ' ', {
    title = 'trace of ' .. verdict.name, items = items(shown), idx = 1,
    quickfixtextfunc = line_of_list,
  })
  shown.list = vim.fn.getqflist({ id = 0 }).id
  M.shown = shown
  set_marks(shown)
  vim.cmd('botright copen')
  shown.unmap = map_keys(vim.api.nvim_get_current_buf())
  shown.buffer = vim.api.nvim_get_current_buf()
  vim.api.nvim_set_current_win(shown.window)
  values.open(shown)
  watch(shown)
  M.go(0)
  vim.cmd('redraw') -- removes the list to choose from, so that the message needs no key
  message.info(('%d steps; :cnext and :cprevious step, in the list ] and [; m: only the relevant steps, q ends'):format(#trace.steps))
  if stale then
    M.title(' (of an older text)')
    message.warn('the program has changed since: places may have moved')
  end
  vim.api.nvim_exec_autocmds('User', { pattern = 'ProskillTraceShown', modeline = false })
end

-- Requests the trace of a verdict from the server.
local function ask(buffer, verdict)
  local server, texts = client.of(buffer), client.texts()
  client.ask(buffer, 'proskill/trace', {
    textDocument = { uri = vim.uri_from_bufnr(buffer) }, name = verdict.name,
  }, function(problem, result)
    if problem then
      return message.error(problem.message)
    end
    open(verdict, steps.trace(result, server.offset_encoding), texts, buffer)
  end)
end

local function show(buffer, verdict, texts)
  if verdict.trace then
    open(verdict, steps.trace(verdict.trace), texts)
  elseif verdict.steps then
    ask(buffer, verdict)
  else
    message.info(('%s: %s, without a trace'):format(verdict.description, verdict.verdict))
  end
end

-- Violated properties, before warnings.
local function choose(buffer, verdicts, texts)
  local candidates = {}
  for _, is_error in ipairs({ true, false }) do
    for _, verdict in ipairs(verdicts) do
      if verdict.steps and not verdict.good and (verdict.severity == 'error') == is_error then
        table.insert(candidates, verdict)
      end
    end
  end
  if #candidates == 0 then
    return message.info('nothing is bad; name a property to see its trace')
  elseif #candidates == 1 then
    return show(buffer, candidates[1], texts)
  end
  vim.ui.select(candidates, {
    prompt = 'Trace of', format_item = function(verdict)
      return ('%s: %s, %s'):format(verdict.name, verdict.description:gsub('`', ''), verdict.verdict)
    end,
  }, function(chosen)
    if chosen then
      show(buffer, chosen, texts)
    end
  end)
end

-- :ProskillTrace: verifies what is named, else uses the verdicts of the last :ProskillVerify.
function M.show(name)
  local buffer = vim.api.nvim_get_current_buf()
  if vim.bo[buffer].filetype ~= 'proskill' then
    return message.error('not a ProSkill program')
  end
  local texts = client.texts()
  local last = verify.last and verify.last.buffer == buffer
    and verify.last.tick == vim.api.nvim_buf_get_changedtick(buffer) and verify.last.list
  if name == '' and last then
    return choose(buffer, last, texts)
  end
  verify.verdicts(buffer, name ~= '' and { name } or {}, function(verdicts, problem)
    if not verdicts then
      message.error(problem)
    elseif name == '' then
      choose(buffer, verdicts, texts)
    elseif #verdicts == 1 then
      show(buffer, verdicts[1], texts)
    else
      choose(buffer, verdicts, texts)
    end
  end)
end

return M
