// A person who types comments into a program, with a pause now and then, and the time from each key to its display.
import { expect } from '../expect.mjs';

const kWords = 'what a person types while the program is verified again and again stays where it was typed'.split(' ');
const kWordsALine = 12;

const part = (sorted, at) => sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * at))];

/** Types below a line of an editor's text. */
export class Typist {
  typed = '';
  /** how often the caret was in a wrong position */
  moved = 0;
  /** milliseconds spent typing */
  spent = 0;
  words = 0;

  constructor(editor, file, line) {
    this.editor = editor;
    this.page = editor.page;
    this.file = file;
    this.line = line;
  }

  async begin() {
    await this.editor.goTo(this.line);
    await this.watch();
  }

  /** Milliseconds from each key to the mutation that shows it, within the painted frame; one mutation can show several keys. */
  watch() {
    return this.page.evaluate((end) => {
      const editor = [...document.querySelectorAll('.monaco-editor[data-uri]')].find((it) => it.dataset.uri.endsWith(end));
      let pressed = [];
      window.keyTimes = [];
      addEventListener('keydown', (event) => pressed.push(event.timeStamp), true);
      new MutationObserver(() => {
        const now = performance.now();
        for (const time of pressed) {
          window.keyTimes.push(now - time);
          performance.mark('key', { startTime: time });
        }
        if (pressed.length) performance.mark('shown', { startTime: now });
        pressed = [];
      }).observe(editor.querySelector('.view-lines'), { subtree: true, childList: true, characterData: true });
    }, this.file);
  }

  /** One line of a comment. */
  async typeLine() {
    const begin = Date.now();
    do await this.typeWord();
    while (this.words % kWordsALine);
    this.spent += Date.now() - begin;
  }

  async typeWord() {
    const begins = this.words % kWordsALine === 0;
    // no blank before Enter, which removes it
    const word = `${begins ? `${this.words ? '\n' : ''};` : ''} ${kWords[this.words % kWords.length]}`;
    for (const key of word) await (key === '\n' ? this.editor.press('Enter') : this.editor.type(key));
    this.typed += word;
    await this.page.waitForTimeout(this.words % 4 === 3 ? 900 : 60); // a pause starts a verification
    ++this.words;
    await this.checkCaret();
  }

  async checkCaret() {
    const last = this.typed.split('\n');
    const wanted = `Ln ${this.line + last.length - 1}, Col ${last.at(-1).length + 1}`;
    if ((await this.editor.caret()) === wanted) return;
    // the status bar is updated a little later than the text
    await expect('the caret', async () => (await this.editor.caret()) === wanted, 3000).catch(() => { ++this.moved; });
  }

  /** Of all keys: their number, and times in milliseconds. */
  async times() {
    const sorted = (await this.page.evaluate(() => window.keyTimes)).sort((a, b) => a - b);
    return { keys: sorted.length, p50: part(sorted, 0.5), p95: part(sorted, 0.95), most: sorted.at(-1) };
  }
}
