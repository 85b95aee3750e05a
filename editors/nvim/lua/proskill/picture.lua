-- Pictures of the parts of a program.
local client = require('proskill.client')
local config = require('proskill.config')
local job = require('proskill.job')
local message = require('proskill.message')
local treesitter = require('proskill.treesitter')

local M = {}

local function is_dark()
  if config.get().dark ~= nil then
    return config.get().dark
  end
  return vim.o.background == 'dark'
end

local drawn = { skill = true, state_variable = true, environment = true }

-- The names of what can be drawn, and of the definition at the cursor.
local function definitions(buffer)
  local names, current = {}, nil
  local line = vim.api.nvim_win_get_cursor(0)[1] - 1
  local root = treesitter.root(buffer)
  for node in root and root:iter_children() or function() end do
    local name = drawn[node:type()] and node:named_child(0)
    if name then
      local row, first, _, last = name:range()
      local text = vim.api.nvim_buf_get_lines(buffer, row, row + 1, true)[1]:sub(first + 1, last)
      table.insert(names, text)
      local from, _, to = node:range()
      current = from <= line and line <= to and text or current
    end
  end
  return names, current
end

function M.names(begin)
  return vim.tbl_filter(function(name) return vim.startswith(name, begin) end,
                        (definitions(vim.api.nvim_get_current_buf())))
end

local function viewer(path)
  local chosen = config.get().viewer
  if type(chosen) == 'function' then
    return chosen(path)
  elseif type(chosen) == 'string' then
    return vim.fn.jobstart({ chosen, path }, { detach = true })
  elseif vim.ui.open then
    local _, problem = vim.ui.open(path)
    return problem and message.warn(problem)
  end
  for _, program in ipairs({ 'xdg-open', 'open', 'wslview' }) do
    if vim.fn.executable(program) == 1 then
      return vim.fn.jobstart({ program, path }, { detach = true })
    end
  end
  message.warn('nothing here shows pictures; it is in ' .. path)
end

local function show_svg(name, content)
  local directory = vim.fn.stdpath('cache') .. '/proskill'
  vim.fn.mkdir(directory, 'p')
  local path = ('%s/%s.svg'):format(directory, name:gsub('[^%w_.-]', '_'))
  vim.fn.writefile(vim.split(content, '\n', { plain = true }), path)
  viewer(path)
end

local function show_dot(name, content)
  vim.cmd('botright new')
  local buffer = vim.api.nvim_get_current_buf()
  vim.api.nvim_buf_set_lines(buffer, 0, -1, true, vim.split(vim.trim(content), '\n'))
  vim.bo.buftype, vim.bo.bufhidden, vim.bo.swapfile = 'nofile', 'wipe', false
  vim.bo.modifiable = false
  pcall(vim.api.nvim_buf_set_name, buffer, ('proskill://automaton/%s.dot'):format(name))
  vim.bo.filetype = 'dot'
end

local function by_program(buffer, name, dot, done)
  local path = vim.api.nvim_buf_get_name(buffer)
  if path == '' or vim.bo[buffer].modified then
    return message.error('the program has changes that are not saved; :write first')
  end
  local command = config.command('graph', '--format', dot and 'dot' or 'svg')
  vim.list_extend(command, name and { '--name', name } or { '--kind', 'calls' })
  if is_dark() then
    table.insert(command, '--dark')
  end
  table.insert(command, path)
  local stop = job.run(command, function(code, out, err)
    if code ~= 0 then
      message.error(vim.trim(err))
    else
      done(name or 'calls', out)
    end
  end)
  if not stop then
    message.error(('`%s` cannot be started'):format(command[1]))
  end
end

local function position(buffer, encoding)
  local line, column = unpack(vim.api.nvim_win_get_cursor(0))
  local text = vim.api.nvim_buf_get_lines(buffer, line - 1, line, true)[1]:sub(1, column)
  local counted = 0
  for character in text:gmatch('[^\128-\191][\128-\191]*') do
    counted = counted + (encoding == 'utf-8' and #character
                         or encoding == 'utf-16' and #character == 4 and 2 or 1)
  end
  return { line = line - 1, character = counted }
end

-- :ProskillAutomaton: draws what is named, else the definition at the cursor, else the calls.
function M.show(name, dot)
  local buffer = vim.api.nvim_get_current_buf()
  if vim.bo[buffer].filetype ~= 'proskill' then
    return message.error('not a ProSkill program')
  end
  local show = dot and show_dot or show_svg
  local server = client.of(buffer)
  local params = {
    textDocument = { uri = vim.uri_from_bufnr(buffer) }, dark = is_dark(),
    format = dot and 'dot' or 'svg',
    name = name ~= '' and name or nil,
    position = name == '' and server and position(buffer, server.offset_encoding) or nil,
  }
  local _, current = definitions(buffer)
  local asked = client.ask(buffer, 'proskill/automaton', params, function(problem, result)
    if not problem then
      show(result.name ~= '' and result.name or 'calls', result.content)
    elseif problem.code == client.unknown_method then
      by_program(buffer, name ~= '' and name or current, dot, show)
    else
      message.error(problem.message)
    end
  end)
  if not asked then
    by_program(buffer, name ~= '' and name or current, dot, show)
  end
end

return M
