if vim.g.loaded_proskill then
  return
end
vim.g.loaded_proskill = true

local command = vim.api.nvim_create_user_command

command('ProskillAutomaton', function(given)
  require('proskill.picture').show(given.args, given.bang)
end, {
  nargs = '?', bang = true, desc = 'Draw the definition at the cursor, or the one named; with ! as DOT',
  complete = function(begin) return require('proskill.picture').names(begin) end,
})

command('ProskillVerify', function(given)
  require('proskill.verify').run(given.fargs, given.bang)
end, {
  nargs = '*', bang = true, desc = 'Verify the program; with ! list the good verdicts, too',
  complete = function(begin) return require('proskill.verify').names(begin) end,
})

command('ProskillRun', function(given)
  if given.bang then
    return require('proskill.run').stop()
  end
  require('proskill.run').start(given.fargs)
end, {
  nargs = '*', bang = true, complete = 'file',
  desc = 'Run the program, and show the run in the browser; with ! end it',
})

command('ProskillImport', function(given)
  require('proskill.import').start(given.args, given.bang)
end, {
  nargs = '?', bang = true, complete = 'file',
  desc = 'Translate a behavior tree, component or skillset; with ! replace a program that is there',
})

command('ProskillTrace', function(given)
  require('proskill.trace').show(given.args)
end, {
  nargs = '?', desc = 'Show the trace of a verdict, step by step',
  complete = function(begin) return require('proskill.verify').names(begin, true) end,
})

command('ProskillExplain', function(given)
  require('proskill.explain').show(given.args)
end, { nargs = '?', desc = 'Explain a code, or the diagnostic at the cursor' })

-- The code action with this name.
vim.lsp.commands['proskill.explain'] = function(chosen)
  require('proskill.explain').show(chosen.arguments[1])
end

command('ProskillTraceClose', function() require('proskill.trace').close() end,
  { desc = 'Put the trace away' })
command('ProskillStop', function() require('proskill.verify').stop() end,
  { desc = 'Stop verifying' })
command('ProskillRestart', function() require('proskill.client').restart() end,
  { desc = 'Start the language server anew' })
command('ProskillBuildParser', function() require('proskill.treesitter').build() end,
  { desc = 'Compile the parser for colours, folds and indentation' })

-- Platform files are checked while they are edited. A program may name another file, or none any more.
local function platforms() require('proskill.platform').update_soon() end
local group = vim.api.nvim_create_augroup('proskill_platforms', {})
local function on(events, pattern)
  vim.api.nvim_create_autocmd(events, { group = group, pattern = pattern, callback = platforms })
end
on({ 'BufReadPost', 'BufNewFile', 'BufFilePost', 'BufUnload', 'TextChanged', 'TextChangedI', 'TextChangedP' }, '*.json')
on({ 'TextChanged', 'InsertLeave', 'BufUnload' }, '*.proskill')
