-- Verdicts on the program in a buffer: from the server, or from `proskill verify` if no server supports this.
local client = require('proskill.client')
local config = require('proskill.config')
local job = require('proskill.job')
local message = require('proskill.message')
local place = require('proskill.place')

local M = {}

-- The last verdicts: { buffer, list = { { name, description, verdict, good, severity, place, trace, steps } } }.
M.last = nil

local cancel = nil

local function verdict_of(from, where)
  local function present(value)
    if value ~= vim.NIL then
      return value
    end
  end
  return {
    name = from.name, description = from.description, verdict = from.verdict, good = from.good,
    severity = from.severity, place = where, reason = present(from.reason),
    trace = present(from.trace), steps = present(from.steps),
  }
end

-- Converts the answer to `proskill/verify`.
local function of_protocol(result, encoding)
  return vim.tbl_map(function(from)
    return verdict_of(from, place.of_protocol(from.location, encoding))
  end, result.verdicts)
end

-- Converts the output of `proskill verify --format json`.
local function of_program(report)
  return vim.tbl_map(function(from)
    local verdict = verdict_of(from, place.of_program(from.location))
    verdict.steps = verdict.trace and #verdict.trace.steps or nil
    return verdict
  end, report.properties)
end

local function count(list)
  local counts = { good = 0, bad = 0, look = 0 }
  for _, verdict in ipairs(list) do
    local kind = verdict.good and 'good' or verdict.severity == 'error' and 'bad' or 'look'
    counts[kind] = counts[kind] + 1
  end
  return ('%d properties: %d good, %d bad, %d warning%s'):format(
    #list, counts.good, counts.bad, counts.look, counts.look == 1 and '' or 's')
end

local function item_of(verdict)
  local kind = verdict.good and 'I' or verdict.severity == 'error' and 'E' or 'W'
  local reason = (verdict.reason or '') ~= '' and ' (' .. verdict.reason .. ')' or ''
  return place.item(verdict.place, {
    type = kind, text = ('%s: %s%s'):format(verdict.description, verdict.verdict, reason),
    module = verdict.name,
  })
end

-- Shows the verdicts that are not good in the quickfix list, or `all`.
local function list(verdicts, all)
  local items = {}
  for _, verdict in ipairs(verdicts) do
    if all or not verdict.good then
      table.insert(items, item_of(verdict))
    end
  end
  vim.fn.setqflist({}, ' ', { title = 'proskill verify: ' .. count(verdicts), items = items })
  if #items > 0 then
    local window = vim.api.nvim_get_current_win()
    vim.cmd('botright copen')
    vim.api.nvim_set_current_win(window)
  end
end

local function by_program(buffer, names, done)
  local path = vim.api.nvim_buf_get_name(buffer)
  if path == '' or vim.bo[buffer].modified then
    return done(nil, 'the program has changes that are not saved; :write first')
  end
  local command = config.command('verify', '--format', 'json', '--traces', 'all')
  for _, name in ipairs(names) do
    vim.list_extend(command, { '--property', name })
  end
  table.insert(command, path)
  cancel = job.run(command, function(code, out, err)
    cancel = nil
    local report = code <= 1 and job.json(out)
    if report then
      done(of_program(report))
    else
      done(nil, vim.trim(err) ~= '' and vim.trim(err) or 'stopped')
    end
  end)
  if not cancel then
    done(nil, ('`%s` cannot be started'):format(command[1]))
  end
end

-- Verifies the properties with these names, or all. `done` receives the verdicts, or nil and a message.
function M.verdicts(buffer, names, done)
  local asked, stop = client.ask(buffer, 'proskill/verify', {
    textDocument = { uri = vim.uri_from_bufnr(buffer) },
    names = #names > 0 and names or nil,
  }, function(problem, result)
    cancel = nil
    if problem and problem.code == client.unknown_method then
      by_program(buffer, names, done)
    elseif problem then
      done(nil, problem.message)
    else
      done(of_protocol(result, client.of(buffer).offset_encoding))
    end
  end)
  if asked then
    cancel = stop
  else
    by_program(buffer, names, done)
  end
end

-- :ProskillVerify
function M.run(names, all)
  if cancel then
    return message.warn('still verifying; :ProskillStop ends it')
  end
  local buffer = vim.api.nvim_get_current_buf()
  if vim.bo[buffer].filetype ~= 'proskill' then
    return message.error('not a ProSkill program')
  end
  local tick = vim.api.nvim_buf_get_changedtick(buffer)
  M.verdicts(buffer, names, function(verdicts, problem)
    if not verdicts then
      return message.error(problem)
    end
    M.last = { buffer = buffer, tick = tick, list = verdicts }
    list(verdicts, all)
    message.info(count(verdicts))
    vim.api.nvim_exec_autocmds('User', { pattern = 'ProskillVerified', modeline = false })
  end)
end

-- :ProskillStop
function M.stop()
  if cancel then
    cancel()
    cancel = nil
  else
    message.info('nothing is being verified')
  end
end

-- In the words of the command line and of other editors.
local function found(counts)
  local parts = {}
  for _, kind in ipairs({
    { counts.errors, 'bad', 'bad' }, { counts.warnings, 'warning', 'warnings' }, { counts.inconclusive, 'inconclusive', 'inconclusive' },
  }) do
    local number, one, several = unpack(kind)
    if number > 0 then
      table.insert(parts, ('%d %s'):format(number, number == 1 and one or several))
    end
  end
  return #parts > 0 and table.concat(parts, ', ') or ('%d of %d good'):format(counts.good, counts.total)
end

-- Handles notifications of live verification. The status line shows b:proskill_status in the buffers of the
-- program.
function M.told(verdicts)
  local words = {
    checking = 'verifying', errors = 'has errors', failed = 'not verified', off = '', waiting = '…',
    done = verdicts.counts and found(verdicts.counts) or '',
  }
  local status = (words[verdicts.state] or '') .. (verdicts.stale and ' (of an older text)' or '')
  for _, text in ipairs(verdicts.texts or {}) do
    local buffer = vim.uri_to_bufnr(text.uri)
    if vim.api.nvim_buf_is_loaded(buffer) then
      vim.b[buffer].proskill_status = status
    end
  end
  require('proskill.trace_news').told(verdicts)
end

-- Names of properties with this beginning, for the command line.
function M.names(begin, with_trace)
  local names = {}
  for _, verdict in ipairs(M.last and M.last.list or {}) do
    if vim.startswith(verdict.name, begin) and (not with_trace or verdict.steps) then
      table.insert(names, verdict.name)
    end
  end
  return names
end

return M
