import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { failing } from './verification.mjs';

const kDrone = 'drone/drone.proskill';
const lineOf = (root, path, text) =>
  readFileSync(join(root, path), 'utf8').split('\n').findIndex((line) => line.includes(text)) + 1;

/** The line at which the debugger has stopped, from the gutter. */
const stopped = (page) => page.evaluate(() => {
  const mark = document.querySelector('.codicon-debug-stackframe, .codicon-debug-stackframe-focused');
  const row = mark?.closest('.glyph-margin-widgets') ? mark : mark?.parentElement;
  if (!row) return undefined;
  const top = row.getBoundingClientRect().top;
  const number = [...document.querySelectorAll('.margin-view-overlays .line-numbers')]
    .find((it) => Math.abs(it.getBoundingClientRect().top - top) < 4);
  return number && Number(number.textContent);
});

async function nextStop(page, before, key) {
  await page.keyboard.press(key);
  return expect(`another line than ${before}`, async () => {
    const line = await stopped(page);
    return line && line !== before ? line : undefined;
  });
}

export const scenarios = {
  /** Forwards, and back to the same line. */
  async debugger({ editor, page }) {
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays(/\d+ bad, \d+ warnings?/);
    await editor.command('ProSkill: Replay Trace in the Debugger');
    await editor.answer(failing);
    await page.locator('.debug-toolbar').waitFor({ timeout: 15_000 });
    const first = await expect('a line to stop at', () => stopped(page), 60_000);
    const lines = [first];
    for (let i = 0; i < 4; ++i) lines.push(await nextStop(page, lines.at(-1), 'F10'));
    await editor.picture('debugger-stepped');
    for (let i = lines.length - 2; i >= 0; --i) {
      await page.locator('.debug-toolbar .codicon-debug-step-back').click();
      await expect(`line ${lines[i]} again`, async () => (await stopped(page)) === lines[i]);
    }
    equal('back at the start', await stopped(page), first);
    await editor.press('Shift+F5');
    await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
  },

  /** Run to a breakpoint on a line, and to the end. */
  async breakpoint({ editor, page, root }) {
    const line = lineOf(root, kDrone, '(takeoff height');
    await editor.openFile(kDrone);
    await editor.goTo(line);
    await editor.statusSays(/\d+ bad, \d+ warnings?/);
    await editor.press('F9');
    await page.locator('.codicon-debug-breakpoint, .codicon-debug-breakpoint-unverified').first().waitFor();
    await editor.command('ProSkill: Replay Trace in the Debugger');
    await editor.answer(failing);
    await page.locator('.debug-toolbar').waitFor();
    await expect('the first line', () => stopped(page));
    await editor.press('F5');
    await expect(`line ${line}`, async () => (await stopped(page)) === line);
    const stack = page.locator('.debug-call-stack .monaco-list-row');
    await stack.filter({ hasText: 'takeoff' }).first().waitFor();
    await page.locator('.debug-variables .monaco-list-row', { hasText: /^localization_status/ }).first().waitFor();
    await editor.picture('breakpoint-met');
    await editor.press('Shift+F5');
    await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
    await editor.press('Control+1', 'F9');
    await page.locator('.glyph-margin-widgets .codicon-debug-breakpoint').first().waitFor({ state: 'detached' });
  },

  /** F5 without a configuration simulates: the user chooses a step, undoes it, and chooses another. */
  async simulation({ editor, page }) {
    await editor.closeAll();
    await editor.openFile('lift/lift.proskill');
    await editor.press('F5');
    await page.locator('.debug-toolbar').waitFor();
    await expect('the first line', () => stopped(page), 30_000);
    const values = page.locator('.debug-variables .monaco-list-row');
    for (const [step, after, before] of [['call_from_2 occurs', /^wanted\s*=\s*2/, /^wanted\s*=\s*1/], ['key_turned occurs', /^mode\s*=\s*Off/]]) {
      await editor.command('Debug: Step Into Target');
      const row = editor.quickInput().locator(`.monaco-list-row[aria-label^="${step}"]`);
      await row.waitFor();
      if (!before) await editor.picture('simulation-steps');
      await row.click();
      await values.filter({ hasText: after }).first().waitFor();
      if (before) {
        await page.locator('.debug-toolbar .codicon-debug-step-back').click();
        await values.filter({ hasText: before }).first().waitFor();
      }
    }
    await editor.picture('simulation-stepped');
    await editor.press('Shift+F5');
    await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
    await editor.closeAll();
  },
};
