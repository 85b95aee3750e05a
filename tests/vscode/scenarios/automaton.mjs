import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

/** The line, from 1, of the first occurrence. */
const lineOf = (root, path, text) =>
  readFileSync(join(root, path), 'utf8').split('\n').findIndex((line) => line.includes(text)) + 1;

const node = (frame, label) => frame.locator('svg g.node').filter({ hasText: label });

/** The label of the node with the ring for the caret. */
const underCaret = (frame) => frame.evaluate(() => {
  const ring = document.querySelector('.rings .caret')?.getBoundingClientRect();
  if (!ring) return undefined;
  const inside = [...document.querySelectorAll('svg g.node')].find((group) => {
    const box = group.getBoundingClientRect();
    return box.left >= ring.left - 1 && box.right <= ring.right + 1 && box.top >= ring.top - 1 && box.bottom <= ring.bottom + 1;
  });
  return inside?.textContent.replace(/\s+/g, ' ').trim();
});

export const scenarios = {
  /** The picture of the mission is beside its text. */
  async automaton({ editor, root }) {
    await editor.openFile('drone/drone.proskill');
    await editor.goTo(lineOf(root, 'drone/drone.proskill', '((start_drone)'), 8);
    await editor.command('ProSkill: Show Automaton');
    const frame = await editor.panel();
    await node(frame, 'landing').first().waitFor();
    await editor.picture('automaton-shown');
  },

  /** The node at the caret is the one with the ring. */
  async follow({ editor, root }) {
    await editor.page.keyboard.press('Control+1');
    const frame = await editor.panel();
    for (const skill of ['takeoff', 'landing']) {
      await editor.goTo(lineOf(root, 'drone/drone.proskill', skill === 'takeoff' ? '(takeoff height' : '           (landing)'), 14);
      await expect(`the ring around ${skill}`, async () => (await underCaret(frame))?.includes(skill));
    }
  },

  /** A click on a node goes to its line. */
  async click({ editor, root, page }) {
    const frame = await editor.panel();
    await node(frame, 'start_drone').first().click();
    const line = lineOf(root, 'drone/drone.proskill', '((start_drone)');
    await expect(`the caret in line ${line}`, async () =>
      (await page.locator('.line-numbers.active-line-number').first().textContent()) === String(line));
  },

  /** The picture follows the text; while the text has errors, the last valid picture stays. */
  async live({ editor, page, root }) {
    const frame = await editor.panel();
    const line = lineOf(root, 'drone/drone.proskill', '((start_drone)');
    const before = await node(frame, '').count();
    await page.keyboard.press('Control+1');
    await editor.goTo(line, 19);
    await editor.press('Enter');
    await editor.type('(shutdown_drone)');
    await expect('two calls of shutdown_drone', async () => (await node(frame, 'shutdown_drone').count()) >= 2);
    await editor.type('(if (=');
    await frame.locator('.automaton-view .notice:not([hidden])').first().waitFor();
    equal('the picture is still there', (await node(frame, 'landing').count()) > 0, true);
    // The picture is of the previous text, but still marks the node at the caret.
    await editor.goTo(lineOf(root, 'drone/drone.proskill', '           (landing)') + 1, 14);
    await expect('the ring around landing, though lines have moved', async () => (await underCaret(frame))?.includes('landing'));
    await editor.picture('live-broken');
    await expect('the text as it was', async () => {
      await editor.press('Control+z');
      return !(await page.locator('.tab.dirty').count());
    });
    await expect('the picture as it was', async () => (await node(frame, '').count()) === before
      && (await node(frame, 'shutdown_drone').count()) === 1 && !(await frame.locator('.automaton-view.stale').count()));
  },
};
