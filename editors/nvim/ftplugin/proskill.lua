-- What every buffer with a ProSkill program gets.
if vim.b.did_ftplugin then
  return
end
vim.b.did_ftplugin = 1

local undo = { 'setlocal comments< commentstring< iskeyword< formatoptions< textwidth<' }
vim.bo.comments = ':;'
vim.bo.commentstring = '; %s'
vim.opt_local.iskeyword:append('$')
vim.opt_local.formatoptions:remove('t')
vim.opt_local.formatoptions:append('croql')
vim.bo.expandtab = true
vim.bo.shiftwidth = 2
vim.bo.softtabstop = 2

local config = require('proskill.config').get()
local treesitter = require('proskill.treesitter')
if config.highlight then
  treesitter.highlight(vim.api.nvim_get_current_buf())
end
if config.folds and treesitter.available() then
  vim.opt_local.foldmethod = 'expr'
  vim.opt_local.foldexpr = "v:lua.require'proskill.fold'.expression()"
  vim.opt_local.foldlevel = 99
  table.insert(undo, 'setlocal foldmethod< foldexpr< foldlevel<')
end
if config.client then
  require('proskill.client').attach(vim.api.nvim_get_current_buf())
end
vim.b.undo_ftplugin = table.concat(undo, ' | ')
