// What can be done in the automaton's panel. It shows the mission, as `automaton` has left it.
import { equal, expect } from '../expect.mjs';
import { choose, saved } from '../panel.mjs';

const nodes = (frame) => frame.locator('.stage g.node').count();
/** Number of line styles of the boxes in the legend. */
const legendLines = (frame) => frame.locator('.stage g.graph > polygon:not(:first-of-type)').evaluateAll((boxes) =>
  new Set(boxes.map((box) => getComputedStyle(box).stroke)).size);
const folded = (frame) => frame.locator('.stage g.role-folded');
const caretLine = async (page) => Number(await page.locator('.monaco-editor[data-uri$="drone.proskill"] .active-line-number').first().textContent());

const clipboard = (page) => page.evaluate(() => navigator.clipboard.readText());

export const scenarios = {
  /** Folds branches to one node each, and unfolds them: by the menu, a double click, and the keyboard. */
  async fold({ editor }) {
    const frame = await editor.panel();
    const open = await nodes(frame);
    await choose(frame, 'Fold branches', 'Fold all');
    await folded(frame).filter({ hasText: 'branch 2' }).waitFor();
    await editor.statusSays(/\d+ bad, \d+ warnings?/); // of the text, although the focus is in the picture
    equal('fewer nodes', (await nodes(frame)) < open, true);
    await editor.picture('fold-all');
    await folded(frame).filter({ hasText: 'branch 2' }).dblclick();
    await folded(frame).filter({ hasText: 'branch 2' }).waitFor({ state: 'detached' });
    equal('the other branch stays folded', await folded(frame).filter({ hasText: 'branch 1' }).count(), 1);
    await choose(frame, 'Fold branches', 'Open all');
    await expect('all nodes', async () => (await nodes(frame)) === open);
  },

  /** Matches are highlighted, and Enter goes to the next. */
  async search({ editor, page }) {
    const frame = await editor.panel();
    await frame.locator('.automaton-view .search').fill('goto_waypoint');
    await expect('what is found, and the rest pale', async () =>
      (await frame.locator('.stage svg.searching g.node.found').count()) === 3);
    const words = () => frame.locator('.part-words').textContent();
    const first = await words();
    await page.keyboard.press('Enter');
    await expect('the next that is found', async () => (await words()) !== first && (await words()).includes('goto_waypoint'));
    await editor.picture('search-found');
    await page.keyboard.press('Escape');
    await frame.locator('.stage svg:not(.searching)').waitFor();
  },

  /** With the keyboard only: at a node, its text is marked; zoom, fit; Enter goes to the text. */
  async keyboard({ editor, page }) {
    const frame = await editor.panel();
    await frame.locator('.stage').focus();
    await page.keyboard.press('Escape');
    const lines = [];
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown']) {
      await page.keyboard.press(key);
      const words = await frame.locator('.part-words').textContent();
      lines.push(words);
    }
    equal('a node at each step', new Set(lines).size, 3);
    const view = () => frame.locator('.stage svg').getAttribute('viewBox');
    await page.keyboard.press('0');
    const fitted = await view();
    await page.keyboard.press('+');
    await expect('a larger picture', async () => (await view()) !== fitted);
    await page.keyboard.press('0');
    await expect('the whole picture', async () => (await view()) === fitted);
    await frame.locator('.stage').press('/');
    await page.keyboard.type('shutdown_drone');
    await expect('its node', async () => (await frame.locator('.part-words').textContent()).includes('shutdown_drone'));
    await page.keyboard.press('Escape');
    await page.keyboard.press('Enter');
    await expect('the keyboard in the text', () => page.evaluate(() => !!document.activeElement?.closest('.monaco-editor')));
    const line = await caretLine(page);
    equal('the text at the caret', (await page.locator('.monaco-editor[data-uri$="drone.proskill"] .view-line', { hasText: '(shutdown_drone)' }).count()) > 0 && line > 0, true);
  },

  /** The picture as SVG, PNG and DOT, in files and the clipboard. */
  async copies(world) {
    const { editor, page } = world;
    const frame = await editor.panel();
    equal('SVG', /<svg[^]*landing/.test((await saved(world, frame, 'Save and copy', 'SVG', 'body_uav_mission.svg')).toString()), true);
    equal('PNG', (await saved(world, frame, 'Save and copy', 'PNG', 'body_uav_mission.png')).subarray(1, 4).toString(), 'PNG');
    equal('DOT', /^digraph[^]*landing/.test((await saved(world, frame, 'Save and copy', 'DOT', 'body_uav_mission.dot')).toString()), true);
    for (const [format, wanted] of [['SVG', /<svg[^]*landing/], ['DOT', /^digraph[^]*landing/]]) {
      await choose(frame, 'Save and copy', format, 'Copy');
      await expect(`${format} in the clipboard`, async () => wanted.test(await clipboard(page)));
    }
    await choose(frame, 'Save and copy', 'PNG', 'Copy');
    await expect('a PNG in the clipboard', () => page.evaluate(async () =>
      (await navigator.clipboard.read()).some((item) => item.types.includes('image/png'))));
  },

  /** Light and high contrast: the panel has the editor's colours. */
  async themes({ editor }) {
    const frame = await editor.panel();
    const ground = () => frame.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await ground();
    for (const [theme, kind, name] of [['Light Modern', 'vscode-light', 'light'], ['Dark High Contrast', 'vscode-high-contrast', 'contrast']]) {
      await editor.theme(theme);
      await frame.locator(`body.${kind}`).waitFor();
      await expect('other colours', async () => (await ground()) !== dark);
      await expect('a picture for this ground', () => frame.evaluate((wanted) =>
        document.documentElement.dataset.theme === wanted, name === 'light' ? 'light' : 'dark'));
      await expect('the picture', async () => (await nodes(frame)) > 10);
      await expect('a legend whose boxes differ', async () => (await legendLines(frame)) > 4);
      await editor.picture(`themes-${name}`);
    }
    await editor.theme('Dark Modern');
    await frame.locator('body.vscode-dark').waitFor();
    await editor.closeAll();
  },
};
