import { readFileSync } from 'node:fs';
import { join } from 'node:path';
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

  /** It is followed to its end: the program is written beside it, and each of its buttons works on that program. */
  async walkthrough_followed({ editor, page, tree }) {
    const [, program] = /```proskill\n([^]*?)```/.exec(readFileSync(join(tree, 'vscode-extension/walkthrough/write.md'), 'utf8'));
    await editor.closeAll();
    await editor.command('Welcome: Open Walkthrough...');
    await editor.answer('Get started with ProSkill');
    const steps = page.locator('.gettingStarted .getting-started-step');
    const open = async (title) => {
      await expect(`"${title}", unfolded`, async () => {
        await steps.filter({ hasText: title }).click({ timeout: 5000 });
        return (await steps.filter({ hasText: title }).and(page.locator('.expanded')).count()) > 0;
      });
    };
    const press = (title) => steps.and(page.locator('.expanded')).locator('a, .monaco-button').filter({ hasText: title }).first().click();
    const text = page.locator('.monaco-editor[data-uri^="untitled:"]');
    await open('Write a program');
    await press('New program');
    await text.waitFor();
    const shown = page.locator('iframe.webview.ready').last().contentFrame().frameLocator('iframe#active-frame').locator('pre', { hasText: 'defproperty drives_shut' }).first();
    await shown.waitFor();
    equal('lines of the program to type that are cut off', await shown.evaluate((it) => it.scrollWidth > it.clientWidth), false);
    for (const line of program.trim().split('\n')) {
      await editor.type(line.trim());
      await editor.press('Enter'); // the editor indents
    }
    await editor.statusSays(/1 bad/, 60_000);
    await open('See the automaton');
    await press('Show automaton');
    const picture = await editor.panel('.automaton-view');
    await picture.locator('.stage g.node').first().waitFor();
    await open('Verify it');
    await press(/^Verify$/);
    await page.locator('.notification-toast', { hasText: '1 bad' }).first().waitFor();
    await open('Click through what goes wrong');
    await press('Open a trace');
    await editor.answer('drives_shut');
    const trace = await editor.panel('.trace-view');
    await trace.locator('#step-0.current').waitFor();
    await editor.picture('walkthrough-followed');
    equal('the text, beside the walkthrough and the panel', [await text.isVisible(), await steps.first().isVisible()], [true, true]);
    await open('Fix it');
    equal('messages', await page.locator('.notification-toast', { hasText: 'first' }).count(), 0);
    await text.locator('.view-line', { hasText: /^\s*\(drive\)/ }).click();
    await editor.press('Home');
    await editor.type('(set (door Shut)) ');
    await trace.locator('.badge.holds:visible').waitFor();
    await editor.statusSays(/of \d+ good/);
    await editor.press('Control+a', 'Delete');
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
