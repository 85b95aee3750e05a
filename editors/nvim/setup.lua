-- Makes this directory a plugin, wherever it lies: for plugin managers that know a repository's root alone, and for a clone.
--   dofile('/path/to/the/clone/editors/nvim/setup.lua')
local here = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h')
vim.opt.runtimepath:append(here)
vim.cmd('source ' .. vim.fn.fnameescape(here .. '/plugin/proskill.lua'))
-- As Neovim itself reads them, where file types are on already.
vim.cmd('augroup filetypedetect')
for _, file in ipairs(vim.fn.glob(here .. '/ftdetect/*.vim', false, true)) do
  vim.cmd('source ' .. vim.fn.fnameescape(file))
end
vim.cmd('augroup END')
