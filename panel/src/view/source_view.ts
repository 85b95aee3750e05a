import type { Host, Live, Location, Program, Range, Told } from '../api.ts';
import { movedLines } from '../model/compare.ts';
import { highlight } from '../model/highlight.ts';
import { Rows } from '../model/virtual.ts';
import { h, onceAFrame } from './dom.ts';

const lineHeight = 20;

interface Source {
  text: string;
  verified?: string;
}

/** The program's text beside the views, with the current range marked. */
export class SourceView {
  readonly element: HTMLElement;
  private readonly files = h('select', { class: 'files', 'aria-label': 'File', onchange: () => void this.open(this.files.value) });
  private readonly space = h('div', { class: 'source-space' });
  private readonly scroller: HTMLElement;
  private readonly texts = new Map<string, Promise<Source>>();
  private lines: ReturnType<typeof highlight> = [];
  private rows = new Rows([]);
  private uri: string | null = null;
  private marked: Location | null = null;
  /** the marked place is one in the text that was verified */
  private isOld = false;
  /** where the lines of that text are; null: it is the text that is shown */
  private moved: Map<number, number> | null = null;
  /** of a run that is watched: lines where something runs, and what `printf` has printed */
  private live: Live = { active: [], messages: [] };
  /** the file to show; late answers for another are ignored */
  private wanted: string | null = null;
  private readonly draw = onceAFrame(() => this.drawNow());

  constructor(private readonly host: Host, private readonly caret: (location: Location) => void) {
    this.scroller = h('div', { class: 'scroll source-text', tabindex: 0, role: 'region', 'aria-label': 'Source text', onscroll: () => this.draw(), onclick: (event: MouseEvent) => this.click(event) }, this.space);
    this.element = h('aside', { class: 'source', 'aria-label': 'Source' }, h('div', { class: 'bar' }, this.files), this.scroller);
    new ResizeObserver(() => this.draw()).observe(this.scroller);
  }

  /** The list of files; texts are read again. The scroll position stays. */
  async setProgram(program: Program): Promise<void> {
    this.texts.clear();
    const before = this.wanted;
    this.files.replaceChildren(...program.files.map((file) => h('option', { value: file.uri }, file.label)));
    const first = program.files.some((file) => file.uri === before) ? before : program.files[0]?.uri;
    if (first) await this.load(first);
  }

  /** Marks a range of the text that was verified, without scrolling, if the view does not follow. */
  mark(location: Location | null): void {
    this.marked = location;
    this.isOld = true;
    this.drawNow();
  }

  /** Lets the lines shine where a run is, and shows its messages at their lines. */
  shine(live: Live): void {
    this.live = live;
    this.drawNow();
  }

  /** `isOld`: it is a place in the text that was verified. */
  async reveal({ location, focus }: Told['reveal'], isOld: boolean): Promise<void> {
    this.marked = location;
    this.isOld = isOld;
    await this.open(location.uri);
    if (this.marked !== location || this.uri !== location.uri) return; // something else was requested meanwhile
    const rows = this.rows;
    const { start, end } = this.range() ?? location.range;
    const last = Math.min(end.line, rows.count - 1);
    if (start.line < rows.count) {
      const margin = 4 * lineHeight;
      const bottom = rows.reveal(last, this.scroller.scrollTop, this.scroller.clientHeight, margin);
      this.scroller.scrollTop = rows.reveal(start.line, bottom, this.scroller.clientHeight, margin);
    }
    this.drawNow();
    if (focus) this.scroller.focus({ preventScroll: true });
  }

  private async open(uri: string): Promise<void> {
    if (uri !== this.uri || uri !== this.wanted) await this.load(uri);
  }

  private async load(uri: string): Promise<void> {
    this.wanted = uri;
    const { text, verified } = await this.textOf(uri);
    if (this.wanted !== uri) return;
    const isOther = this.uri !== uri;
    this.uri = uri;
    this.files.value = uri;
    this.lines = highlight(text);
    this.moved = verified === undefined ? null : movedLines(verified, text);
    this.rows = new Rows(new Float64Array(this.lines.length).fill(lineHeight));
    this.space.style.height = `${this.rows.height}px`;
    if (isOther) this.scroller.scrollTop = 0;
    this.drawNow();
  }

  private async textOf(uri: string): Promise<Source> {
    if (!this.texts.has(uri)) this.texts.set(uri, this.host.request('source', { uri }));
    const asked = this.texts.get(uri)!;
    try {
      return await asked;
    } catch (error) {
      if (this.texts.get(uri) === asked) this.texts.delete(uri);
      return { text: `; ${(error as Error).message}` };
    }
  }

  private drawNow(): void {
    const [first, last] = this.rows.visible(this.scroller.scrollTop, this.scroller.clientHeight || 600, 200);
    const out: HTMLElement[] = [];
    for (let at = first; at < last; ++at) {
      const line = h('div', { class: `line${this.isMarked(at) ? ' marked-line' : ''}${this.isActive(at) ? ' active-line' : ''}`, 'data-line': at },
        h('span', { class: 'line-number', 'aria-hidden': 'true' }, String(at + 1)), this.lineText(at), this.messageAt(at));
      line.style.transform = `translateY(${this.rows.top(at)}px)`;
      out.push(line);
    }
    this.space.replaceChildren(...out);
  }

  private isActive(line: number): boolean {
    return this.live.active.some(({ uri, range }) => uri === this.uri && range.start.line === line);
  }

  private messageAt(line: number): HTMLElement | null {
    const found = this.live.messages.find(({ location: { uri, range } }) => uri === this.uri && range.start.line === line);
    return found ? h('span', { class: 'message' }, found.text, found.count > 1 && h('span', { class: 'faint' }, ` ×${found.count}`)) : null;
  }

  private isMarked(line: number): boolean {
    const range = this.range();
    return !!range && line >= range.start.line && line <= range.end.line;
  }

  /** The marked part of the text that is shown, unless it was removed. */
  private range(): Range | null {
    if (this.marked?.uri !== this.uri) return null;
    const { start, end } = this.marked!.range;
    if (!this.isOld || !this.moved) return { start, end };
    const [first, last] = [this.moved.get(start.line), this.moved.get(end.line)];
    return first === undefined || last === undefined ? null : { start: { ...start, line: first }, end: { ...end, line: last } };
  }

  /** Coloured tokens, split at the ends of the marked range. */
  private lineText(at: number): HTMLElement {
    const tokens = this.lines[at] ?? [];
    const range = this.isMarked(at) ? this.range() : null;
    const indent = (tokens[0]?.text.match(/^\s*/)?.[0] ?? '').length;
    const from = range && range.start.line === at ? range.start.character : indent;
    const to = range && range.end.line === at ? range.end.character : Infinity;
    const code = h('span', { class: 'code' });
    let column = 0;
    for (const token of tokens) {
      // columns count characters, some of which are two units of a JavaScript string
      const characters = [...token.text];
      const cut = (begin: number, end: number): string => characters.slice(Math.max(begin - column, 0), Math.max(end - column, 0)).join('');
      const add = (text: string, marked: boolean): void => {
        if (text === '') return;
        const kind = token.kind === 'plain' ? '' : `t-${token.kind}`;
        code.append(kind || marked ? h('span', { class: `${kind}${marked ? ' marked' : ''}`.trim() }, text) : text);
      };
      if (!range) add(token.text, false);
      else {
        add(cut(column, from), false);
        add(cut(Math.max(from, column), to), true);
        add(cut(Math.max(to, column), Infinity), false);
      }
      column += characters.length;
    }
    return code;
  }

  /** A click sets the caret, and the automaton follows. */
  private click(event: MouseEvent): void {
    const line = Number((event.target as Element).closest('[data-line]')?.getAttribute('data-line') ?? NaN);
    if (Number.isNaN(line) || !this.uri || !getSelection()?.isCollapsed) return;
    const start = (event.target as Element).closest('.code');
    const range = document.createRange();
    let character = 0;
    const selection = getSelection();
    if (start && selection?.anchorNode && start.contains(selection.anchorNode)) {
      range.setStart(start, 0);
      range.setEnd(selection.anchorNode, selection.anchorOffset);
      character = [...range.toString()].length;
    }
    const at = { line, character };
    this.caret({ uri: this.uri, range: { start: at, end: at } });
  }
}
