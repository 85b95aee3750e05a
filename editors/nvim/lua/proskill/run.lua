-- Runs a program, and shows the run in the browser.
local config = require('proskill.config')
local message = require('proskill.message')

local M = {}

local running = nil -- the job

-- Ends the run: its actions are asked to stop.
function M.stop()
  if running then
    vim.fn.jobstop(running)
  end
  running = nil
end

-- Reports the address of the page, and why a run ends that has not begun.
local function listen(file, said)
  local name = vim.fn.fnamemodify(file, ':t')
  local shown = false
  return function(_, lines)
    said.text = said.text .. table.concat(lines, '\n') -- the first continues the last before
    local address = said.text:match('shown at (http://%S+/)')
    if address and not shown then
      shown = true
      message.info(('%s runs at %s'):format(name, address))
    end
  end
end

-- :ProskillRun: arguments are options of `proskill run`.
function M.start(options)
  local buffer = vim.api.nvim_get_current_buf()
  local file = vim.api.nvim_buf_get_name(buffer)
  if vim.bo[buffer].filetype ~= 'proskill' then
    return message.error('not a ProSkill program')
  elseif file == '' or vim.bo[buffer].modified then
    return message.error('the program has changes that are not saved; :write first')
  end
  M.stop()
  local command = config.command('run', '--view')
  vim.list_extend(command, options)
  table.insert(command, file)
  local said = { text = '' }
  local fine, id = pcall(vim.fn.jobstart, command, {
    on_stderr = listen(file, said),
    on_exit = function(ended, code)
      if running == ended then
        running = nil
      end
      if code == 2 then
        message.error(vim.trim(said.text))
      end
    end,
  })
  if not fine or id <= 0 then
    return message.error(('`%s` cannot be started'):format(command[1]))
  end
  running = id
end

return M
