-- Runs the program asynchronously.
local M = {}

-- `ended` receives the exit code, the output, and what was written to standard error. Returns a
-- function that stops the program, or nil if it cannot be started.
function M.run(command, ended)
  local out, err = {}, {}
  local function collect(into)
    return function(_, lines) vim.list_extend(into, lines) end
  end
  local fine, id = pcall(vim.fn.jobstart, command, {
    stdout_buffered = true, stderr_buffered = true,
    on_stdout = collect(out), on_stderr = collect(err),
    on_exit = function(_, code)
      ended(code, table.concat(out, '\n'), table.concat(err, '\n'))
    end,
  })
  if not fine or id <= 0 then
    return nil
  end
  return function() vim.fn.jobstop(id) end
end

function M.json(text)
  local decode = vim.json and vim.json.decode or vim.fn.json_decode
  local fine, value = pcall(decode, text)
  return fine and value or nil
end

return M
