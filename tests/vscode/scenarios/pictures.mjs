// The pictures of the walkthrough and of the README, of today's extension.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { expand, failing } from './verification.mjs';

/** The words in each picture. PROSKILL_UPDATE=1 makes the pictures again, and this file; look at what has changed. */
const kWords = new URL('pictures.json', import.meta.url);
const kFiles = {
  automaton: 'vscode-extension/walkthrough/automaton.png',
  trace: 'vscode-extension/walkthrough/trace.png',
  verify: 'vscode-extension/walkthrough/verify.png',
  readme: 'docs/images/vscode.png',
};
/** The walkthrough shows pictures at half the width of a window. */
const kSmall = { width: 1000, height: 640 };
const kWhole = { width: 1440, height: 900 };

const tidy = (text) => text.replace(/[\s\u200b]+/g, ' ').trim();

/** The words of the panel but its steps: of these only some beside those in view exist. */
const inPanel = () => document.body.innerText.replace(document.querySelector('.steps')?.innerText ?? '', '');

/** The words of lenses, of the properties of a text without a name, of the status bar and of the panel. */
async function wordsOf(page, panel) {
  const of = async (where) => (await where.allTextContents()).map(tidy).filter(Boolean).sort();
  return {
    lenses: await of(page.locator('.monaco-editor[data-uri^="untitled:"] .codelens-decoration')),
    // without how long they took
    tests: panel ? [] : (await of(page.locator('.test-explorer .monaco-list-row .label')))
      .map((label) => label.replace(/[\d.]+m?s$/, '')).filter((label) => !/\.proskill$|Untitled-/.test(label)),
    status: await of(page.locator('[id$="proskill.status"]')),
    panel: panel ? tidy(await panel.evaluate(inPanel)).split(/(?<=[.:]) /) : [],
  };
}

/** Either makes a picture, or compares the words in it with those of today. */
async function shown({ editor, page, tree }, name, panel) {
  await page.mouse.move(720, 639); // nothing to hover
  const known = JSON.parse(readFileSync(kWords, 'utf8'));
  const isUpdate = process.env.PROSKILL_UPDATE === '1';
  let words;
  const isKnown = async () => JSON.stringify((words = await wordsOf(page, panel))) === JSON.stringify(known[name]);
  await expect('the known words', isKnown, isUpdate ? 3_000 : 20_000).catch(() => undefined); // some come later
  await editor.picture(`pictures-${name}`);
  if (!isUpdate) return equal(`the words in ${kFiles[name]}, which are outdated`, known[name], words);
  writeFileSync(kWords, `${JSON.stringify({ ...known, [name]: words }, null, 1)}\n`);
  await page.screenshot({ path: join(tree, kFiles[name]) });
}

/** Closes the panel of consoles, which others have left open. */
async function hideConsoles({ editor, page }) {
  const consoles = page.locator('[id="workbench.parts.panel"]');
  if (!(await consoles.isVisible())) return;
  await editor.command('View: Hide Panel');
  await consoles.waitFor({ state: 'hidden' });
}

export const scenarios = {
  /** A trace of the drone's mission, beside its text and its properties. */
  async picture_of_the_readme(world) {
    const { editor, page } = world;
    await editor.closeAll();
    await hideConsoles(world);
    await editor.openFile('drone/drone.proskill');
    await editor.statusSays(/\d+ bad, \d+ warnings?$/, 60_000);
    await editor.command('Testing: Focus on Test Explorer View');
    await expand(page, 'drone.proskill (');
    await expand(page, 'uav_mission (');
    await editor.openFile('drone/drone.proskill');
    await editor.goTo(161);
    await page.locator('.codelens-decoration', { hasText: '21 good | 0 references' }).waitFor();
    const frame = await editor.openTrace(failing);
    for (let i = 0; i < 8; ++i) await frame.locator('.steps').press('ArrowDown');
    await frame.locator('#step-8.current').waitFor();
    await shown(world, 'readme', frame);
    await editor.closeAll();
  },

  /** The program that the walkthrough has one write: its automaton, its trace, its properties. */
  async pictures(world) {
    const { editor, page, tree } = world;
    const [, program] = /```proskill\n([^]*?)\n```/.exec(readFileSync(join(tree, 'vscode-extension/walkthrough/write.md'), 'utf8'));
    await editor.closeAll();
    await hideConsoles(world);
    await editor.command('Notifications: Clear All Notifications');
    await editor.command('Testing: Focus on Test Explorer View');
    await page.setViewportSize(kSmall);
    try {
      await editor.press('Control+b'); // more space for the text
      await editor.command('ProSkill: New Program');
      await page.locator('.tab.active').filter({ hasText: 'Untitled' }).waitFor();
      await page.evaluate((text) => navigator.clipboard.writeText(text), `${program}\n`);
      await editor.press('Control+v');
      await editor.statusSays(/1 bad$/, 60_000);
      await page.locator('.codelens-decoration', { hasText: '5 good · 6 to 11 s | 0 references' }).waitFor();
      await editor.goTo(11, 12);
      await editor.command('ProSkill: Show Automaton');
      const automaton = await editor.panel('.automaton-view');
      await automaton.locator('.stage[data-picture="body mission"] .ring.selected').waitFor();
      await shown(world, 'automaton', automaton);
      await editor.command('View: Close Editors in Other Groups');
      const trace = await editor.openTrace('drives_shut');
      await trace.locator('.steps').press('ArrowDown');
      await trace.locator('.steps').press('ArrowDown');
      await trace.locator('#step-2.current').waitFor();
      const uri = await page.locator('.monaco-editor[data-uri^="untitled:"]').getAttribute('data-uri');
      await expect('the step beside its text', async () => (await editor.inlineValues(uri)).some((it) => it.includes('step 3 of 7')));
      await shown(world, 'trace', trace);
      await editor.press('Control+1');
      await editor.command('View: Close Editors in Other Groups');
      await editor.command('Testing: Focus on Test Explorer View');
      await page.locator('.test-explorer .monaco-list').first().focus();
      await editor.press('Control+ArrowLeft', 'End'); // only rows in view exist
      await expand(page, `${uri} (`);
      await editor.press('End');
      await expand(page, 'drives_shut (');
      await page.locator('.test-explorer .monaco-list-row', { hasText: 'never' }).first().waitFor();
      await shown(world, 'verify');
    } finally {
      await page.setViewportSize(kWhole);
      await editor.press('Control+1');
      await editor.emptyText();
    }
    await editor.closeAll();
  },
};
