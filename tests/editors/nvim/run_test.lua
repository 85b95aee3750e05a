-- :ProskillRun.
local expect = require('expect')

local function drone(child)
  child:lua([[
    told = {}
    vim.notify = function(text) table.insert(told, text) end
    require('proskill.config').set({ cmd = { vim.env.PROSKILL_PROGRAM }, parser = vim.env.PROSKILL_PARSER })
  ]])
  child:open(child:copy('drone') .. '/drone.proskill')
end

return {
  { 'a run is served to a browser, and ends when it is asked to', function(child)
    drone(child)
    child:lua("vim.cmd('ProskillRun --no-open --clock real')")
    child:wait('return #told > 0')
    expect.contains(child:lua('return told[1]'), 'drone.proskill runs at http://127.0.0.1:')
    child:lua("vim.cmd('ProskillRun!')")
    child:lua("vim.cmd('ProskillRun --no-open --platform /nowhere.json')")
    child:wait('return #told > 1')
    expect.contains(child:lua('return told[2]'), '/nowhere.json')
  end },

  { 'a text with changes is not run', function(child)
    drone(child)
    child:keys('O; new<Esc>')
    child:lua("vim.cmd('ProskillRun')")
    expect.contains(child:lua('return told[1]'), 'not saved')
  end },
}
