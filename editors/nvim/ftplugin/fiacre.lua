-- What every buffer with a model in Fiacre gets.
if vim.b.did_ftplugin then
  return
end
vim.b.did_ftplugin = 1

vim.bo.comments = 's1:/*,mb:*,ex:*/,://'
vim.bo.commentstring = '// %s'
vim.bo.expandtab = true
vim.bo.shiftwidth = 4
vim.bo.softtabstop = 4
if require('proskill.config').get().client then
  require('proskill.client').attach(vim.api.nvim_get_current_buf())
end
vim.b.undo_ftplugin = 'setlocal comments< commentstring< expandtab< shiftwidth< softtabstop<'
