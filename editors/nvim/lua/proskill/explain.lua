-- Explains the code of a diagnostic in a window at the cursor.
local client = require('proskill.client')
local message = require('proskill.message')

local M = {}

-- The code of the diagnostic at the cursor, else of another in its line.
local function code_here()
  local line, column = unpack(vim.api.nvim_win_get_cursor(0))
  local found
  for _, it in ipairs(vim.diagnostic.get(0, { lnum = line - 1 })) do
    local under = it.col <= column and (it.end_lnum > line - 1 or column < it.end_col)
    if it.source == 'proskill' and (under or not found) then
      found = it.code
    end
  end
  return found
end

function M.show(code)
  code = code ~= '' and code or code_here()
  if not code then
    return message.info('no diagnostic on this line')
  end
  local asked = client.ask(0, 'proskill/explain', { code = code }, function(problem, result)
    if problem then
      return message.warn(problem.message)
    end
    vim.lsp.util.open_floating_preview(vim.split(result.markdown, '\n'), 'markdown',
                                       { focus_id = 'proskill.explain.' .. result.code, max_width = 80 })
  end)
  if not asked then
    message.warn('no language server is running for this text')
  end
end

return M
