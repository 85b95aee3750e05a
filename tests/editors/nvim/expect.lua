-- Assertions on values; errors show both.
local M = {}

function M.equal(got, wanted)
  if not vim.deep_equal(got, wanted) then
    error(('got\n%s\nnot\n%s'):format(vim.inspect(got), vim.inspect(wanted)), 2)
  end
end

-- Shows only the first line that differs.
function M.lines(got, wanted, name)
  for number = 1, math.max(#got, #wanted) do
    if got[number] ~= wanted[number] then
      error(('%s:%d: got\n%s\nnot\n%s'):format(name, number, got[number], wanted[number]), 2)
    end
  end
end

function M.yes(value, what)
  if not value then
    error(what or 'not so', 2)
  end
end

function M.contains(text, part)
  if not text:find(part, 1, true) then
    error(('%s\nhas no\n%s'):format(text, part), 2)
  end
end

return M
