-- Folds by queries/proskill/folds.scm. Neovim has such an expression only since 0.9.
local treesitter = require('proskill.treesitter')

local M = {}

-- By buffer: the change they are based on, and the level of each line.
local known = {}

local function starts_and_depths(buffer)
  local starts, change = {}, {}
  local root, query = treesitter.root(buffer), treesitter.query('folds')
  for _, node in query:iter_captures(root, buffer, 0, vim.api.nvim_buf_line_count(buffer)) do
    local first, _, last = node:range()
    if last > first then
      starts[first] = true
      change[first] = (change[first] or 0) + 1
      change[last + 1] = (change[last + 1] or 0) - 1
    end
  end
  return starts, change
end

local function levels_of(buffer)
  local starts, change = starts_and_depths(buffer)
  local levels, depth = {}, 0
  for line = 0, vim.api.nvim_buf_line_count(buffer) - 1 do
    depth = depth + (change[line] or 0)
    levels[line + 1] = (starts[line] and '>' or '') .. depth
  end
  return levels
end

function M.expression()
  if vim.treesitter.foldexpr then
    return vim.treesitter.foldexpr()
  end
  local buffer = vim.api.nvim_get_current_buf()
  local tick = vim.api.nvim_buf_get_changedtick(buffer)
  if not known[buffer] or known[buffer].tick ~= tick then
    known[buffer] = { tick = tick, levels = levels_of(buffer) }
  end
  return known[buffer].levels[vim.v.lnum] or '0'
end

return M
