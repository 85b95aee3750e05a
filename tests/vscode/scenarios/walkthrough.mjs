import { equal, expect } from '../expect.mjs';

export const scenarios = {
  /** Opened from the list of walkthroughs; every step shows its text or its picture. */
  async walkthrough({ editor, page }) {
    await editor.command('Welcome: Open Walkthrough...');
    await editor.quickInput().locator('input.input').fill('Get started with ProSkill');
    await editor.quickInput().locator('.monaco-list-row[aria-label*="Get started with ProSkill"]').click();
    const steps = page.locator('.gettingStarted .getting-started-step');
    await expect('its steps', async () => (await steps.count()) === 5);
    for (const title of ['See the automaton', 'Verify it', 'Click through what goes wrong']) {
      const step = steps.filter({ hasText: title });
      await step.click();
      await expect(`the picture of "${title}"`, () => page.evaluate(() =>
        [...document.querySelectorAll('.gettingStarted .getting-started-media img')].some((it) => it.naturalWidth > 600)));
      await editor.picture(`walkthrough-${title.split(' ')[0].toLowerCase()}`);
    }
    for (const [title, words] of [['Write a program', 'defproperty drives_shut'], ['Fix it', '(set (door Shut))']]) {
      await steps.filter({ hasText: title }).click();
      const text = page.locator('iframe.webview.ready').last().contentFrame().frameLocator('iframe#active-frame');
      await text.locator('pre', { hasText: words }).first().waitFor();
      await editor.picture(`walkthrough-${title.split(' ')[0].toLowerCase()}`);
    }
    equal('marks of code that are shown as they are', await steps.filter({ hasText: '`' }).count(), 0);
    await editor.closeAll();
  },

  /** A click on the status bar lists actions; each is an existing command. */
  async menu({ editor, page }) {
    await editor.status().click();
    const rows = editor.quickInput().locator('.monaco-list-row');
    await rows.filter({ hasText: 'Begin a new program' }).waitFor();
    await editor.picture('menu-open');
    await rows.filter({ hasText: 'Begin a new program' }).click();
    await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
    await editor.type('(defsv a :states (X Y) :init Z)');
    await editor.squiggles().first().waitFor();
    await editor.emptyText();
    await editor.closeAll();
  },
};
