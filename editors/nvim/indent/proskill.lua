if vim.b.did_indent then
  return
end
vim.b.did_indent = 1

vim.bo.lisp = false
vim.bo.autoindent = true
if require('proskill.treesitter').available() then
  vim.bo.indentexpr = "v:lua.require'proskill.indent'.expression()"
  vim.bo.indentkeys = '!^F,o,O,0(,0:,=elseif,=else,=until'
  vim.b.undo_indent = 'setlocal indentexpr< indentkeys< autoindent<'
end
