import { equal, expect } from './expect.mjs';

export const scenarios = {
  async untrusted({ editor, server }) {
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays('syntax and static checks', 60_000);
    await editor.goTo(29, 15);
    await editor.type('Nothing');
    await editor.squiggles().first().waitFor();
    equal('programs that run', server.servers().map(({ args }) => args[0]), ['lsp']);
    await editor.press('Control+z');
    await editor.squiggles().first().waitFor({ state: 'detached' });
  },

  async trusted({ editor, page, server }) {
    const before = server.servers().map(({ pid }) => pid);
    await editor.command('Workspaces: Manage Workspace Trust');
    await page.locator('.workspace-trust-editor .monaco-button', { hasText: /^Trust$/ }).first().click();
    await expect('the server started again, with trust', () => {
      const now = server.servers().map(({ pid }) => pid);
      return now.length === 1 && !before.includes(now[0]);
    });
  },
};
