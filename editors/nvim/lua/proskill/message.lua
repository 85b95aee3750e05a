-- Messages to the user.
local M = {}

local function say(text, level)
  vim.notify('proskill: ' .. text, level)
end

function M.info(text) say(text, vim.log.levels.INFO) end
function M.warn(text) say(text, vim.log.levels.WARN) end
function M.error(text) say(text, vim.log.levels.ERROR) end

return M
