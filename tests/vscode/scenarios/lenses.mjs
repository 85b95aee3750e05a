// Lenses that were out of view while the server listed them again.
import { rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

/** With an error: nothing is verified, so no verdict brings new lenses. */
const kUsed = `(defsv lamp :states (On Off) :init Off :transitions :all)
(defproperty dark (always (lamp Off)))
(defproperty light (always (lamp On)))
(defproperty wrong)
`;
const kFile = 'drone/drone.proskill';
const kText = `.monaco-editor[data-uri$="${kFile}"]`;

/** The middle of a lens, once it does not move any more. */
async function middleOf(lens) {
  let last;
  return expect('a lens that stays where it is', async () => {
    const { x, y, width, height } = await lens.boundingBox();
    const before = last;
    last = [Math.round(x + width / 2), Math.round(y + height / 2)];
    return before && String(before) === String(last) ? last : undefined;
  });
}

const messages = (page) => page.locator('.notifications-toasts .notification-list-item-message');

/** Verifies the program again, far below the first definitions, and waits for the new lenses there. */
async function listAgain(editor, page) {
  const ids = () => page.locator(`${kText} .codelens-decoration a`).evaluateAll((all) => all.map(({ id }) => id));
  await editor.press('Control+End');
  await page.locator(`${kText} .codelens-decoration a:visible`, { hasText: 'verify' }).first().waitFor();
  const before = new Set(await ids());
  await editor.type(';');
  await expect('new lenses', async () => (await ids()).some((id) => !before.has(id)));
}

/** Clicks as soon as there is a lens. */
async function clickLensAt(page, [x, y]) {
  await page.waitForFunction((at) => document.elementFromPoint(...at)?.matches('.codelens-decoration a'), [x, y], { polling: 'raf' });
  await page.mouse.click(x, y);
}

export const scenarios = {
  /** A click on a lens right after it has scrolled back into view, when VS Code still shows the lens of an older list. */
  async old_lens({ editor, page }) {
    await editor.closeAll();
    await editor.openFile(kFile);
    await editor.statusSays(/\d+ bad, \d+ warnings?$/, 60_000);
    await editor.goTo(1);
    for (const [title, view] of [['show automaton', '.automaton-view'], ['reference', undefined]]) {
      await editor.press('Control+Home');
      const lens = page.locator(`${kText} .codelens-decoration a`, { hasText: title }).first();
      const place = await middleOf(lens);
      await listAgain(editor, page);
      await editor.press('Control+Home');
      await clickLensAt(page, place);
      if (view) await editor.panel(view);
      else await page.locator('.peekview-widget').first().waitFor();
      equal('messages', await messages(page).allTextContents(), []);
      await editor.press('Control+1', 'Escape');
    }
    await editor.command('File: Revert File');
    await editor.closeAll();
  },

  /**
   * The focus leaves the text right after an edit, and right after the text was opened. VS Code then drops the request for lenses that it was about to
   * make.
   */
  async dropped_lenses({ editor, page, root }) {
    const path = join(root, 'lift/left.proskill');
    writeFileSync(path, kUsed);
    await editor.closeAll();
    await editor.openFile('lift/left.proskill');
    const lens = (text) => page.locator('.monaco-editor[data-uri$="left.proskill"] .codelens-decoration a', { hasText: text }).first();
    await lens(/^2 references$/).waitFor();
    await lens(/verify/).waitFor();
    await editor.goTo(kUsed.split('\n').length);
    await page.keyboard.insertText('(defproperty more (always (lamp Off)))');
    await editor.press('Control+Shift+M');
    await lens(/^3 references$/).waitFor();
    await editor.press('Control+j'); // hides the problems
    await page.locator('.markers-panel-container, .markers-panel').first().waitFor({ state: 'hidden' });
    await editor.press('Control+1');
    await editor.command('File: Revert File');
    await lens(/^2 references$/).waitFor();
    await editor.command('View: Close Editor');
    rmSync(path);
  },
};
