-- The order in which people look for names: s2 comes before s10.
local M = {}

-- Numbers of one length, without zeros in front, are in the order of their digits.
local function key(name)
  return (name:gsub('%d+', function(digits)
    local number = digits:gsub('^0+', '')
    return ('%03d'):format(#number) .. number
  end))
end

function M.before(a, b)
  local first, second = key(a), key(b)
  if first ~= second then
    return first < second
  end
  return a < b
end

return M
