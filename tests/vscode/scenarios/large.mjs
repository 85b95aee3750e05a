// Programs of thousands of lines: typing during verification, and visible parts first. The tests type long enough to show that nothing moves.
// PROSKILL_TYPE_SECONDS=300 types for five minutes, and as much in an editor without the extension, by turns: the machine may be busy.
// PROSKILL_TYPE_PROFILE=trace.json writes what Chromium does meanwhile, for chrome://tracing.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { equal } from '../expect.mjs';
import { largeProgram } from '../typing/large_program.mjs';
import { profiled } from '../typing/profile.mjs';
import { Typist } from '../typing/typist.mjs';

const kFile = 'large/large.proskill';
const kPlain = 'large/plain.proskill';
const kViewed = 'large/viewed.proskill';
const kSettings = '.vscode/settings.json';
/** Events and a property that are decided after more than 10^12 states. */
const kEndless = Array.from({ length: 12 }, (_, i) => {
  const next = (i + 1) % 12;
  return `(defsv x${i} :min 0 :max 99 :init 0)
(defevent up${i} :guard (& (< x${i} 99) (<= x${i} (+ x${next} 50))) :effects (x${i} (+ x${i} 1)))
`;
}).join('') + '(defproperty near (always (<= x0 (+ x1 51))))\n';
const kProperty = 'stays_shut';
const kMeasured = Number(process.env.PROSKILL_TYPE_SECONDS ?? 0);
const kSeconds = kMeasured || 8;

function write(root, file, text) {
  mkdirSync(join(root, 'large'), { recursive: true });
  writeFileSync(join(root, file), text);
}

const told = ({ keys, p50, p95, most }) => `${keys} keys, p50 ${p50.toFixed(0)}, p95 ${p95.toFixed(0)}, most ${most.toFixed(0)} ms`;

/** Types in the editor, and after each line in one without the extension. */
async function typeByTurns({ editor, page, root, plain }, typist, text) {
  write(root, kPlain, text);
  await plain(async (other) => {
    await other.openFile(kPlain);
    const baseline = new Typist(other, kPlain, typist.line);
    await baseline.begin();
    while (typist.spent < kSeconds * 1000) {
      await page.bringToFront();
      await typist.typeLine();
      await editor.statusSays(/\d+ bad(?!.*outdated)/, 300_000); // the verification would slow the other one
      await other.page.bringToFront();
      await baseline.typeLine();
    }
    await page.bringToFront();
    const [ours, others] = [await typist.times(), await baseline.times()];
    console.log(`        without the extension: ${told(others)}; with it, p50 ${(ours.p50 / others.p50).toFixed(2)} and p95 ${(ours.p95 / others.p95).toFixed(2)} times as long`);
  });
}

async function typeAlone(typist) {
  while (typist.spent < kSeconds * 1000) await typist.typeLine();
}

/** The text on the disk, compared with what was typed below a line. */
function checkText(path, lines, { line, typed }) {
  const wanted = [...lines.slice(0, line - 1), ...typed.split('\n'), ...lines.slice(line)];
  const found = readFileSync(path, 'utf8').split('\n');
  const other = Math.max(found.findIndex((it, at) => it !== wanted[at]), 0);
  equal(`the text from line ${other + 1}`, found.slice(other, other + 3), wanted.slice(other, other + 3));
  equal('the number of lines', found.length, wanted.length);
}

export const scenarios = {
  /** 10,000 lines with an open trace and live verification. */
  async typing_large(world) {
    const { editor, page, root } = world;
    const text = largeProgram(10_000);
    write(root, kFile, text);
    await editor.closeAll();
    await editor.openFile(kFile);
    const lines = text.split('\n');
    await editor.goTo(lines.findIndex((it) => it.startsWith('(defproperty')) + 1); // what is in view is verified first
    await editor.statusSays(/bad/, 120_000);
    const frame = await editor.openTrace(kProperty);
    await frame.locator('.steps').press('ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    await editor.openFile(kFile);
    const typist = new Typist(editor, kFile, lines.indexOf('', Math.floor(lines.length / 2)) + 1);
    await typist.begin();
    const load = loadavg()[0].toFixed(1);
    await profiled(page, () => (kMeasured ? typeByTurns(world, typist, text) : typeAlone(typist)));
    const times = await typist.times();
    console.log(`        ${told(times)} in ${(typist.spent / 1000).toFixed(0)} s, load ${load} to ${loadavg()[0].toFixed(1)}; ${typist.moved} times the caret was elsewhere`);
    equal('times that the caret was elsewhere', typist.moved, 0);
    equal('keys that were shown', times.keys, typist.typed.length);
    equal('the step', await frame.locator('.step.current .number').textContent(), '2');
    await editor.picture('typing_large');
    await editor.save();
    checkText(join(root, kFile), lines, typist);
    await editor.closeAll();
  },

  /** 5,000 lines whose verification does not end: visible properties are decided nevertheless, and no worker is killed. */
  async in_view({ editor, page, root }) {
    writeFileSync(join(root, kSettings), '{"proskill.verify.seconds": 600}');
    const text = largeProgram(5_000, 'first one last') + kEndless;
    write(root, kViewed, text);
    await editor.openFile(kViewed);
    await editor.goTo(text.split('\n').indexOf('(defskill drop_1') + 1);
    await page.locator('.monaco-editor[data-uri$="viewed.proskill"] .glyph-margin-widgets > .codicon-testing-passed-icon').first().waitFor({ timeout: 120_000 });
    const said = await editor.status().textContent();
    console.log(`        ${said.trim()}, where the first one in view has its mark`);
    await editor.picture('in_view');
    equal('the verification', /verifying/.test(said), true);
    await editor.closeAll();
    writeFileSync(join(root, kSettings), '{}');
  },
};
