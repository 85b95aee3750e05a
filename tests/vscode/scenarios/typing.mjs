// Typing while a trace is open: the text, the caret and the tabs are the user's.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { expand, failing, row } from './verification.mjs';

const kFile = 'lift/bug.proskill';
const kProperty = 'doors_closed_when_moving';
const kComment = '; typed while it is verified again and again';
const kRepair = ['(^ (cabin Idle) :effects (cabin Doors)) ', ' (set (cabin Idle))'];

const current = (frame) => frame.locator('.step.current .number').textContent();
const lineOf = (root, text) => readFileSync(join(root, kFile), 'utf8').split('\n').findIndex((line) => line.includes(text)) + 1;

export const scenarios = {
  /** Each word is verified before the next one is typed, while a trace with steps in another file is open. */
  async typing({ editor, page, root }) {
    await editor.closeAll(); // a panel of another scenario would be taken for the new one
    await editor.openFile(kFile);
    await editor.statusSays(/\d+ bad(?!.*outdated)/, 60_000);
    const frame = await editor.openTrace(kProperty);
    await frame.locator('.steps').press('ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    await editor.openFile(kFile);
    await editor.goTo(2);
    for (const word of kComment.split(/(?<= )/)) {
      for (const key of word) {
        await editor.type(key);
        equal('the keyboard', await page.evaluate(() => !!document.activeElement?.closest('.monaco-editor[data-uri$="bug.proskill"]')), true);
      }
      await editor.statusSays(/outdated|verifying/, 2_000).catch(() => undefined); // it may be over before it is seen
      await editor.statusSays(/\d+ bad(?!.*outdated)/);
    }
    equal('the caret', await editor.caret(), `Ln 2, Col ${kComment.length + 1}`);
    equal('the tab', await editor.tab('bug.proskill').count() > 0, true);
    equal('the step', await current(frame), '2');
    await editor.save();
    equal('the text', readFileSync(join(root, kFile), 'utf8').split('\n')[1], kComment);
  },

  /** A step that arrives when the user is in a text again does not put another text in front of it. From the editor, steps are followed. */
  async late_step({ editor, page }) {
    const frame = await editor.panel('.trace-view');
    await editor.openFile('lift/lift.proskill');
    await editor.openFile(kFile);
    await editor.goTo(3);
    await new Promise((resolve) => setTimeout(resolve, 2200)); // while the user types nothing is followed anyway
    await frame.locator('.steps').dispatchEvent('keydown', { key: 'ArrowUp' }); // which gives the panel no focus
    await frame.locator('#step-0.current').waitFor();
    await new Promise((resolve) => setTimeout(resolve, 1000)); // a text that opened would do so by then
    equal('the tab', await editor.tab('bug.proskill').count() > 0, true);
    await editor.type(' ');
    await editor.press('Backspace');
    await expect('the caret where it was', async () => (await editor.caret()) === 'Ln 3, Col 1', 5000);
    await new Promise((resolve) => setTimeout(resolve, 2200));
    await editor.press('Alt+Shift+ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    await expect('the mark of the step in its text', async () => (await editor.markedLines('lift/building.proskill')).length > 0);
    await editor.openFile(kFile);
  },

  /** The bug is fixed in the text: the panel shows the verdict, and no step is marked any more. After undo, the step is marked again. */
  async repaired({ editor, page, root }) {
    const frame = await editor.panel('.trace-view');
    const line = lineOf(root, '(open_doors)');
    await editor.openFile(kFile);
    await editor.goTo(line, 9);
    await page.keyboard.insertText(kRepair[0]);
    await editor.goTo(line, 9 + kRepair[0].length + '(open_doors)'.length);
    await page.keyboard.insertText(kRepair[1]);
    await frame.locator('.badge.holds:visible').waitFor();
    equal('steps', await frame.locator('.step:visible').count(), 0);
    await editor.picture('repaired-holds');
    await expect('the text as it was', async () => {
      await editor.press('Control+z');
      return !(await page.locator('.tab.active.dirty').count());
    });
    await frame.locator('#step-1.current').waitFor();
    await editor.closeAll();
  },

  /**
   * Programs that are not open are listed. After a reload of the window, results of unchanged programs, the trace with its step, the picture, and
   * the caret are restored.
   */
  async reloaded({ editor, page }) {
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays(/\d+ bad, \d+ warnings?$/, 60_000);
    await editor.goTo(161, 3);
    const before = await editor.openTrace(failing);
    await before.locator('.steps').press('ArrowDown');
    await before.locator('#step-1.current').waitFor();
    await editor.command('Testing: Focus on Test Explorer View');
    // It is not open: its properties are requested when the item is expanded, and it can be run.
    await expand(page, 'dock.proskill (');
    await row(page, 'recharge (').first().waitFor();
    await row(page, 'dock.proskill (').first().hover();
    await row(page, 'dock.proskill (').first().locator('.codicon-testing-run-icon').first().click();
    await row(page, 'dock.proskill (').first().locator('.computed-state.codicon-testing-failed-icon').waitFor();
    await editor.picture('reloaded-before');
    await editor.command('Developer: Reload Window');
    await page.locator('.monaco-workbench .statusbar-item').first().waitFor({ timeout: 60_000 });
    await page.locator('.monaco-editor[data-uri$="drone/drone.proskill"] .view-line').first().waitFor();
    const after = await editor.panel('.trace-view');
    await after.locator('#step-1.current').waitFor();
    await editor.command('Testing: Focus on Test Explorer View');
    await row(page, 'dock.proskill (').first().locator('.computed-state.codicon-testing-failed-icon').waitFor();
    await editor.picture('reloaded-after');
    await editor.press('Control+1');
    equal('the caret', await editor.caret(), 'Ln 161, Col 3');
    await editor.closeAll();
  },

  /** Two programs side by side, and the trace of one of them: after a reload both have verdicts, and the trace its step. */
  async reloaded_two({ editor, page }) {
    await editor.closeAll();
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays(/\d+ bad, \d+ warnings?$/, 60_000);
    const before = await editor.openTrace(failing);
    await before.locator('.steps').press('ArrowDown');
    await before.locator('#step-1.current').waitFor();
    await editor.press('Control+1');
    await editor.command('View: Split Editor Right');
    await editor.openFile('lift/timed.proskill');
    await editor.statusSays(/\d+ bad/, 60_000);
    await editor.command('Developer: Reload Window');
    await page.locator('.monaco-workbench .statusbar-item').first().waitFor({ timeout: 60_000 });
    const after = await editor.panel('.trace-view');
    await after.locator('#step-1.current').waitFor({ timeout: 60_000 });
    for (const file of ['drone/drone.proskill', 'lift/timed.proskill']) {
      await editor.openFile(file);
      await editor.statusSays(/\d+ bad(?!.*outdated)/, 60_000);
    }
    await editor.closeAll();
  },
};
