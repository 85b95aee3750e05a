-- A Neovim that a test drives: the test types keys into it, and queries it in Lua.
local Child = {}
Child.__index = Child

local root = vim.env.PROSKILL_ROOT
local deadline = tonumber(vim.env.PROSKILL_DEADLINE) or 20000 -- milliseconds that a condition may take to come true
local count = 0

local function homes(directory)
  local result = {}
  for _, kind in ipairs({ 'CONFIG', 'DATA', 'STATE', 'CACHE' }) do
    result['XDG_' .. kind .. '_HOME'] = directory .. '/.' .. kind:lower()
  end
  return result
end

function Child.new()
  count = count + 1
  local self = setmetatable({ directory = ('%s/%d'):format(vim.env.PROSKILL_SCRATCH, count) }, Child)
  vim.fn.mkdir(self.directory, 'p')
  self.channel = vim.fn.jobstart(
    { vim.env.PROSKILL_NVIM, '--embed', '--headless', '-u', 'NONE', '-i', 'NONE', '-n',
      '--cmd', 'set runtimepath^=' .. root .. '/editors/nvim' },
    { rpc = true, cwd = self.directory, env = homes(self.directory) })
  self:lua([[
    vim.cmd('runtime! plugin/proskill.lua')
    vim.cmd('filetype plugin indent on | syntax on')
    vim.o.columns, vim.o.lines, vim.o.shortmess, vim.o.hidden = 120, 40, vim.o.shortmess .. 'cF', true
    require('proskill').setup(...)
  ]], { cmd = { vim.env.PROSKILL_PROGRAM }, parser = vim.env.PROSKILL_PARSER })
  return self
end

-- Runs Lua in the other Neovim, with arguments as `...`.
function Child:lua(code, ...)
  return vim.rpcrequest(self.channel, 'nvim_exec_lua', code, { ... })
end

-- Types keys, as |nvim_input| takes them.
function Child:keys(keys)
  vim.rpcrequest(self.channel, 'nvim_input', keys)
end

-- Waits until a piece of Lua returns a value that is neither false nor nil, and returns it.
function Child:wait(code, ...)
  local value
  local arguments = { ... }
  local fine = vim.wait(deadline, function()
    value = self:lua(code, unpack(arguments))
    return value ~= nil and value ~= vim.NIL and value ~= false
  end, 10)
  if not fine then
    error(('this never came true:\n%s\nat the cursor:\n%s'):format(code, self:around()), 2)
  end
  return value
end

function Child:around()
  return self:lua([[
    local line = vim.fn.line('.')
    return table.concat(vim.fn.getline(math.max(1, line - 5), line + 5), '\n')
  ]])
end

function Child:lines()
  return self:lua('return vim.api.nvim_buf_get_lines(0, 0, -1, true)')
end

-- A copy of an example's directory; returns its path.
function Child:copy(example)
  local target = self.directory .. '/' .. example
  vim.fn.system({ 'cp', '-r', root .. '/examples/' .. example, target })
  return target
end

-- Writes a file beside the others, and returns its path.
function Child:file(name, text)
  local path = self.directory .. '/' .. name
  vim.fn.writefile(vim.split(text, '\n'), path)
  return path
end

function Child:edit(path)
  self:lua('vim.cmd("edit " .. vim.fn.fnameescape(...))', path)
end

-- Opens a file, and waits for its server.
function Child:open(path)
  self:edit(path)
  self:wait("return require('proskill.client').of(0) ~= nil")
end

-- Puts the cursor on the first position after the caret `|` in a line of the text.
function Child:at(pattern)
  local before, after = pattern:match('^(.-)|(.*)$')
  local line, column = unpack(self:lua([[
    local text = ...
    for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, true)) do
      local at = line:find(text, 1, true)
      if at then return { number, at - 1 } end
    end
    return { 0, 0 }
  ]], before .. after))
  assert(line > 0, 'no line has ' .. pattern)
  self:lua('vim.api.nvim_win_set_cursor(0, { ... })', line, column + #before)
end

function Child:stop()
  pcall(vim.rpcnotify, self.channel, 'nvim_command', 'qall!')
  if vim.fn.jobwait({ self.channel }, 5000)[1] == -1 then
    vim.fn.jobstop(self.channel)
  end
end

return Child
