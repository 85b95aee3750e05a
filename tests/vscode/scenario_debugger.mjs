import { equal, expect } from './expect.mjs';
import { failing } from './scenario_verification.mjs';

/** The line at which the debugger has stopped, as the gutter marks it. */
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
  /** Forward, and back to the same line. */
  async debugger({ editor, page }) {
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays(/\d+ of \d+ bad/);
    await editor.command('ProSkill: Replay Trace in the Debugger');
    await editor.quickInput().locator('input.input').fill(failing);
    await editor.press('Enter');
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
};
