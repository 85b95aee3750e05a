-- Compares the trace on display with the verdicts of live verification. Nothing moves: the title of the list says that the
-- steps are of an older text, or what the verdict is now; equal steps only get their new places.
local client = require('proskill.client')
local steps = require('proskill.steps')

local M = {}

-- By program: verdicts by the names of the properties.
local known = {}

local function present(value)
  return value ~= vim.NIL and value or nil
end

local function note(params)
  if not params.changes or not known[params.program] then
    known[params.program] = {}
  end
  for _, verdict in ipairs(params.verdicts) do
    known[params.program][verdict.name] = verdict
  end
end

local function concerns(params, buffer)
  local uri = vim.uri_from_bufnr(buffer)
  for _, text in ipairs(params.texts or {}) do
    if text.uri == uri then
      return true
    end
  end
  return false
end

-- Whether two traces have the same steps, wherever in the text.
local function same(one, other)
  if #one.steps ~= #other.steps then
    return false
  end
  for index, step in ipairs(one.steps) do
    local now = other.steps[index]
    if step.actor ~= now.actor or step.description ~= now.description or steps.changes(step) ~= steps.changes(now)
       or steps.date(step) ~= steps.date(now) then
      return false
    end
  end
  return true
end

local function compare(shown, trace, buffer)
  local server, texts = client.of(buffer), client.texts()
  client.ask(buffer, 'proskill/trace', {
    textDocument = { uri = vim.uri_from_bufnr(buffer) }, name = shown.name,
  }, function(problem, result)
    if problem or trace.shown ~= shown or not server or not client.are_current(texts) then
      return -- after an edit, another verification follows
    end
    local now = steps.trace(result, server.offset_encoding)
    if now.stale then
      return
    elseif same(shown.trace, now) then
      trace.renew(now)
    else
      trace.title((' (of an older text; :ProskillTrace %s shows the present one)'):format(shown.name))
    end
  end)
end

-- Handles a notification of live verification.
function M.told(params)
  note(params)
  local trace = require('proskill.trace')
  local shown = trace.shown
  if not shown or not shown.source or not vim.api.nvim_buf_is_valid(shown.source) or not concerns(params, shown.source) then
    return
  end
  local verdict = known[params.program][shown.name]
  if params.state ~= 'done' or params.stale then
    if params.stale or params.state == 'errors' then
      trace.title(' (of an older text)')
    end
  elseif not verdict then
    trace.title(' (of an older text, which had this property)')
  elseif not present(verdict.steps) then
    trace.title((' (of an older text; now: %s)'):format(verdict.verdict))
  else
    compare(shown, trace, shown.source)
  end
end

return M
