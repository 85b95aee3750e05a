// VS Code in the browser, used as by a person: through keys and what is visible.
import { expect } from './expect.mjs';

/**
 * A position in the empty middle of the status bar. If the mouse stays where it clicked, a list that opens later shows a hover over its own lines.
 */
const NOTHING_TO_HOVER = [720, 899];

export class Editor {
  constructor(page, pictures) {
    this.page = page;
    this.pictures = pictures;
    /** number of pictures so far */
    this.taken = 0;
  }

  /** Opens a folder, or the folders that a `.code-workspace` names. */
  async open(url, path) {
    const kind = path.endsWith('.code-workspace') ? 'workspace' : 'folder';
    await this.page.goto(`${url}/?${kind}=${encodeURIComponent(path)}`, { waitUntil: 'domcontentloaded', timeout: 60_000 });
    await this.page.waitForSelector('.monaco-workbench .statusbar-item', { timeout: 60_000 });
  }

  press(...keys) {
    return keys.reduce((before, key) => before.then(() => this.page.keyboard.press(key)), Promise.resolve());
  }

  type(text) {
    return this.page.keyboard.type(text);
  }

  quickInput() {
    return this.page.locator('.quick-input-widget:visible');
  }

  /**
   * Chooses a line that Ctrl+P or F1 offers, by its label. Repeats this if something has taken the focus, with a longer wait each time: on a busy
   * machine the list takes long.
   */
  async pick(key, text, row, after = ', ') {
    let patience = 1500;
    await expect(`${row} in the list of ${key}`, async () => {
      patience *= 2;
      await this.page.mouse.move(...NOTHING_TO_HOVER);
      await this.press('Escape', key);
      const input = this.quickInput().locator('input.input');
      await input.waitFor({ timeout: patience });
      await input.fill(text);
      const found = this.quickInput().locator(`.monaco-list-row[aria-label="${row}"], .monaco-list-row[aria-label^="${row}${after}"]`).first();
      await found.click({ timeout: 2 * patience });
      await found.waitFor({ state: 'hidden', timeout: patience });
      return true;
    }, 90_000);
  }

  /** Runs a command of the palette, by its full name. */
  command(title) {
    return this.pick('F1', `>${title}`, title);
  }

  /** Waits until the line with this name is the one that Enter takes. */
  async answer(name) {
    await this.quickInput().locator('input.input').fill(name);
    const row = this.quickInput().locator(`.monaco-list-row.focused[aria-label*="${name}"]`);
    await row.waitFor();
    await this.press('Enter');
    await row.waitFor({ state: 'hidden' });
  }

  /** Chooses a theme by its name. */
  async theme(name) {
    await this.command('Preferences: Color Theme');
    await this.answer(name);
  }

  async openFile(path) {
    const name = path.split('/').pop();
    await expect(`${path} in an editor`, async () => {
      const open = this.page.locator('.tab').filter({ hasText: name });
      if (await open.count()) await open.first().click();
      else await this.pick('Control+p', path, name, ' ');
      await this.tab(name).first().waitFor({ timeout: 10_000 });
      return true;
    }, 90_000);
    await this.page.locator(`.monaco-editor[data-uri$="${path}"] .view-line`).first().waitFor();
  }

  /** By keys, which take a tenth of the time that the palette takes. They are lost if what has the focus is just being closed. */
  async closeAll() {
    await expect('no open editor', async () => {
      if (!(await this.page.locator('.tab').count())) return true;
      await this.press('Escape', 'Control+k', 'Control+w');
      await this.page.locator('.tab').first().waitFor({ state: 'detached', timeout: 3000 });
      return false;
    });
  }

  /** Empties a text without a name, so that it can be closed without a question. */
  async emptyText() {
    await expect('an empty text', async () => {
      if (!(await this.page.locator('.tab.active.dirty').count())) return true;
      await this.press('Control+1', 'Escape', 'Control+a', 'Delete');
      return false;
    });
  }

  tab(name) {
    return this.page.locator('.tab.active').filter({ hasText: name });
  }

  /** Repeats this if something has taken the focus: what is typed next must not go elsewhere. */
  async goTo(line, column = 1) {
    let patience = 1500;
    await expect(`the caret in line ${line}`, async () => {
      patience *= 2;
      await this.press('Control+g');
      const input = this.quickInput().locator('input.input');
      await input.fill(`:${line}:${column}`, { timeout: patience });
      await input.press('Enter', { timeout: patience });
      await this.quickInput().waitFor({ state: 'hidden', timeout: patience });
      await this.page.locator('[id="status.editor.selection"]', { hasText: `Ln ${line},` }).waitFor({ timeout: patience });
      return true;
    });
  }

  /** Chooses an item of the menu that is open. A menu ignores clicks in its first 100 ms. */
  async choose(label) {
    const item = this.page.locator('.context-view .action-label', { hasText: label }).first();
    await item.waitFor();
    await expect(`"${label}" chosen`, async () => {
      if (await item.isVisible()) await item.click({ timeout: 1000 });
      await item.waitFor({ state: 'hidden', timeout: 1000 });
      return true;
    });
  }

  /** Where keys would go: for the message of a failure. */
  async focus() {
    const focused = await this.page.evaluate(() => document.activeElement?.closest('[data-uri], .quick-input-widget, .part, iframe')?.className);
    return `focus: ${focused ?? 'none'}, caret: ${await this.caret({ timeout: 1000 }).catch(() => 'none')}`;
  }

  /** Saves the text in the active group. Keys arrive before the tab shows that there is something to save. */
  async save() {
    await this.page.locator('.editor-group-container.active .tab.active.dirty').first().waitFor();
    await this.press('Control+s');
    await this.page.locator('.editor-group-container.active .tab.active:not(.dirty)').first().waitFor();
  }

  squiggles(kind = 'error') {
    return this.page.locator(`.squiggly-${kind}`);
  }

  /** On the line of the caret: elsewhere there may be verdicts. */
  squigglesHere(kind = 'error') {
    return this.page.locator(`.view-overlays > div:has(.current-line) .squiggly-${kind}`);
  }

  status() {
    return this.page.locator('[id="proskill.proskill.proskill.status"], [id$="proskill.status"]').first();
  }

  async statusSays(words, timeout = 40_000) {
    await this.status().filter({ hasText: words }).waitFor({ timeout });
  }

  async problems() {
    await this.press('Control+Shift+M');
    return this.page.locator('.markers-panel .monaco-list-row, .markers-panel-container .monaco-list-row');
  }

  /** The position of the caret, from the status bar. */
  async caret(options) {
    return (await this.page.locator('[id="status.editor.selection"]').textContent(options)).trim();
  }

  /** The lines with a decoration of this border or background, as numbered in the gutter. */
  markedLines(uriEnd) {
    return this.page.evaluate((end) => {
      const editor = [...document.querySelectorAll('.monaco-editor[data-uri]')].find((it) => it.dataset.uri.endsWith(end));
      if (!editor) return [];
      const lineOf = new Map([...editor.querySelectorAll('.margin-view-overlays > div')]
        .map((row) => [row.style.top, Number(row.querySelector('.line-numbers')?.textContent)]));
      return [...editor.querySelectorAll('.view-overlays > div')]
        .filter((row) => [...row.querySelectorAll('[class*="ced-"]')]
          .some((mark) => getComputedStyle(mark).borderTopStyle === 'solid' || getComputedStyle(mark).borderTopWidth !== '0px'))
        .map((row) => lineOf.get(row.style.top)).sort((a, b) => a - b);
    }, uriEnd);
  }

  /** The text that decorations add after lines. */
  inlineValues(uriEnd) {
    return this.page.evaluate((end) => {
      const editor = [...document.querySelectorAll('.monaco-editor[data-uri]')].find((it) => it.dataset.uri.endsWith(end));
      return [...(editor?.querySelectorAll('.view-line [class*="ced-"]') ?? [])]
        .map((mark) => getComputedStyle(mark, '::after').content).filter((text) => text && text !== 'none');
    }, uriEnd);
  }

  /** The frame of a panel; of the one with this view if there are several. */
  async panel(view = '.automaton-view, .trace-view', timeout = undefined) {
    return expect('a panel in a webview', async () => {
      for (const frame of this.page.frames())
        if (await frame.locator(view).count().catch(() => 0)) return frame;
      return undefined;
    }, timeout);
  }

  /** The frame with the trace of a property, at its first step. */
  async openTrace(property) {
    await this.command('ProSkill: Open Trace');
    await this.answer(property);
    const frame = await this.panel('.trace-view');
    await frame.locator('#step-0.current').waitFor();
    return frame;
  }

  async picture(name) {
    ++this.taken;
    await this.page.screenshot({ path: `${this.pictures}/${name}.png` });
  }
}
