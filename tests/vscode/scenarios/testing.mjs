// The Testing view over time: outdated results, cancelled runs, live results.
import { copyFileSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { expand, row } from './verification.mjs';

const kDrone = 'drone/drone.proskill';
const kSettings = '.vscode/settings.json';
const mission = (page) => row(page, 'takes at least').first();

/** Two blinks of at most two seconds each. */
const kBlink = `(defskill blink
  :time_interval [1,2]
  :action (blink)
  :success blinked)

(defskill blinking
  :time_interval [0,9]
  :success done
  :body ((blink) (blink) (success done)))
`;

async function writeSettings({ editor, page }, text) {
  await editor.openFile(kSettings);
  await editor.press('Control+a');
  await editor.press('Delete');
  await page.keyboard.insertText(text);
}

const undone = ({ editor, page }) => expect('the text as it was', async () => {
  await editor.press('Control+z');
  return !(await page.locator('.tab.active.dirty').count());
});

export const scenarios = {
  /** An invalid value of a setting is marked; a valid one takes effect when it is saved. */
  async settings(world) {
    const { editor, page } = world;
    await writeSettings(world, '{"proskill.verify.live": "never", "proskill.verify.seconds": 2}');
    await editor.squiggles('warning').first().waitFor();
    await editor.command('Go to Next Problem (Error, Warning, Info)');
    await page.locator('.marker-widget', { hasText: 'Incorrect type. Expected "boolean"' }).first().waitFor();
    await editor.picture('settings-wrong');
    await editor.press('Escape');
    await writeSettings(world, '{"proskill.verify.live": false}');
    await editor.squiggles('warning').first().waitFor({ state: 'detached' });
    await editor.save();
    equal('the settings', readFileSync(join(world.root, kSettings), 'utf8'), '{"proskill.verify.live": false}');
  },

  /** The text changes without a verification: all results are shown as outdated. */
  async outdated(world) {
    const { editor, page } = world;
    await editor.openFile(kDrone);
    await editor.command('ProSkill: Verify the Program');
    await editor.statusSays(/\d+ bad, \d+ warnings?$/);
    await editor.command('Notifications: Clear All Notifications');
    await editor.command('Testing: Focus on Test Explorer View');
    await mission(page).locator('.computed-state:not(.retired)').waitFor();
    await editor.press('Control+1');
    await editor.goTo(160);
    await editor.type('; ');
    await editor.statusSays('(outdated)');
    await mission(page).locator('.computed-state.retired').waitFor();
    await page.locator('.codelens-decoration', { hasText: /bad.*\(outdated\)/ }).first().waitFor();
    await editor.picture('outdated-all');
    await undone(world);
  },

  /** Marks are beside definitions; on demand, statements have their own. */
  async statements({ editor, page, server }) {
    await editor.openFile(kDrone);
    // an earlier attempt may have left them
    if (server.userSettings()['proskill.testing.statements']) await editor.command('ProSkill: Show or Hide Marks of Statements');
    await editor.goTo(160);
    const marks = page.locator('.monaco-editor[data-uri$="drone.proskill"] .testing-run-glyph');
    const lines = () => marks.evaluateAll((all) => all.map((it) => Math.round(it.getBoundingClientRect().top)).sort((a, b) => a - b));
    await marks.first().waitFor();
    const before = await lines();
    await editor.command('ProSkill: Show or Hide Marks of Statements');
    await expect('a mark beside each statement', async () => (await lines()).length > before.length + 3);
    await page.locator('.monaco-editor[data-uri$="drone.proskill"] .codicon-testing-passed-icon').nth(3).waitFor();
    await editor.picture('statements-marked');
    await marks.last().click({ button: 'right' });
    const marked = (await lines()).length;
    await editor.choose('Show or Hide Marks of Statements');
    await expect('the marks of definitions alone', async () => (await lines()).length < marked - 3);
  },

  /** A long run is cancelled, and nothing remains of it. */
  async cancel({ editor, page, server, root, tree }) {
    const path = join(root, 'lift/slow.proskill');
    copyFileSync(join(tree, 'bench/missions/warehouse_fleet.proskill'), path); // takes more than a minute
    await editor.openFile('lift/slow.proskill');
    // the file has nothing to run until the editor knows its properties
    await page.locator('.monaco-editor[data-uri$="slow.proskill"] .testing-run-glyph').first().waitFor();
    await editor.command('Test: Run Tests in Current File');
    await editor.statusSays(/verifying, \d+ of \d+ decided/);
    await expect('one process that verifies', () => server.workers() === 1);
    await editor.picture('cancel-running');
    await editor.press('Control+;', 'Control+x');
    await expect('that nothing verifies', () => server.workers() === 0);
    await page.locator('.test-explorer .codicon-testing-loading-icon').first().waitFor({ state: 'detached' });
    await editor.command('View: Close Editor');
    rmSync(path);
  },

  /** With live verification again, verdicts follow the text without a click. */
  async continuous(world) {
    const { editor, page, root } = world;
    await writeSettings(world, '{}');
    await editor.save();
    const path = join(root, 'lift/blink.proskill');
    writeFileSync(path, kBlink);
    await editor.openFile('lift/blink.proskill');
    await editor.statusSays(/\d+ of \d+ good/, 60_000);
    await editor.command('Testing: Focus on Test Explorer View');
    await expand(page, 'blink.proskill (');
    await expand(page, 'blinking (');
    const verdict = (icon) => row(page, 'takes at most').first().locator(`.computed-state.codicon-testing-${icon}-icon:not(.retired)`).waitFor();
    await row(page, 'takes at most 9 s').first().waitFor();
    await verdict('passed');
    await editor.press('Control+1');
    await editor.goTo(kBlink.split('\n').findIndex((line) => line.includes('[0,9]')) + 1, 22);
    await editor.press('Backspace');
    await editor.type('3');
    await verdict('failed');
    await row(page, 'takes at most 3 s').first().waitFor();
    await editor.picture('continuous-failed');
    await undone(world);
    await verdict('passed');
    await editor.command('View: Close Editor');
    rmSync(path);
    await editor.openFile(kDrone);
    await editor.statusSays(/\d+ bad, \d+ warnings?$/, 60_000);
  },
};
