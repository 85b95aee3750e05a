// Programs of thousands of lines: typing during verification, and visible parts first. PROSKILL_TYPE_SECONDS=300 types for five minutes; the tests
// type long enough to show that nothing moves.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { largeProgram } from '../large_program.mjs';

const kFile = 'large/large.proskill';
const kViewed = 'large/viewed.proskill';
const kProperty = 'stays_shut';
const kSeconds = Number(process.env.PROSKILL_TYPE_SECONDS ?? 15);
const kWords = 'what a person types while the program is verified again and again stays where it was typed'.split(' ');
const kWordsALine = 12;

/** Milliseconds from each key to the mutation that shows it, within the painted frame; one mutation can show several keys. */
const watchKeys = (page) => page.evaluate((end) => {
  const editor = [...document.querySelectorAll('.monaco-editor[data-uri]')].find((it) => it.dataset.uri.endsWith(end));
  let pressed = [];
  window.keyTimes = [];
  addEventListener('keydown', (event) => pressed.push(event.timeStamp), true);
  new MutationObserver(() => {
    const now = performance.now();
    window.keyTimes.push(...pressed.map((time) => now - time));
    pressed = [];
  }).observe(editor.querySelector('.view-lines'), { subtree: true, childList: true, characterData: true });
}, kFile);

function write(root, file, text) {
  mkdirSync(join(root, 'large'), { recursive: true });
  writeFileSync(join(root, file), text);
}

const part = (sorted, at) => sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * at))].toFixed(0);

/** Types words into comments until the time limit; returns the text, and how often the caret was in a wrong position. */
async function typeFor(editor, page, seconds, line) {
  const end = Date.now() + seconds * 1000;
  let typed = '';
  let moved = 0;
  for (let count = 0; count === 0 || Date.now() < end; ++count) {
    const begins = count % kWordsALine === 0;
    // no blank before Enter, which removes it
    const word = `${begins ? `${count ? '\n' : ''};` : ''} ${kWords[count % kWords.length]}`;
    for (const key of word) await (key === '\n' ? editor.press('Enter') : editor.type(key));
    typed += word;
    const last = typed.split('\n');
    const wanted = `Ln ${line + last.length - 1}, Col ${last.at(-1).length + 1}`;
    await page.waitForTimeout(count % 4 === 3 ? 900 : 60); // a pause starts a verification
    if ((await editor.caret()) !== wanted) {
      // the status bar is updated a little later than the text
      await expect('the caret', async () => (await editor.caret()) === wanted, 3000).catch(() => { ++moved; });
    }
  }
  return { typed, moved };
}

export const scenarios = {
  /** 10,000 lines with an open trace and live verification. */
  async typing_large({ editor, page, root }) {
    const text = largeProgram(10_000);
    write(root, kFile, text);
    await editor.command('View: Close All Editors');
    await editor.openFile(kFile);
    await editor.statusSays(/bad/, 120_000);
    await editor.command('ProSkill: Open Trace');
    await editor.answer(kProperty);
    const frame = await editor.panel('.trace-view');
    await frame.locator('#step-0.current').waitFor();
    await frame.locator('.steps').press('ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    await editor.openFile(kFile);
    const lines = text.split('\n');
    const line = lines.indexOf('', Math.floor(lines.length / 2)) + 1;
    await editor.goTo(line);
    await watchKeys(page);
    const load = loadavg()[0].toFixed(1);
    const { typed, moved } = await typeFor(editor, page, kSeconds, line);
    const times = (await page.evaluate(() => window.keyTimes)).sort((a, b) => a - b);
    console.log(`        ${typed.length} keys in ${kSeconds} s, load ${load} to ${loadavg()[0].toFixed(1)}: ` +
      `p50 ${part(times, 0.5)}, p95 ${part(times, 0.95)}, most ${times.at(-1).toFixed(0)} ms; ${moved} times the caret was elsewhere`);
    equal('times that the caret was elsewhere', moved, 0);
    equal('keys that were shown', times.length, typed.length);
    equal('the step', await frame.locator('.step.current .number').textContent(), '2');
    await editor.picture('typing_large');
    await editor.save();
    const wanted = [...lines.slice(0, line - 1), ...typed.split('\n'), ...lines.slice(line)];
    const found = readFileSync(join(root, kFile), 'utf8').split('\n');
    const other = Math.max(found.findIndex((it, at) => it !== wanted[at]), 0);
    equal(`the text from line ${other + 1}`, found.slice(other, other + 3), wanted.slice(other, other + 3));
    equal('the number of lines', found.length, wanted.length);
    await editor.command('View: Close All Editors');
  },

  /** 5,000 lines whose verification takes long: visible properties are decided first, and no worker is killed. */
  async in_view({ editor, page, root }) {
    const text = largeProgram(5_000, 'first one last');
    write(root, kViewed, text);
    await editor.openFile(kViewed);
    await editor.goTo(text.split('\n').indexOf('(defskill drop_1') + 1);
    await page.locator('.monaco-editor[data-uri$="viewed.proskill"] .glyph-margin-widgets > .codicon-testing-passed-icon').first().waitFor({ timeout: 120_000 });
    const said = await editor.status().textContent();
    const [, done, total] = /(\d+) of (\d+) decided/.exec(said) ?? [];
    console.log(`        ${said.trim()}, where the first one in view has its mark`);
    await editor.picture('in_view');
    equal('a worker that was killed', /signal/.test(said), false);
    // if the machine has decided all by now, the order is unknown
    if (done) equal('properties decided before', Number(done) < Number(total), true);
    await editor.command('View: Close All Editors');
  },
};
