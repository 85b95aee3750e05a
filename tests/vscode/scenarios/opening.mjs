// From a click to what it shows: in a panel that is opened for it, and in one that is open. PROSKILL_OPENINGS=10 measures ten times; the tests
// only show that it works.
import { readFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

const kDrone = 'drone/drone.proskill';
const kTimes = Number(process.env.PROSKILL_OPENINGS ?? 1);
const median = (times) => times.toSorted((a, b) => a - b)[Math.floor(times.length / 2)];

const kPanels = {
  trace: { lens: /^✗ \d bad/, battery: 'battery ', mission: 'uav_mission ' },
  automaton: { lens: 'show automaton', battery: 'sv battery', mission: 'body uav_mission' },
};

/** The time of each click, and in each frame the time since when it shows the same trace or picture. */
const clock = () => {
  addEventListener('mousedown', () => { window.clickedAt = Date.now(); }, true);
  setInterval(() => {
    const [trace, picture] = ['.step.current', '.stage g.node'].map((it) => document.querySelector(it));
    const shown = trace ? document.querySelector('.trace-head h2').textContent : picture?.closest('.stage').dataset.picture;
    if (shown !== window.shown) [window.shown, window.shownAt] = [shown, Date.now()];
  }, 4);
};

const frameOf = async (page, name) => {
  for (const frame of page.frames()) if (await frame.evaluate((it) => window.shown?.includes(it), name).catch(() => false)) return frame;
  return undefined;
};

/** Milliseconds from a click on the lens of a definition to what it shows. A click is lost if the editor replaces the lens at that moment. */
async function clickToView({ editor, page, root }, lens, definition, name) {
  await editor.openFile(kDrone);
  const lines = readFileSync(join(root, kDrone), 'utf8').split('\n');
  await editor.goTo(lines.findIndex((line) => line.startsWith(definition)) + 1);
  await editor.statusSays(/\d+ bad, \d+ warnings?$/);
  const above = page.locator('.monaco-editor[data-uri$="drone.proskill"] .codelens-decoration')
    .filter({ hasText: definition.includes('battery') ? '1 bad' : '2 bad' }).locator('a', { hasText: lens });
  let clicked = 0;
  const frame = await expect(name, async () => {
    if (Date.now() > clicked + 8000) {
      await above.first().click({ timeout: 5000 });
      clicked = Date.now();
    }
    return frameOf(page, name);
  }, 60_000);
  return (await frame.evaluate(() => window.shownAt)) - (await page.evaluate(() => window.clickedAt));
}

const told = (times) => `${times.join(', ')} ms, median ${median(times)}`;

export const scenarios = {
  /** The panels of traces and automata: opened by a click, and shown something else by the next. */
  async opening(world) {
    const { editor, page } = world;
    await page.addInitScript(clock);
    await page.evaluate(clock);
    for (const [what, { lens, mission, battery }] of Object.entries(kPanels)) {
      const [opened, open] = [[], []];
      for (let count = 0; count < kTimes; ++count) {
        await editor.closeAll();
        opened.push(await clickToView(world, lens, '(defskill uav_mission', mission));
        open.push(await clickToView(world, lens, '(defsv battery', battery));
      }
      console.log(`        click to ${what}: ${told(opened)}; with the panel open: ${told(open)}; load ${loadavg()[0].toFixed(1)}`);
      equal(`times to the ${what}`, [...opened, ...open].every((time) => time > 0), true);
    }
    await editor.closeAll();
  },
};
