// What happens around a program on the second day: half-written text, quick steps, moved panels, renamed files, other branches.
import { copyFileSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { expand, row } from './verification.mjs';

const kFolder = 'survey';
const kMain = `${kFolder}/survey.proskill`;
const kProperty = 'never_empty';

/** A rover whose battery is empty after three drives. The steps of its trace alternate between both files. */
const kParts = `(defsv place :states (Base Crater) :init Base)
(defsv battery :init 3 :min 0 :max 6)

(defskill drive
  :input ($to place)
  :precondition (charged (>= battery 1))
  :start (battery (- battery 1))
  :time_interval [5,20]
  :action (drive $to)
  :success there (:effects (place $to))
  :failure stuck)
`;
const kText = `(include "parts.proskill")

(defskill travel
  :input ($goal place)
  :success there
  :failure lost
  :body
    ((drive to $goal)
     (if (= drive.status success)
        (success there))
     (^ 2)
     (drive to $goal)
     (if (= drive.status success)
        (success there))
     (failure lost)))

(defskill survey
  :success home
  :failure lost
  :body
    ((travel goal Crater)
     (if (/= travel.status success)
        (failure lost))
     (travel goal Base)
     (if (/= travel.status success)
        (failure lost))
     (success home)))

(defproperty ${kProperty} (always (>= battery 1)))
`;
const kLine = kText.split('\n').findIndex((line) => line.includes('(defskill survey')) + 1;

/** Notes what the status bar shows of programs. */
const watchStatus = () => {
  window.statusTexts = [];
  const note = () => window.statusTexts.push(document.querySelector('[id$="proskill.status"]').textContent);
  new MutationObserver(note).observe(document.querySelector('.statusbar').parentElement, { subtree: true, childList: true, characterData: true });
};

const program = (page, name) => row(page, `${name} (`).first();
const current = (frame) => frame.locator('.step.current').first();

/** The program in the editor, verified, with its properties in the tree. */
async function begin({ editor, page, root }) {
  mkdirSync(join(root, kFolder), { recursive: true });
  writeFileSync(join(root, kFolder, 'parts.proskill'), kParts);
  writeFileSync(join(root, kMain), kText);
  await editor.closeAll();
  await editor.openFile(kMain);
  await editor.statusSays(/1 bad/, 60_000);
  await showPrograms({ editor, page });
  await program(page, 'survey.proskill').waitFor();
}

/** Only rows in view exist, so those of other programs are collapsed. */
async function showPrograms({ editor, page }) {
  await editor.command('Testing: Focus on Test Explorer View');
  await page.locator('.test-explorer .monaco-list').first().focus();
  await editor.press('Control+ArrowLeft', 'Home');
}

/** The lines with a mark of the Testing view beside them. */
const marked = (page, file) => page.locator(`.monaco-editor[data-uri$="${file}"]`).first().evaluate((editor) => {
  const lines = new Map([...editor.querySelectorAll('.margin-view-overlays > div')]
    .map((it) => [Math.round(it.getBoundingClientRect().top), Number(it.querySelector('.line-numbers')?.textContent)]));
  return [...editor.querySelectorAll('.testing-run-glyph')].map((it) => lines.get(Math.round(it.getBoundingClientRect().top))).sort((a, b) => a - b);
});

/** The step is marked in its text, which the panel names at the right of the step. */
async function expectMarked(editor, frame) {
  await expect('the mark of the step in its text', async () => {
    const [file, line] = (await current(frame).locator('.place').textContent()).split(':');
    return (await editor.markedLines(file))[0] === Number(line);
  }, 10_000);
}

export const scenarios = {
  /** A definition is half-written: the tree stays open, and marks stay beside their definitions, and so do hints. */
  async half_written(world) {
    const { editor, page } = world;
    await begin(world);
    await expand(page, 'survey.proskill (');
    const rows = page.locator('.test-explorer .monaco-list-row');
    await row(page, `${kProperty} (`).first().waitFor();
    const mission = page.locator(`.monaco-editor[data-uri$="${kMain}"] .view-line`, { hasText: '(defskill survey' });
    await mission.filter({ hasText: /\d\ss\s*$/ }).waitFor({ timeout: 20_000 }); // how long it takes, as a hint
    const [before, marks, hinted] = [await rows.count(), await marked(page, kMain), await mission.textContent()];
    equal('a mark at the mission', marks.includes(kLine), true);
    await editor.press('Control+1');
    await editor.goTo(2);
    await editor.type('(defskill sleep ');
    await editor.press('Enter');
    await page.locator('.test-explorer', { hasText: 'the program has errors' }).waitFor();
    equal('rows, and one for the error', await rows.count(), before + 1);
    equal('the line with its hint', await mission.textContent(), hinted);
    await expect('marks that moved with their lines', async () =>
      JSON.stringify(await marked(page, kMain)) === JSON.stringify(marks.map((line) => line + 1)));
    await editor.picture('half_written-error');
    await editor.command('File: Revert File');
    await page.locator('.test-explorer', { hasText: 'the program has errors' }).waitFor({ state: 'detached' });
    await expect('marks where they were', async () => JSON.stringify(await marked(page, kMain)) === JSON.stringify(marks));
  },

  /** After an edit that changes one verdict, the counts above the tree are those of the whole program, as in the status bar. */
  async counts(world) {
    const { editor, page } = world;
    await begin(world);
    const counts = page.locator('.result-summary-container *').filter({ hasText: /^\d+\/\d+$/ }).first();
    const known = async () => (await counts.textContent()).split('/').map(Number);
    await expect('counts of many properties', async () => (await known())[1] > 20);
    const [good, all] = await known();
    equal('bad ones', all - good, 1);
    await editor.press('Control+1');
    await editor.goTo(kText.split('\n').findIndex((line) => line.includes(kProperty)) + 1, `(defproperty ${kProperty} (always (>= battery 1`.length + 1);
    await editor.press('Backspace');
    await editor.type('0');
    await editor.statusSays(/of \d+ good|warning/);
    await expect('the counts of the repaired program', async () => JSON.stringify(await known()) === JSON.stringify([all, all]));
    await editor.picture('counts-repaired');
    await editor.command('File: Revert File');
    await expect('the counts as they were', async () => JSON.stringify(await known()) === JSON.stringify([good, all]));
  },

  /** Keys that come faster than texts open: the editor ends at the step that is shown. */
  async quick_steps(world) {
    const { editor } = world;
    await begin(world);
    const frame = await world.editor.openTrace(kProperty);
    await new Promise((resolve) => setTimeout(resolve, 2200)); // the editor does not follow within two seconds after an edit
    for (let round = 0; round < 4; ++round) {
      for (let i = 0; i < 5; ++i) await editor.press('ArrowDown');
      await expectMarked(editor, frame);
    }
  },

  /** The panel fills the only group: steps do not cover it. Enter opens the text beside it. */
  async covered(world) {
    const { editor, page } = world;
    await begin(world);
    const frame = await world.editor.openTrace(kProperty);
    await editor.command('View: Move Editor into Previous Group');
    await expect('one group', async () => (await page.locator('.editor-group-container').count()) === 1);
    await frame.locator('.steps').focus();
    await editor.press('ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    await new Promise((resolve) => setTimeout(resolve, 700)); // a text that opened would do so by then
    equal('the tab in front', await page.locator('.tab.active').textContent(), 'ProSkill trace');
    await frame.locator('.steps').press('Enter');
    await expect('the text beside the panel', async () => (await page.locator('.editor-group-container').count()) === 2);
    equal('tabs in front', (await page.locator('.tab.active').allTextContents()).sort(), ['ProSkill trace', 'survey.proskill']);
    await editor.picture('covered-beside');
    await editor.closeAll();
  },

  /** The program is renamed while its trace is open: the panel stays with it, at its step. */
  async renamed_program(world) {
    const { editor, page } = world;
    await begin(world);
    const frame = await world.editor.openTrace(kProperty);
    for (let i = 0; i < 5; ++i) await editor.press('ArrowDown');
    await frame.locator('#step-5.current').waitFor();
    await editor.press('Control+1');
    await editor.openFile(kMain);
    await editor.command('File: Reveal Active File in Explorer View');
    await page.locator('.explorer-folders-view .monaco-list-row[aria-label^="survey.proskill"]').first().click();
    await editor.press('F2');
    const name = page.locator('.explorer-folders-view .monaco-inputbox input');
    await name.fill('moon.proskill');
    await name.press('Enter');
    await editor.tab('moon.proskill').first().waitFor();
    await editor.statusSays(/1 bad(?!.*outdated)/, 60_000);
    await expect('steps in the file of the new name', async () => /moon\.proskill/.test(await frame.locator('.steps').textContent()));
    await frame.locator('#step-5.current').waitFor();
    await frame.locator('.steps').press('ArrowDown');
    await expectMarked(editor, frame);
    await editor.openFile(`${kFolder}/parts.proskill`);
    await editor.statusSays(/1 bad(?!.*outdated)/);
    await editor.picture('renamed_program-step');
    await editor.closeAll();
    rmSync(join(world.root, kFolder, 'moon.proskill'));
  },

  /** A program without verdicts is not shown with the counts of another one; a part of two programs is shown with those of the one that is open. */
  async whose_verdicts({ editor, page, root, tree }) {
    await editor.closeAll();
    mkdirSync(join(root, kFolder), { recursive: true });
    writeFileSync(join(root, kFolder, 'parts.proskill'), kParts);
    writeFileSync(join(root, kFolder, 'bad.proskill'), kText);
    writeFileSync(join(root, kFolder, 'good.proskill'), kText.replace('(>= battery 1)', '(>= battery 0)'));
    await editor.openFile(`${kFolder}/bad.proskill`);
    await editor.statusSays(/1 bad/, 60_000);
    copyFileSync(join(tree, 'bench/missions/warehouse_fleet.proskill'), join(root, kFolder, 'slow.proskill'));
    await page.evaluate(watchStatus);
    await editor.openFile(`${kFolder}/slow.proskill`);
    await expect('no counts until there are some', async () => (await page.evaluate(() => window.statusTexts)).some((text) => text.trim() === 'ProSkill'));
    await editor.closeAll();
    await editor.openFile(`${kFolder}/good.proskill`);
    await editor.statusSays(/warning|good/, 60_000);
    await editor.openFile(`${kFolder}/parts.proskill`);
    await editor.statusSays(/ProSkill: (\d+ warnings?|\d+ of \d+ good)$/, 60_000);
    await editor.closeAll();
    for (const name of ['bad', 'good', 'slow']) rmSync(join(root, kFolder, `${name}.proskill`));
  },

  /** A branch brings a folder with a program, and another takes it away. Nobody opens or refreshes anything. */
  async branch(world) {
    const { editor, page, root } = world;
    await editor.closeAll();
    await showPrograms({ editor, page });
    mkdirSync(join(root, 'arriving/deep'), { recursive: true });
    writeFileSync(join(root, 'arriving/deep/arrived.proskill'), kParts);
    await program(page, 'arrived.proskill').waitFor();
    rmSync(join(root, 'arriving'), { recursive: true });
    await program(page, 'arrived.proskill').waitFor({ state: 'detached' });
    rmSync(join(root, kFolder), { recursive: true });
    await program(page, 'survey.proskill').waitFor({ state: 'detached' });
  },
};
