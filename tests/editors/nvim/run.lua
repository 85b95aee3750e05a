-- Runs the tests of one script, functions in a table of { name, function }, each with a new Neovim. Prints the
-- failures; the exit code is then 1.
local directory = vim.env.PROSKILL_ROOT .. '/tests/editors/nvim'
package.path = directory .. '/?.lua;' .. package.path
local Child = require('child')

local failed = 0
for _, test in ipairs(dofile(vim.env.PROSKILL_SCRIPT)) do
  local child = Child.new()
  local fine, problem = xpcall(test[2], debug.traceback, child)
  if not fine then
    failed = failed + 1
    io.stdout:write(('FAILED %s\n%s\n'):format(test[1], problem))
    pcall(function() io.stdout:write('  Neovim says: ' .. child:lua("return vim.fn.execute('messages')") .. '\n') end)
  else
    io.stdout:write(('fine   %s\n'):format(test[1]))
  end
  child:stop()
end
io.stdout:flush()
vim.cmd(failed == 0 and 'qall!' or 'cquit 1')
