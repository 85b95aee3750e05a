-- :ProskillImport.
local expect = require('expect')

local function gripper(child)
  child:lua([[
    told = {}
    vim.notify = function(text) table.insert(told, text) end
    require('proskill.config').set({ cmd = { vim.env.PROSKILL_PROGRAM }, parser = vim.env.PROSKILL_PARSER })
  ]])
  return child:copy('gripper')
end

return {
  { 'a component becomes a program beside it, which is only replaced if this is asked for', function(child)
    local folder = gripper(child)
    child:lua(("vim.fn.delete('%s/gripper.proskill')"):format(folder))
    child:lua(("vim.cmd('edit %s/gripper.gen')"):format(folder))
    child:lua("vim.cmd('ProskillImport')")
    expect.contains(child:lua('return told[1]'), 'verdicts are exact')
    expect.contains(child:lua('return vim.api.nvim_buf_get_name(0)'), 'gripper.proskill')
    expect.contains(child:lua("return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\\n')"), ':time_interval [3,8]')
    child:lua(("vim.cmd('ProskillImport %s/gripper.gen')"):format(folder))
    expect.contains(child:lua('return told[2]'), 'ProskillImport! replaces it')
    child:lua("vim.fn.append(0, '; mine')")
    child:lua("vim.cmd('write')")
    child:lua(("vim.cmd('ProskillImport! %s/gripper.gen')"):format(folder))
    expect.contains(child:lua('return told[3]'), 'verdicts are exact')
    expect.contains(child:lua("return vim.fn.getline(1) == '; mine' and 'kept' or 'replaced'"), 'replaced')
  end },

  { 'errors come into the quickfix list, and nothing is written', function(child)
    local file = gripper(child) .. '/wrong.gen'
    child:lua(("vim.fn.writefile({ 'component c {', '  activity a() { interrupts b; };', '};' }, '%s')"):format(file))
    child:lua(("vim.cmd('ProskillImport %s')"):format(file))
    expect.contains(child:lua('return told[1]'), 'not a service of this component')
    expect.contains(child:lua('return vim.fn.getqflist()[1].text'), 'not a service of this component')
    expect.contains(child:lua('return tostring(vim.fn.getqflist()[1].lnum)'), '2')
    child:lua("vim.cmd('ProskillImport robot.urdf')")
    expect.contains(child:lua('return told[2]'), 'not a behavior tree')
  end },
}
