import { equal, expect } from '../expect.mjs';

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

  /** The user verifies by a mark beside the text and grants trust; the verification then runs. */
  async trusted({ editor, page, server }) {
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays(/syntax and static checks|\d+ bad/, 60_000);
    const before = server.servers().map(({ pid }) => pid);
    await page.locator('.monaco-editor[data-uri$="drone.proskill"] .testing-run-glyph').first().click();
    // on the second attempt the workspace is already trusted
    const isAsked = (await editor.status().filter({ hasText: 'syntax and static checks' }).count()) > 0;
    if (isAsked) await page.locator('.monaco-dialog-box .monaco-button', { hasText: /^Trust/ }).first().click();
    if (isAsked) await expect('the server started again, with trust', () => {
      const now = server.servers().map(({ pid }) => pid);
      return now.length === 1 && !before.includes(now[0]);
    });
    await editor.statusSays(/\d+ bad, \d+ warnings?/, 60_000);
    await editor.command('Testing: Focus on Test Explorer View');
    await page.locator('.test-explorer .codicon-testing-passed-icon, .test-explorer .codicon-testing-failed-icon').first().waitFor();
    await editor.picture('trusted-verified');
    equal('properties that could not be verified', await page.locator('.test-explorer .codicon-testing-error-icon').count(), 0);
    await editor.press('Control+1');
  },
};
