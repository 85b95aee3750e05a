-- ProSkill for Neovim. It works without a call of `setup`; :help proskill
local M = {}

-- To be called before the first program is opened. See lua/proskill/config.lua.
function M.setup(options)
  require('proskill.config').set(options)
end

return M
