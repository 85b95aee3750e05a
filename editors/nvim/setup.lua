-- Makes this directory a plugin, wherever it is: for plugin managers that know only a repository's root, and for a clone.
--   dofile('/path/to/the/clone/editors/nvim/setup.lua')
local here = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h')
vim.opt.runtimepath:append(here)
vim.cmd('source ' .. vim.fn.fnameescape(here .. '/plugin/proskill.lua'))
-- as Neovim itself sources them, if file types are already on
vim.cmd('augroup filetypedetect')
for _, file in ipairs(vim.fn.glob(here .. '/ftdetect/*.vim', false, true)) do
  vim.cmd('source ' .. vim.fn.fnameescape(file))
end
vim.cmd('augroup END')
