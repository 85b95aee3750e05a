import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

function report(proskill, program) {
  try {
    return execFileSync(proskill, ['verify', '--format', 'json', '--traces', 'all', program], { encoding: 'utf8', maxBuffer: 1 << 26 });
  } catch (error) {
    return error.stdout;
  }
}

/** By text of the program. */
const reports = new Map();

/** The verdict of `proskill verify` on a property, with which the editor has to agree. */
export function verified({ proskill, root }, program, name) {
  const path = join(root, program);
  const text = readFileSync(path, 'utf8');
  if (!reports.has(text)) reports.set(text, JSON.parse(report(proskill, path)));
  return reports.get(text).properties.find((property) => property.name === name);
}

const kProgram = 'drone/drone.proskill';
/** The mission may end too early. */
export const failing = 'uav_mission.no_undershoot';
const kSubject = 'uav_mission';
export const row = (page, label) => page.locator(`.test-explorer .monaco-list-row[aria-label*="${label}"]`);

/** Opens a row that is closed. */
async function open(page, text) {
  const found = row(page, text).first();
  if ((await found.getAttribute('aria-expanded', { timeout: 1000 })) === 'true') return;
  await found.locator('.monaco-tl-twistie').click({ timeout: 1000 });
}

/** Opens a row, however often the tree is redrawn meanwhile. */
export async function expand(page, text) {
  const found = row(page, text).first();
  await expect(`${text} opened`, async () => {
    await open(page, text);
    return (await found.getAttribute('aria-expanded', { timeout: 1000 })) === 'true';
  });
}

export const scenarios = {
  /** The failing property of the drone is run from the Testing view. */
  async testing(world) {
    const { editor, page } = world;
    const { description } = verified(world, kProgram, failing);
    world.failingRow = description.replace(/^.*` /, '');
    await editor.closeAll();
    await editor.openFile(kProgram);
    await editor.command('Testing: Focus on Test Explorer View');
    const property = row(page, world.failingRow).first();
    await expect('a run of the property', async () => { // its row is another one when the file that was closed is there again
      await open(page, 'drone.proskill (');
      await open(page, `${kSubject} (`);
      await property.hover({ timeout: 1000 });
      await property.locator('.codicon-testing-run-icon').first().click({ timeout: 1000 });
      return true;
    });
    await property.locator('.codicon-testing-failed-icon').first().waitFor({ timeout: 60_000 });
    const program = row(page, 'drone.proskill (').first();
    await program.hover();
    await program.locator('.codicon-testing-run-icon').first().click();
    await row(page, 'can run').first().locator('.codicon-testing-passed-icon').waitFor({ timeout: 60_000 });
    await property.locator('.codicon-testing-failed-icon').first().waitFor();
    equal('warnings as failures', await row(page, 'is never refused').first().locator('.codicon-testing-failed-icon').count(), 0);
    await editor.press('Control+1');
    await editor.goTo(161);
    await page.locator('.codelens-decoration', { hasText: '2 bad, 8 warnings' }).first().waitFor();
    await editor.picture('testing-all');
  },

  /** Opens its trace, and steps through it by keys: the marked lines are those of the steps. */
  async trace(world) {
    const { editor, page } = world;
    const { trace } = verified(world, kProgram, failing);
    await editor.openFile(kProgram);
    const before = await editor.caret();
    const property = row(page, world.failingRow).first();
    await property.hover();
    await property.locator('.codicon-list-ordered').first().click();
    const frame = await editor.panel();
    await frame.locator('.step.current').first().waitFor();
    await frame.locator('.step.current').first().click();
    await page.keyboard.press('Home');
    let compared = 0;
    for (const [index, { location, changes }] of trace.steps.entries()) {
      await frame.locator(`#step-${index}.current`).waitFor();
      if (location) {
        const file = location.file.split('/').pop();
        await expect(`step ${index + 1} marked in ${file}:${location.begin.line}`, async () =>
          (await editor.markedLines(file))[0] === location.begin.line);
        const values = (await editor.inlineValues(file)).join(' ');
        for (const { variable, before, after } of changes)
          equal(`values at step ${index + 1}`, values.includes(`${variable}: ${before} → ${after}`), true);
        ++compared;
      }
      if (index === Math.floor(trace.steps.length / 2)) await editor.picture('trace-half');
      await page.keyboard.press('ArrowDown');
    }
    console.log(`        ${compared} of ${trace.steps.length} steps compared with their lines`);
    await editor.press('Control+1');
    equal('the caret, which is the user\'s', await editor.caret(), before);
    // Enter goes to the step's text.
    await frame.locator('.step.current').first().click();
    await page.keyboard.press('Home');
    await frame.locator('#step-0.current').waitFor();
    await page.keyboard.press('Enter');
    const { line, column } = trace.steps[0].location.begin;
    await expect('the caret at the first step', async () => (await editor.caret()) === `Ln ${line}, Col ${column}`);
  },

  /** The Fiacre text beside it: the transition of the step is marked. */
  async fiacre({ editor, page }) {
    await editor.command('ProSkill: Show the Fiacre Model');
    await page.locator('.monaco-editor[data-uri^="proskill-model"] .view-line', { hasText: 'uav_mission' }).first().waitFor();
    await editor.command('ProSkill: Next Step of the Trace');
    await expect('a marked line in the model', async () => page.evaluate(() => {
      const model = [...document.querySelectorAll('.monaco-editor[data-uri]')].find((it) => it.dataset.uri.startsWith('proskill-model'));
      return !!model?.querySelector('.view-overlays [class*="ced-"]');
    }));
    await editor.picture('fiacre-step');
    await editor.closeAll();
  },
};
