// While a text has errors, panels show what was computed before. The places of their steps and nodes go with the edits.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from '../expect.mjs';
import { kLamp } from './folders.mjs';

const kFolder = 'older ä #1'; // URIs escape it
const kFile = `${kFolder}/lamp.proskill`;
const kUriEnd = `/${encodeURIComponent(kFolder)}/lamp.proskill`;
const kProperty = 'dark';
const kText = `${kLamp}
(defskill mission
  :success done
  :body
    ((light)
     (success done)))

(defproperty ${kProperty} (always (lamp Off)))
`;
const kCall = '(light)';
const kLines = kText.split('\n');
/** The first lines of the text while it has an error; the editor would continue a comment. */
const kTyped = '(defskill half\n\n\n';
const kInserted = kTyped.split('\n').length - 1;

const editorOf = (page) => page.locator(`.monaco-editor[data-uri$="${kUriEnd}"]`);
const lineOf = async (frame) => Number(/:(\d+)$/.exec(await frame.locator('.step.current .place').textContent())[1]);

async function begin({ editor, page, root }) {
  mkdirSync(join(root, kFolder), { recursive: true });
  writeFileSync(join(root, kFile), kText);
  await editor.closeAll();
  await editor.pick('Control+p', kFile, 'lamp.proskill', ' ');
  await editorOf(page).locator('.view-line').first().waitFor();
  await editor.statusSays(/1 bad/, 60_000);
}

/** Inserts lines above everything, with an error. */
async function breakText({ editor, page }) {
  await editor.press('Control+1');
  await editor.goTo(1);
  await page.keyboard.insertText(kTyped);
  await editor.statusSays(/errors/);
}

const caretIn = ({ page }, line) => expect(`the caret in line ${line}`, async () =>
  Number(await editorOf(page).locator('.active-line-number').first().textContent()) === line, 20_000);

async function end({ editor, root }) {
  await editor.press('Control+1');
  await editor.command('File: Revert File');
  await editor.closeAll();
  rmSync(join(root, kFolder), { recursive: true });
}

export const scenarios = {
  /** The trace says that it is older, and marks each step where its text is now, if it is still there. */
  async older_trace(world) {
    const { editor, page } = world;
    await begin(world);
    const frame = await editor.openTrace(kProperty);
    await breakText(world);
    await frame.locator('.stale-mark').waitFor();
    await editor.picture('older_trace-errors');
    const marked = (line) => expect(`a mark in line ${line}`, async () => (await editor.markedLines(kUriEnd))[0] === line, 20_000);
    await new Promise((resolve) => setTimeout(resolve, 2200)); // the editor does not follow within two seconds after an edit
    await frame.locator('.steps').press('Home');
    for (let step = 0; step < 4; ++step) {
      await frame.locator(`#step-${step}.current`).waitFor();
      await marked((await lineOf(frame)) + kInserted);
      await frame.locator('.steps').press('ArrowDown');
    }
    await editor.picture('older_trace-step');
    await frame.locator('.steps').press('Home');
    await frame.locator('.steps').press('ArrowDown');
    const call = kLines.findIndex((line) => line.includes(`(${kCall}`)) + 1 + kInserted;
    await marked(call);
    await frame.locator('.steps').press('Enter');
    await expect('the caret at the step', async () => (await editor.caret()).startsWith(`Ln ${call}, `));
    await editor.openFile('drone/drone.proskill');
    await page.locator('.tab').filter({ hasText: 'lamp.proskill' }).first().click();
    await marked(call);
    await editor.goTo(call, 6 + kCall.length);
    await editor.press('Control+Shift+K');
    await expect('no mark where the text was', async () => (await editor.markedLines(kUriEnd)).length === 0);
    await editor.press('Control+z');
    await end(world);
  },

  /** A click in the last valid picture goes to where the text is now. */
  async older_picture(world) {
    const { editor, page } = world;
    await begin(world);
    const line = kLines.findIndex((it) => it.includes(`(${kCall}`)) + 1;
    await editor.goTo(line, 7);
    await editor.command('ProSkill: Show Automaton');
    const frame = await editor.panel('.automaton-view');
    await frame.locator('.stage[data-picture="body mission"] g.node', { hasText: 'light' }).waitFor();
    await breakText(world);
    await frame.locator('.automaton-view.stale').waitFor();
    await frame.locator('g.node', { hasText: 'light' }).first().click();
    await caretIn(world, line + kInserted);
    await editor.picture('older_picture');
    await end(world);
  },

  /** The last valid run stays, too: a step that is entered leads to where its text is now. */
  async older_run(world) {
    const { editor } = world;
    await begin(world);
    await editor.command('ProSkill: Simulate: Choose What Happens Next');
    const frame = await editor.panel('.simulation-view');
    for (const words of ['starts', 'calls light']) {
      const before = await frame.locator('.row.step').count();
      await frame.locator('.choice', { hasText: words }).first().click();
      await frame.locator('.row.step').nth(before).waitFor();
    }
    await breakText(world);
    await frame.locator('.notice.stale', { hasText: 'This is the run as it was before' }).waitFor();
    await frame.locator('.row.step').nth(1).dblclick();
    await caretIn(world, kLines.findIndex((it) => it.includes(`(${kCall}`)) + 1 + kInserted);
    await editor.picture('older_run');
    await end(world);
  },
};
