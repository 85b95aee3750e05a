-- Settings and their defaults. :help proskill-configuration
local M = {}

local defaults = {
  cmd = { 'proskill' },       -- the program, with arguments before the subcommand
  client = true,              -- start the language server
  keymaps = true,             -- in buffers with the server, if Neovim has none of its own
  highlight = true,
  folds = true,
  parser = nil,               -- path of proskill.so, if it is not on the runtime path
  grammar = nil,              -- path of tree-sitter-proskill/
  viewer = nil,               -- function(path) or a program, for pictures; nil: the system's
  dark = nil,                 -- pictures for a dark page; nil: as 'background' says
  follow = true,              -- show a trace's step when the cursor moves through the list
  offset_encodings = { 'utf-8', 'utf-16' },
  settings = {},              -- the section `proskill` of the settings, for the server
  init_options = nil,
  on_attach = nil,            -- function(client, buffer)
  flags = nil,                -- of vim.lsp.start_client
}

local current = defaults

function M.set(options)
  current = vim.tbl_deep_extend('force', defaults, options or {})
end

function M.get()
  return current
end

-- The program with these arguments, as a list.
function M.command(...)
  return vim.list_extend(vim.deepcopy(current.cmd), { ... })
end

return M
