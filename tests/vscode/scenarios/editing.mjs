import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

/** Milliseconds from the last key of an error to its squiggle, as the browser measures them. */
async function typeAndWait(page, key) {
  await page.evaluate(() => {
    window.seen = new Promise((resolve) => {
      let pressed = 0;
      window.addEventListener('keydown', () => (pressed = performance.now()), { capture: true, once: true });
      const look = new MutationObserver(() => {
        if (!pressed || !document.querySelector('.squiggly-error')) return;
        look.disconnect();
        resolve(performance.now() - pressed);
      });
      look.observe(document.body, { subtree: true, childList: true, attributes: true, attributeFilter: ['class'] });
    });
  });
  await page.keyboard.press(key);
  return page.evaluate(() => window.seen);
}

/** Verdicts on the unchanged text. */
const kVerified = /\d+ (bad|warnings?|of \d+ good)(?!.*outdated)/;

export const scenarios = {
  /** `Controlled` becomes `Controlledx`, far from bad verdicts; its problem appears, and disappears when it is undone. */
  async mistake({ editor, page }) {
    await editor.openFile('drone/drone.proskill');
    await editor.goTo(114, 28);
    await editor.squiggles().first().waitFor({ state: 'detached' });
    const times = [];
    for (let i = 0; i < 8; ++i) {
      await editor.goTo(114, 28);
      times.push(await typeAndWait(page, 'x'));
      if (i === 0) {
        const problems = await editor.problems();
        await problems.filter({ hasText: 'Controlledx' }).first().waitFor();
        await editor.picture('mistake-shown');
        await editor.press('Control+Shift+M', 'Control+1');
      }
      await editor.press('Control+z');
      await editor.squiggles().first().waitFor({ state: 'detached' });
    }
    times.sort((a, b) => a - b);
    console.log(`        from the key to the squiggle: median ${times[4].toFixed(0)} ms, slowest ${times.at(-1).toFixed(0)} ms`);
  },

  /** A condition that is being typed is completed with the values of its variable. */
  async completion({ editor, page }) {
    await editor.openFile('drone/drone.proskill');
    await editor.goTo(30, 9);
    await editor.press('Shift+End', 'Delete');
    await page.locator('.view-line', { hasText: /^\s*:init\s*$/ }).first().waitFor();
    await editor.press('Control+Space');
    const list = page.locator('.suggest-widget.visible .monaco-list-row');
    await list.filter({ hasText: 'Controlled' }).first().waitFor();
    await list.filter({ hasText: 'Free' }).first().waitFor();
    await editor.picture('completion-list');
    await editor.type('Con');
    await list.filter({ hasText: 'Free' }).first().waitFor({ state: 'detached' });
    await editor.press('Enter');
    await page.locator('.view-line', { hasText: ':init Controlled' }).first().waitFor();
    await expect('the text as it was', async () => {
      await editor.press('Control+z');
      return !(await page.locator('.tab.active.dirty').count());
    });
  },

  /** A tag that is edited in all its places is not an error, and does not look like one. The explanation of a code opens beside the text. */
  async explained({ editor, page }) {
    await editor.openFile('drone/drone.proskill');
    const linked = page.locator('.linked-editing-decoration').first();
    const [red, green, blue] = await expect('a place of linked editing', async () => {
      await editor.goTo(1); // the editor asks for the places when the caret moves
      await editor.goTo(84, 16);
      // while the line is drawn again, the element has no colour
      return (await linked.evaluate((it) => getComputedStyle(it).backgroundColor, null, { timeout: 5000 })).match(/[\d.]+/g)?.map(Number);
    });
    equal('a place of linked editing as red', red > green && red > blue, false);
    await editor.goTo(114, 28);
    await editor.type('x');
    await editor.squigglesHere().first().waitFor();
    await editor.press('Control+.');
    await page.locator('.action-widget .monaco-list-row.focused').first().waitFor();
    await editor.press('ArrowDown', 'Enter'); // after the fixes
    await expect('the page on the code beside the text', async () => {
      for (const frame of page.frames())
        if (await frame.locator('.markdown-body, body.vscode-body h1', { hasText: /PS\d+/ }).count().catch(() => 0)) return true;
      return false;
    });
    await editor.picture('explained-beside');
    equal('messages', await page.locator('.notification-toast').count(), 0);
    await editor.press('Control+1', 'Control+z');
    await editor.squiggles().first().waitFor({ state: 'detached' });
    await editor.closeAll();
  },

  /** Half of an emoji comes from a snippet: the server asks for the whole text, and has it again with the next edit. */
  async half_a_character({ editor, page, root }) {
    const file = 'lift/half.proskill';
    const text = '; x\n(defsv lamp :states (On Off) :init Off)\n(defskill m :body ((set (lamp On))))\n(defproperty dark (always (lamp Off)))\n';
    writeFileSync(join(root, file), text);
    writeFileSync(join(root, '.vscode/halves.code-snippets'), JSON.stringify({ half: { prefix: 'half', body: '\ud83d' } }));
    await editor.closeAll();
    await editor.openFile(file);
    await editor.statusSays(/1 bad/, 60_000);
    await editor.goTo(1, 3);
    await editor.command('Snippets: Insert Snippet');
    await editor.answer('half');
    await editor.squigglesHere().first().waitFor();
    await editor.statusSays(/1 bad \(outdated\)/); // until the server knows the text again
    await editor.type('a');
    await editor.squigglesHere().first().waitFor({ state: 'detached' });
    await editor.goTo(2, 32);
    await editor.type('x');
    await editor.squigglesHere().first().waitFor(); // at the place where it is
    await editor.press('Backspace');
    await editor.squigglesHere().first().waitFor({ state: 'detached' });
    await editor.statusSays(/1 bad(?!.*outdated)/);
    equal('messages other than about the half', await page.locator('.notification-toast').filter({ hasNotText: 'half a character' }).count(), 0);
    await editor.command('Notifications: Clear All Notifications');
    await editor.command('File: Revert File');
    await editor.closeAll();
    for (const name of [file, '.vscode/halves.code-snippets']) rmSync(join(root, name));
  },

  /** `energy` is defined in one file of the rover and used in others. */
  async rename({ editor, page, root }) {
    const world = join(root, 'rover/world.proskill');
    const line = readFileSync(world, 'utf8').split('\n').findIndex((it) => it.startsWith('(defsv energy')) + 1;
    await editor.openFile('rover/world.proskill');
    await editor.goTo(line, 9);
    await editor.press('F2');
    const input = page.locator('.rename-box input');
    await input.waitFor();
    await input.fill('charge_left');
    await editor.press('Enter');
    await page.locator('.view-line', { hasText: 'charge_left' }).first().waitFor();
    await editor.command('File: Save All Files');
    await expect('the new name in both files', () => ['world', 'mission']
      .every((name) => readFileSync(join(root, `rover/${name}.proskill`), 'utf8').includes('charge_left')));
    await editor.statusSays(kVerified, 60_000); // although files were opened and closed again that the user did not see
    for (const name of ['world', 'skills', 'mission', 'rover'])
      equal(`the old name in ${name}`, /\(energy |\benergy\)/.test(readFileSync(join(root, `rover/${name}.proskill`), 'utf8')), false);
  },

  /** Opens only a file that others include: after a restart the status is that of its program. */
  async restarted({ editor, server }) {
    await editor.closeAll();
    await editor.openFile('rover/world.proskill');
    await editor.statusSays(kVerified, 60_000);
    const before = server.servers().map(({ pid }) => pid);
    await editor.command('ProSkill: Restart the Server');
    await expect('another server', () => server.servers().some(({ pid }) => !before.includes(pid)));
    await editor.goTo(1);
    await editor.type('x');
    await editor.statusSays(/error/); // it is the status that the new server says
    await editor.press('Control+z');
    await editor.statusSays(kVerified, 60_000);
  },

  /** A Fiacre model: colours, comments, an error, and a hover. */
  async models({ editor, page }) {
    await editor.openFile('fiacre/fischer.fcr');
    await page.locator('.view-line span[class^="mtk"]', { hasText: /^process$/ }).first().waitFor();
    await editor.goTo(1);
    await editor.press('Control+Home', 'Control+/');
    await page.locator('.view-line').first().filter({ hasNotText: '//' }).waitFor();
    await editor.squiggles().first().waitFor();
    await editor.picture('models-mistake');
    await editor.press('Control+z');
    await editor.squiggles().first().waitFor({ state: 'detached' });
    await editor.command('View: Close Editor');
  },

  /** The server is killed: it restarts, and its problems return. */
  async killed({ editor, server }) {
    await editor.openFile('drone/drone.proskill');
    const { pid } = server.servers().find(({ args }) => args[0] === 'lsp');
    process.kill(pid, 'SIGKILL');
    await expect('another server', () => server.servers().some((it) => it.pid !== pid && it.args[0] === 'lsp'));
    await editor.goTo(30, 13);
    await editor.type('x');
    await editor.squigglesHere().first().waitFor();
    await editor.press('Control+z');
    await editor.squigglesHere().first().waitFor({ state: 'detached' });
  },

  /** After repeated crashes it is given up, and a message says what to do; on request, it starts again. */
  async givenUp({ editor, page, server }) {
    const crashed = editor.status().filter({ hasText: 'crashed' });
    for (let kills = 0; !(await crashed.count()); ++kills) {
      equal('killed too often', kills > 6, false);
      const pid = await expect('a server, or that there is none', async () =>
        server.servers().find(({ args }) => args[0] === 'lsp')?.pid ?? ((await crashed.count()) && -1));
      if (pid < 0) break;
      process.kill(pid, 'SIGKILL');
      await expect('its end', () => !server.servers().some((it) => it.pid === pid));
    }
    await editor.statusSays('crashed');
    equal('servers', server.servers().length, 0);
    await editor.command('Notifications: Show Notifications');
    const messages = page.locator('.notifications-center .notification-list-item');
    await messages.filter({ hasText: 'more than five times' }).first().waitFor();
    equal('messages, and none of the library that knows the protocol', await messages.count(), 1);
    await editor.picture('givenUp-message');
    await page.locator('.notification-list-item .monaco-button', { hasText: 'Start it again' }).click();
    await expect('a server', () => server.servers().length === 1);
  },
};
