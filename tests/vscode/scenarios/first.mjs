// A new user, and how long things take after a click. Figures are printed, and nothing is asserted of them.
// PROSKILL_TYPE_DELAY=200 types as a person does, for the stopwatch: milliseconds a key.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

const kDelay = Number(process.env.PROSKILL_TYPE_DELAY ?? 5);
const kDrone = 'drone/drone.proskill';

/** The lines of the program on a page of the walkthrough. */
const programOn = (page) =>
  /```proskill\n([^]*?)\n```/.exec(readFileSync(new URL(`../../../vscode-extension/walkthrough/${page}.md`, import.meta.url), 'utf8'))[1].split('\n');

/** The program that the walkthrough asks for; the editor closes parentheses, indents, and formats a definition when it is complete. */
const kFirst = programOn('write');
/** What the walkthrough inserts, and before what. */
const kFix = '(set (door Shut)) ';
const kFixBefore = '(drive)';

const kTyped = ['(defskill wait_a_moment', ':success done', ':body', '((^ [1,2])', '(success done)))'];
const kFormatted = '(defskill wait_a_moment :success done :body ((^ [1,2]) (success done)))';
/** A hint at the end of the first line. */
const kDuration = ' 1 to 2 s';

/** A definition in the style of nobody. */
const kPasted = '(defevent slam\n      :effects (door Shut)\n    )\n';

/** The visible lines of the text that has no name yet. */
const shownText = async (page) => (await page.evaluate(() => [...document.querySelectorAll('.monaco-editor[data-uri^="untitled:"] .view-line')]
  .sort((a, b) => parseFloat(a.style.top) - parseFloat(b.style.top)).map((it) => it.textContent).join('\n'))).replaceAll('\u00a0', ' ');

/** The same without hints, and without the empty line at the end. */
const typedText = async (page) => (await shownText(page)).replace(/[^\S\n]*(\d+ to )?\d+ s[^\S\n]*$/gm, '').trimEnd();

const indentation = (line) => /^ */.exec(line)[0].length;

const words = (text) => text.replace(/\s+/g, ' ').trim();

const lens = (page, text) => page.locator('.codelens-decoration a').filter({ hasText: text }).first();

async function timed(figures, name, action, shown) {
  const begin = Date.now();
  await action();
  await shown();
  figures.push(`${name} ${Date.now() - begin} ms`);
}

/** Runs a command of the palette without the mouse. */
async function byKeys(editor, title) {
  await editor.press('F1');
  await editor.quickInput().locator('input.input').fill(`>${title}`);
  await editor.quickInput().locator(`.monaco-list-row.focused[aria-label^="${title}"]`).waitFor();
  await editor.press('Enter');
}

/** What has the keyboard in the panel, and whether it shows that. */
const focused = (frame) => frame.evaluate(() => {
  const part = document.activeElement;
  const { outlineStyle } = getComputedStyle(part);
  return { name: part.getAttribute('aria-label') ?? part.textContent, isMarked: outlineStyle !== 'none' || part.matches('.search, .watch') };
});

/** Tab leads through the panel from its list of steps: every part has a name and shows that it has the keyboard. */
async function walk(editor, frame) {
  const names = [];
  for (const key of ['Shift+Tab', 'Tab', 'Tab', 'Tab', 'Tab']) {
    await editor.press(key);
    const { name, isMarked } = await focused(frame);
    equal(`${name || `what follows ${names.at(-1)}`} has a name, and is marked`, [Boolean(name), isMarked], [true, true]);
    names.push(name);
  }
  for (let i = 0; i < 3; ++i) await editor.press('Shift+Tab');
  equal('the list of steps', (await focused(frame)).name, 'Steps of the trace');
}

export const scenarios = {
  /** An empty file, a first program, a counterexample, its repair; without the mouse. */
  async first_minutes({ editor, page }) {
    await editor.closeAll();
    const begin = Date.now();
    await byKeys(editor, 'ProSkill: New Program');
    await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
    for (const line of kFirst) {
      await page.keyboard.type(line.trim(), { delay: kDelay });
      await editor.press('Enter');
    }
    await editor.statusSays(/\d+ bad/, 90_000);
    const found = Date.now();
    await lens(page, /^✗ 1 bad/).waitFor();
    await byKeys(editor, 'ProSkill: Open Trace');
    await editor.answer('drives_shut');
    const frame = await editor.panel('.trace-view');
    await frame.locator('.badge.violated').waitFor();
    await frame.locator('#step-0.current').waitFor();
    await expect('the keyboard in the list of steps', async () => (await focused(frame)).name === 'Steps of the trace');
    await walk(editor, frame);
    await editor.press('ArrowDown', 'ArrowDown');
    await frame.locator('#step-2.current').waitFor();
    await editor.picture('first-violated');
    await editor.press('Enter'); // the keyboard goes to the text of the step
    await expect('the caret at the step', async () => (await editor.caret()).startsWith('Ln 2,') && page.evaluate(() => !!document.activeElement?.closest('.monaco-editor[data-uri^="untitled:"]')));
    // the door is closed before the robot drives
    const mission = kFirst.slice(kFirst.indexOf('(defskill mission'), kFirst.indexOf('(defproperty drives_shut'));
    equal('the fix', words(mission.join('\n')).replace(kFixBefore, kFix + kFixBefore), words(programOn('fix').join('\n')));
    await editor.press('Control+End', 'Control+f');
    const find = page.locator('.find-widget.visible textarea[aria-label="Find"]');
    await find.fill(kFixBefore);
    await page.locator('.find-widget.visible .matchesCount', { hasText: /of \d/ }).waitFor();
    await editor.press('Shift+Enter', 'Escape', 'ArrowLeft');
    await page.keyboard.type(kFix, { delay: kDelay });
    await editor.press('Escape');
    await frame.locator('.badge.holds:visible').waitFor({ timeout: 60_000 });
    const seconds = (to) => ((to - begin) / 1000).toFixed(0);
    console.log(`        a first counterexample after ${seconds(found)} s, repaired after ${seconds(Date.now())} s, at ${kDelay} ms a key, load ${loadavg()[0].toFixed(1)}`);
    await editor.picture('first-holds');
    await editor.emptyText();
    await editor.closeAll();
  },

  /**
   * A definition typed over several lines, at a person's speed: the editor closes each parenthesis, the server indents each line and formats the whole at
   * its end, typing what the editor has closed adds nothing, and Enter after the name of an outcome or after `:body` takes no snippet.
   */
  async typed_lines({ editor, page }) {
    await editor.closeAll();
    await editor.command('ProSkill: New Program');
    await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
    for (const [count, line] of kTyped.entries()) {
      if (count) await editor.press('Enter');
      await page.keyboard.type(line, { delay: Math.max(kDelay, 100) });
    }
    await expect('the definition as typed, formatted', async () => words(await shownText(page)).replace(kDuration, '') === kFormatted);
    await editor.picture('typed_lines');
    await editor.emptyText();
    await editor.closeAll();
  },

  /**
   * Lines typed faster than the server answers: nothing drifts to the right meanwhile, and when it answers, each line gets its indentation, except that of
   * the caret. What was pasted or undone stays as it is.
   */
  async typed_ahead({ editor, page, server, proskill }) {
    const formatted = execFileSync(proskill, ['fmt', '-'], { input: kFirst.join('\n'), encoding: 'utf8' }).replace(/\n+/g, '\n').trimEnd();
    await editor.closeAll();
    await editor.command('ProSkill: New Program');
    await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
    await page.keyboard.type(';');
    await editor.statusSays(/good|no/); // the server knows the text
    await editor.press('Backspace');
    const { pid } = server.servers().find(({ args }) => args[0] === 'lsp');
    process.kill(pid, 'SIGSTOP');
    try {
      for (const line of kFirst) {
        await page.keyboard.type(line.trim(), { delay: kDelay });
        await editor.press('Enter');
      }
      await editor.picture('typed_ahead-stopped');
      const deepest = Math.max(...formatted.split('\n').map(indentation));
      equal('lines that have drifted', (await typedText(page)).split('\n').filter((line) => indentation(line) > deepest), []);
    } finally {
      process.kill(pid, 'SIGCONT');
    }
    await expect('the text, formatted', async () => (await typedText(page)) === formatted, 20_000).catch(() => undefined);
    equal('the text', await typedText(page), formatted);
    equal('the caret', await editor.caret(), `Ln ${formatted.split('\n').length + 1}, Col 1`);
    await editor.picture('typed_ahead');
    await page.evaluate((text) => navigator.clipboard.writeText(text), kPasted);
    await editor.press('Control+v');
    await expect('the pasted text', async () => (await shownText(page)).includes(kPasted.trimEnd()));
    await page.keyboard.type('(defskill rest', { delay: kDelay });
    await editor.press('Enter');
    await page.keyboard.type('   :time_interval [1,2]', { delay: kDelay }); // too far to the right: shows when the lines are formatted
    await editor.press('Enter', 'Control+Home');
    const pasted = [formatted, kPasted + '(defskill rest', '  :time_interval [1,2]', '  )'].join('\n');
    await expect('the text as it was pasted, and as typed, formatted', async () => (await typedText(page)) === pasted).catch(() => undefined);
    equal('the text', await typedText(page), pasted);
    await expect('nothing after undo', async () => {
      await editor.press('Control+z');
      return (await typedText(page)) === '';
    });
    await editor.emptyText();
    await editor.closeAll();
  },

  /** Definitions are offered where they may begin, with or without the parenthesis. */
  async offered({ editor, page }) {
    await editor.closeAll();
    await editor.command('ProSkill: New Program');
    await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
    const list = page.locator('.suggest-widget.visible .monaco-list-row');
    for (const typed of ['missi', '(missi']) {
      await page.keyboard.type(typed, { delay: 50 });
      await list.filter({ hasText: 'A skill made of others' }).first().waitFor();
      if (typed[0] === '(') await editor.picture('offered');
      await list.filter({ hasText: 'A skill made of others' }).first().click();
      await expect('a composite skill', async () => /^\(defskill mission :success done :failure gave_up :body \(\(skill\).*\)$/.test(words(await shownText(page))));
      await editor.press('Escape', 'Control+a', 'Delete');
    }
    await editor.emptyText();
    await editor.closeAll();
  },

  /** From a click on a lens to its result, with and without an open panel. What the editor itself takes for a page, its Markdown preview shows. */
  async clicks({ editor, page }) {
    const figures = [];
    const begin = loadavg()[0].toFixed(1);
    await editor.openFile('drone/README.md');
    const preview = async () => (await editor.panel('body.vscode-body')).locator('h1').first().waitFor();
    await timed(figures, "the editor's own preview", () => page.locator('.editor-actions .action-label[aria-label^="Open Preview to the Side"]').first().click(), preview);
    await editor.closeAll();
    await editor.openFile(kDrone);
    await editor.goTo(161);
    await editor.statusSays(/\d+ bad, \d+ warnings?/, 60_000);
    const mission = page.locator('.codelens-decoration', { hasText: '2 bad, 8 warnings' });
    const automaton = async () => (await editor.panel('.automaton-view')).locator('.stage[data-picture="body uav_mission"] g.node').first().waitFor();
    const trace = async () => (await editor.panel('.trace-view')).locator('.trace-head .badge.violated').waitFor();
    await timed(figures, 'automaton', () => mission.locator('a', { hasText: 'show automaton' }).first().click(), automaton);
    await timed(figures, 'automaton again', () => mission.locator('a', { hasText: 'show automaton' }).first().click(), automaton);
    await editor.command('View: Close Editors in Other Groups').catch(() => undefined);
    await editor.openFile(kDrone);
    await timed(figures, 'trace', () => mission.locator('a', { hasText: '✗ 2 bad' }).first().click(), trace);
    const frame = await editor.panel('.trace-view');
    const name = await frame.locator('.trace-head h2').getAttribute('title');
    await timed(figures, 'trace again', () => mission.locator('a', { hasText: '✗ 2 bad' }).first().click(), trace);
    equal('the trace', await frame.locator('.trace-head h2').getAttribute('title'), name);
    console.log(`        ${figures.join(', ')}; load ${begin} to ${loadavg()[0].toFixed(1)}`);
    await editor.closeAll();
  },

  /** After inserting two lines above: results, lenses and squiggles are at their statements. */
  async lines_above({ editor, page, root }) {
    mkdirSync(join(root, 'ids'), { recursive: true });
    writeFileSync(join(root, 'ids/shifted.proskill'), `${kFirst.join('\n')}\n`);
    await editor.openFile('ids/shifted.proskill');
    await editor.statusSays(/1 bad/, 60_000);
    const lines = () => page.evaluate(() => {
      const shown = document.querySelector('.monaco-editor[data-uri$="ids/shifted.proskill"]');
      const lineOf = new Map([...shown.querySelectorAll('.margin-view-overlays > div')]
        .map((row) => [parseFloat(row.style.top), Number(row.querySelector('.line-numbers')?.textContent)]));
      return [...shown.querySelectorAll('.glyph-margin-widgets > [class*="testing"]')].map((mark) => lineOf.get(parseFloat(mark.style.top))).filter(Boolean).sort((a, b) => a - b);
    });
    const before = await expect('results in the margin', async () => {
      const found = await lines();
      return found.length && found;
    });
    await editor.goTo(1);
    await editor.press('Enter', 'Enter');
    await expect('results two lines below', async () => JSON.stringify(await lines()) === JSON.stringify(before.map((line) => line + 2)));
    await editor.statusSays(/1 bad(?!.*outdated)/, 60_000);
    await expect('results two lines below, verified again', async () => JSON.stringify(await lines()) === JSON.stringify(before.map((line) => line + 2)));
    await editor.command('Testing: Focus on Test Explorer View');
    // rows below the fold do not exist, so each is filtered for
    for (const name of ['lift/bug.proskill', 'rover/bug.proskill', 'shifted.proskill']) {
      await page.locator('.testing-filter-wrapper').click();
      await editor.press('Control+a');
      await page.keyboard.type(name);
      await page.locator(`.test-explorer .monaco-list-row[aria-label*="${name}"]`).first().waitFor();
    }
    await page.locator('.testing-filter-wrapper').click();
    await editor.press('Control+a', 'Backspace');
    await editor.picture('lines_above');
    await editor.openFile('ids/shifted.proskill');
    await editor.command('File: Revert File');
    await editor.closeAll();
  },
};
