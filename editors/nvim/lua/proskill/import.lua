-- Programs of other languages as ProSkill programs.
local config = require('proskill.config')
local message = require('proskill.message')

local M = {}

local languages = { gen = 'gen', rl = 'rl', rlc = 'rl', xml = 'bt' }

-- The errors, in the quickfix list.
local function list(said)
  vim.fn.setqflist({}, ' ', { title = 'proskill import', lines = said, efm = '%f:%l:%c: %trror: %m' })
  if not vim.tbl_isempty(vim.fn.getqflist()) then
    vim.cmd('copen')
  end
end

-- :ProskillImport: writes the program beside the file, and opens it. `replace` one that is there.
function M.start(file, replace)
  file = vim.fn.fnamemodify(file ~= '' and file or vim.api.nvim_buf_get_name(0), ':p')
  local language = languages[vim.fn.fnamemodify(file, ':e')]
  local target = vim.fn.fnamemodify(file, ':r') .. '.proskill'
  if not language then
    return message.error('not a behavior tree (.xml), a component (.gen), a skillset (.rl) or a composite (.rlc)')
  elseif vim.fn.filereadable(target) == 1 and not replace then
    return message.error(('%s exists; :ProskillImport! replaces it'):format(vim.fn.fnamemodify(target, ':.')))
  end
  local command = config.command('import', language, file, '-o', target)
  if replace then
    table.insert(command, '--force')
  end
  local leaves = vim.fn.fnamemodify(file, ':h') .. '/leaves.json'
  if language ~= 'rl' and vim.fn.filereadable(leaves) == 1 then
    vim.list_extend(command, { '--leaves', leaves })
  end
  local fine, said = pcall(vim.fn.systemlist, command)
  if not fine then
    return message.error(('`%s` cannot be started'):format(command[1]))
  elseif vim.v.shell_error ~= 0 then
    message.error(said[1] or 'the import failed')
    return list(said)
  end
  vim.cmd('edit ' .. vim.fn.fnameescape(target))
  vim.cmd('checktime')
  message.info(table.concat(said, '\n'))
end

return M
