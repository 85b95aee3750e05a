// One program in several places: several carets, two editors side by side, two windows, and cells of a notebook.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { kLamp, trust } from './folders.mjs';

const kFolder = 'copies';
const kFile = `${kFolder}/lamp.proskill`;
const kNotebook = `${kFolder}/lamp.ipynb`;
const kProperty = 'dark';
/** A hint beside the mission. */
const kDuration = /\s*1 to 2 s\s*$/;
const kWords = ['typed ', 'at ', 'three ', 'carets'];

const kMission = `(defskill mission
  :success done
  :body
    ((light)
     (success done)))

(defproperty ${kProperty} (always (lamp Off)))
`;
const kText = `; one\n; two\n; three\n${kLamp}\n${kMission}`;

const cell = (source, language = 'proskill') => ({
  cell_type: 'code', source, outputs: [], execution_count: null, metadata: { vscode: { languageId: language } },
});
const kCells = { nbformat: 4, nbformat_minor: 5, metadata: {}, cells: [cell(kLamp), cell('print("no program")', 'python'), cell(kMission)] };

const currentStep = (frame) => frame.locator('.step.current .number').textContent();
const editors = (page) => page.locator(`.monaco-editor[data-uri$="${kFile}"]`);

async function begin({ editor, root }) {
  mkdirSync(join(root, kFolder), { recursive: true });
  writeFileSync(join(root, kFile), kText);
  await editor.closeAll();
  await editor.openFile(kFile);
  await editor.statusSays(/1 bad/, 60_000);
}

async function end({ editor, root }) {
  await editor.closeAll();
  rmSync(join(root, kFolder), { recursive: true });
}

/** The trace at its second step. */
async function openTrace(editor) {
  const frame = await editor.openTrace(kProperty);
  await frame.locator('.steps').press('ArrowDown');
  await frame.locator('#step-1.current').waitFor();
  return frame;
}

/** Waits until a verification of the text as it is now has ended. */
async function verifiedAgain(editor) {
  await editor.statusSays(/outdated|verifying/, 2_000).catch(() => undefined); // it may be over before it is seen
  await editor.statusSays(/1 bad(?!.*outdated)/);
}

/** Replaces the line of the property. */
async function writeProperty(editor, always) {
  await editor.goTo(kText.split('\n').findIndex((line) => line.includes(kProperty)) + 1);
  await editor.press('End', 'Shift+Home');
  await editor.page.keyboard.insertText(`(defproperty ${kProperty} (always ${always}))`);
}

/** The numbers of the program's cells with a mark of a step, from 0. */
const markedCells = (page) => page.evaluate(() => [...document.querySelectorAll('.cell .monaco-editor[data-uri]')].filter((it) => /defs/.test(it.textContent))
  .flatMap((it, at) => ([...it.querySelectorAll('.view-overlays [class*="ced-"]')].some((mark) => getComputedStyle(mark).borderTopStyle === 'solid') ? [at] : [])));

/** The text of the cell with the keyboard. */
const focusedCell = (page) => page.evaluate((hint) => [...(document.activeElement?.closest('.cell .monaco-editor[data-uri]')?.querySelectorAll('.view-line') ?? [])]
  .sort((a, b) => parseFloat(a.style.top) - parseFloat(b.style.top)).map((it) => it.textContent.replaceAll('\u00a0', ' ').replace(new RegExp(hint), '')).join('\n').trimEnd(), kDuration.source);

export const scenarios = {
  /** Text is typed at three carets while it is verified, with a trace open: carets, text and step stay. */
  async many_carets(world) {
    const { editor, page, root } = world;
    await begin(world);
    const frame = await openTrace(editor);
    await editor.openFile(kFile);
    await editor.goTo(1);
    await editor.press('End');
    for (const line of ['; two', '; three']) await editors(page).locator('.view-line', { hasText: line }).click({ modifiers: ['Alt'], position: { x: 400, y: 8 } });
    await editor.type(' ');
    for (const word of kWords) {
      await editor.type(word);
      await verifiedAgain(editor);
      equal('the carets', await editor.caret(), '3 selections');
    }
    equal('the step', await currentStep(frame), '2');
    await editor.picture('many_carets');
    await editor.press('Escape');
    await editor.save();
    equal('the text', readFileSync(join(root, kFile), 'utf8'), kText.replace(/^; .*$/gm, (line) => `${line} ${kWords.join('')}`));
    await end(world);
  },

  /** The program is open in two editors side by side: both show marks, and typing in one scrolls neither. */
  async split(world) {
    const { editor, page, root } = world;
    await begin(world);
    await editor.command('View: Split Editor Down');
    await expect('two editors', async () => (await editors(page).count()) === 2);
    const frame = await openTrace(editor);
    const marks = () => editors(page).evaluateAll((all) => all.map((it) =>
      [...it.querySelectorAll('.view-overlays [class*="ced-"]')].filter((mark) => getComputedStyle(mark).borderTopStyle === 'solid').length));
    await expect('the step in both editors', async () => (await marks()).every((count) => count > 0));
    await editor.picture('split');
    await editors(page).first().locator('.view-line').first().click();
    await editor.press('Control+Home', 'End');
    const places = () => editors(page).evaluateAll((all) => all.map((it) => it.querySelector('.line-numbers')?.textContent));
    const before = await places();
    for (const word of kWords) {
      await editor.type(` ${word.trim()}`);
      await verifiedAgain(editor);
    }
    equal('the first lines', await places(), before);
    equal('the step', await currentStep(frame), '2');
    equal('the caret', await editor.caret(), `Ln 1, Col ${`; one ${kWords.join('')}`.length + 1}`);
    await editor.save();
    equal('the text', readFileSync(join(root, kFile), 'utf8'), kText.replace('; one', `; one ${kWords.join('')}`));
    await end(world);
  },

  /** Another window shows the same program. It notices what this one saves, and neither disturbs the other's trace. */
  async second_window(world) {
    const { editor, root } = world;
    await begin(world);
    const frame = await openTrace(editor);
    await world.window(root, async ({ editor: other, page }) => {
      await other.closeAll();
      await other.openFile(kFile);
      await trust(other, page);
      await other.statusSays(/1 bad/, 60_000);
      const second = await openTrace(other);
      await other.openFile(kFile);
      await writeProperty(other, '(or (lamp Off) (lamp On))');
      await second.locator('.badge.holds:visible').waitFor();
      equal('the step of the first window before it is saved', await currentStep(frame), '2');
      await other.save();
      await frame.locator('.badge.holds:visible').waitFor();
      await writeProperty(other, '(lamp Off)');
      await second.locator('#step-1.current').waitFor();
      await other.save();
      await other.picture('second_window-saved');
      await other.closeAll();
    });
    await frame.locator('#step-1.current').waitFor();
    await editor.statusSays(/1 bad(?!.*outdated)/);
    await end(world);
  },

  /** The cells of a notebook are one program, with verdicts, automata and traces. Typing in one cell moves nothing. */
  async notebook(world) {
    const { editor, page, root } = world;
    mkdirSync(join(root, kFolder), { recursive: true });
    writeFileSync(join(root, kNotebook), JSON.stringify(kCells));
    await editor.closeAll();
    await editor.pick('Control+p', kNotebook, 'lamp.ipynb', ' ');
    const property = page.locator('.cell .view-line', { hasText: '(defproperty' });
    await property.first().click();
    await editor.picture('notebook-cell');
    await editor.statusSays(/1 bad/, 60_000);
    const frame = await openTrace(editor);
    await frame.locator('.steps').press('End');
    await expect('the mark of the step in its cell', async () => (await markedCells(page))[0] === 0);
    const places = await frame.locator('.step .place').allTextContents();
    equal('places by the number of the cell', places, ['cell 3:1', 'cell 3:4', 'cell 1:2', 'cell 1:5']);
    await frame.locator('.steps').press('ArrowUp');
    await frame.locator('.steps').press('ArrowUp');
    await expect('the mark in the other cell', async () => (await markedCells(page))[0] === 1);
    await frame.locator('.steps').press('Enter');
    await expect('the keyboard in the cell', async () => (await focusedCell(page)).startsWith('(defskill mission'));
    equal('tabs of the notebook', await page.locator('.tab', { hasText: 'lamp.ipynb' }).count(), 1);
    const step = await currentStep(frame);
    await property.first().click();
    await editor.press('End', 'Enter');
    await editor.type('; typed');
    await verifiedAgain(editor);
    equal('the step', await currentStep(frame), step);
    await editor.type(' and more');
    await expect('what was typed', async () => (await focusedCell(page)).endsWith(' and more'));
    equal('the cell', await focusedCell(page), `${kMission}; typed and more`);
    await editor.picture('notebook');
    await editor.save();
    await end(world);
  },
};
