// A new user, and how long things take after a click. Figures are printed, and nothing is asserted of them.
// PROSKILL_TYPE_DELAY=200 types as a person does, for the stopwatch: milliseconds a key.
import { mkdirSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

const kDelay = Number(process.env.PROSKILL_TYPE_DELAY ?? 5);
const kDrone = 'drone/drone.proskill';

/** The program that the walkthrough asks for; the editor closes parentheses and indents by itself. */
const kFirst = [
  '(defsv door :states (Open Shut) :init Shut :transitions ((Shut Open) (Open Shut)))',
  '(defskill open_door :time_interval [1,2] :action (open) :success open (:effects (door Open)))',
  '(defskill drive :time_interval [5,9] :action (drive) :success there)',
  '(defskill mission :success done :body ((open_door) (drive) (success done)))',
  '(defproperty drives_shut (never (and (running drive) (door Open))))',
];

const lens = (page, text) => page.locator('.codelens-decoration a').filter({ hasText: text }).first();

async function timed(figures, name, action, shown) {
  const begin = Date.now();
  await action();
  await shown();
  figures.push(`${name} ${Date.now() - begin} ms`);
}

export const scenarios = {
  /** An empty file, a first program, a counterexample, its repair. */
  async first_minutes({ editor, page }) {
    await editor.command('View: Close All Editors');
    const begin = Date.now();
    await editor.command('ProSkill: New Program');
    await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
    for (const line of kFirst) {
      await page.keyboard.type(line, { delay: kDelay });
      await editor.press('Escape', 'Control+End', 'Enter');
    }
    await editor.statusSays(/\d+ bad/, 90_000);
    const found = Date.now();
    await lens(page, /^✗ 1 bad/).click();
    const frame = await editor.panel('.trace-view');
    await frame.locator('.badge.violated').waitFor();
    await frame.locator('.step.current').first().waitFor();
    await editor.picture('first-violated');
    // the door is closed before the robot drives
    await editor.press('Control+1');
    await editor.goTo(4, kFirst[3].indexOf('(drive)') + 1);
    await page.keyboard.type('(set (door Shut)) ', { delay: kDelay });
    await editor.press('Escape');
    await frame.locator('.badge.holds:visible').waitFor({ timeout: 60_000 });
    const seconds = (to) => ((to - begin) / 1000).toFixed(0);
    console.log(`        a first counterexample after ${seconds(found)} s, repaired after ${seconds(Date.now())} s, at ${kDelay} ms a key, load ${loadavg()[0].toFixed(1)}`);
    await editor.picture('first-holds');
    await expect('an empty text', async () => {
      await editor.press('Control+1', 'Control+z');
      return !(await page.locator('.tab.active.dirty').count());
    });
    await editor.command('View: Close All Editors');
  },

  /** From a click on a lens to its result, with and without an open panel. */
  async clicks({ editor, page }) {
    const figures = [];
    const begin = loadavg()[0].toFixed(1);
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
    await editor.command('View: Close All Editors');
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
      return [...shown.querySelectorAll('.glyph-margin-widgets > [class*="testing"]')].map((mark) => lineOf.get(parseFloat(mark.style.top))).filter(Boolean).sort();
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
    await editor.command('View: Close All Editors');
  },
};
