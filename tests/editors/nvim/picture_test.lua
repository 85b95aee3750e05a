-- :ProskillAutomaton.
local expect = require('expect')

-- The drone's program; `viewed` is the last picture shown, `told` the last message.
local function drone(child, setup)
  child:lua([[
    told, viewed = {}, nil
    vim.notify = function(text) table.insert(told, text) end
    require('proskill.config').set(vim.tbl_extend('force', {
      cmd = { vim.env.PROSKILL_PROGRAM }, parser = vim.env.PROSKILL_PARSER,
      viewer = function(path) viewed = path end,
    }, ... or {}))
  ]], setup)
  child:open(child:copy('drone') .. '/drone.proskill')
end

local function picture(child)
  return table.concat(vim.fn.readfile(child:wait('return viewed')), '\n')
end

local function dot(child)
  child:wait("return vim.bo.filetype == 'dot'")
  return table.concat(child:lines(), '\n')
end

return {
  { 'a picture of what the cursor stands in is shown', function(child)
    drone(child)
    child:at('(defskill take|off')
    child:lua("vim.cmd('ProskillAutomaton')")
    local svg = picture(child)
    expect.contains(svg, '<svg')
    expect.contains(svg, 'skill takeoff')
  end },

  { 'what the cursor stands in is known without the tree-sitter parser', function(child)
    drone(child, { parser = '/nowhere' })
    child:at('(defskill take|off')
    child:lua("vim.cmd('ProskillAutomaton')")
    expect.contains(picture(child), 'skill takeoff')
  end },

  { 'between definitions it is who calls whom', function(child)
    drone(child)
    child:lua("vim.api.nvim_win_set_cursor(0, { 1, 0 })")
    child:lua("vim.cmd('ProskillAutomaton!')")
    local words = dot(child)
    expect.contains(words, 'uav_mission')
    expect.contains(words, 'takeoff')
    expect.contains(child:lua("return vim.api.nvim_buf_get_name(0)"), 'proskill://automaton/calls.dot')
  end },

  { 'a picture can be had as DOT, by its name', function(child)
    drone(child)
    child:lua("vim.cmd('ProskillAutomaton! battery')")
    expect.contains(dot(child), 'digraph')
    expect.contains(dot(child), 'Critical')
    expect.equal(child:lua("return vim.bo.modifiable"), false)
    expect.equal(child:lua("return require('proskill.picture').names('bat')"), {})
  end },

  { 'names are completed', function(child)
    drone(child)
    expect.equal(child:lua("return vim.fn.getcompletion('ProskillAutomaton take', 'cmdline')"), { 'takeoff' })
  end },

  { 'the picture is of the text as it is, saved or not', function(child)
    drone(child)
    child:at('(Good| Low Critical)')
    child:keys('a Charging<Esc>')
    child:wait('return vim.bo.modified')
    child:lua("vim.cmd('ProskillAutomaton! battery')")
    expect.contains(dot(child), 'Charging')
  end },

  { 'a name that nothing has is said', function(child)
    drone(child)
    child:lua("vim.cmd('ProskillAutomaton nobody')")
    child:wait('return #told > 0')
    expect.contains(child:lua('return told[1]'), 'nobody')
    expect.equal(child:lua('return viewed == nil'), true)
  end },

  { 'in another text it says that this is no program', function(child)
    drone(child)
    child:lua("show = require('proskill.picture').show; vim.cmd('enew'); show('', false)")
    child:wait('return #told > 0')
    expect.contains(child:lua('return told[1]'), 'not a ProSkill program')
  end },
}
