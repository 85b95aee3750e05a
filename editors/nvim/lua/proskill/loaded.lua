-- All buffers that are loaded.
local M = {}

-- Removes the marks of a namespace.
function M.clear(space)
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_is_loaded(buffer) then
      vim.api.nvim_buf_clear_namespace(buffer, space, 0, -1)
    end
  end
end

return M
