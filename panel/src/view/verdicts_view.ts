import type { Program, Verdict } from '../api.ts';
import { h, plural, prose, setChildren } from './dom.ts';
import { icon, toggle, type Icon } from './icons.ts';

export type Mark = 'good' | 'error' | 'warning' | 'open';
export const markOf = (verdict: Verdict): Mark =>
  verdict.good ? 'good' : verdict.verdict === 'inconclusive' ? 'open' : verdict.severity;
const icons: { [M in Mark]: Icon } = { good: 'good', error: 'bad', warning: 'warning', open: 'open_question' };
const rank: { [M in Mark]: number } = { error: 0, warning: 1, open: 2, good: 3 };

/** All properties by subject; those with findings come first. */
export class VerdictsView {
  readonly element: HTMLElement;
  private readonly list = h('div', { class: 'scroll', role: 'listbox', 'aria-label': 'Properties', tabindex: -1 });
  private readonly summary = h('div', { class: 'summary', role: 'status' });
  private readonly field: HTMLInputElement;
  private readonly onlyBad;
  private readonly drawn = new Map<string, { look: string; element: HTMLElement }>();
  private readonly groups = new Map<string, { element: HTMLElement; name: HTMLElement }>();
  private readonly nothing = h('p', { class: 'nothing' });
  private program: Program | null = null;
  private current: string | null = null;

  constructor(private readonly choose: (verdict: Verdict, focus: boolean) => void) {
    this.field = h('input', { type: 'search', class: 'search', placeholder: 'Search properties', 'aria-label': 'Search properties', oninput: () => this.draw() });
    this.onlyBad = toggle({ text: 'Findings', title: 'Only properties that are not good', on: false, changed: () => this.draw() });
    this.element = h('nav', { class: 'verdicts', 'aria-label': 'Verdicts' }, this.summary,
      h('div', { class: 'bar' }, h('label', { class: 'search-frame' }, icon('search'), this.field), this.onlyBad.element), this.list);
    this.list.addEventListener('keydown', (event) => this.key(event));
  }

  /** The focused element keeps the focus. */
  show(program: Program): void {
    const isSame = program.verdicts === this.program?.verdicts;
    if (isSame) {
      this.program = program;
      return this.drawSummary(program);
    }
    const focused = this.list.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset['name'] : undefined;
    this.program = program;
    this.draw();
    if (focused !== undefined) this.options().find((option) => option.dataset['name'] === focused)?.focus({ preventScroll: true });
  }

  select(name: string | null): void {
    this.current = name;
    for (const option of this.options()) markSelected(option, option.dataset['name'] === name);
  }

  private draw(): void {
    if (!this.program) return;
    this.drawSummary(this.program);
    const needle = this.field.value.trim().toLowerCase();
    const shown = this.program.verdicts.filter((verdict) =>
      (!this.onlyBad.on || !verdict.good) && `${verdict.name} ${verdict.description}`.toLowerCase().includes(needle));
    const subjects = new Map<string, Verdict[]>();
    for (const verdict of shown) subjects.set(verdict.subject, [...(subjects.get(verdict.subject) ?? []), verdict]);
    const worst = (list: Verdict[]): number => Math.min(...list.map((verdict) => rank[markOf(verdict)]));
    const sorted = [...subjects].sort((a, b) => worst(a[1]) - worst(b[1]));
    this.nothing.textContent = this.program.verdicts.length === 0 ? 'No verdicts yet.' : 'No property is like this.';
    setChildren(this.list, shown.length === 0 ? [this.nothing] : sorted.map(([subject, list]) => this.section(subject, list)));
    const options = this.options();
    this.reach(options, options.find((option) => option.dataset['name'] === this.current) ?? options[0]);
  }

  /** The option that the Tab key reaches. */
  private reach(options: HTMLElement[], reached: HTMLElement | undefined): void {
    for (const it of options) if (it.tabIndex !== (it === reached ? 0 : -1)) it.tabIndex = it === reached ? 0 : -1;
  }

  private section(subject: string, list: Verdict[]): HTMLElement {
    const sorted = [...list].sort((a, b) => rank[markOf(a)] - rank[markOf(b)]);
    const group = this.groups.get(subject) ?? groupOf(subject || 'the program');
    this.groups.set(subject, group);
    setChildren(group.element, [group.name, ...sorted.map((verdict) => this.option(verdict))]);
    return group.element;
  }

  /** The former element if it would look the same: a large program has thousands, and most verdicts stay. */
  private option(verdict: Verdict): HTMLElement {
    const look = JSON.stringify({ ...verdict, location: null });
    const former = this.drawn.get(verdict.name);
    const element = former?.look === look ? former.element : this.newOption(verdict);
    markSelected(element, verdict.name === this.current);
    this.drawn.set(verdict.name, { look, element });
    return element;
  }

  private newOption(verdict: Verdict): HTMLElement {
    const kind = markOf(verdict);
    return h('div', {
      class: `verdict ${kind}`, role: 'option', tabindex: -1, 'data-name': verdict.name,
      title: `${verdict.name}: ${verdict.verdict}${verdict.reason ? `\n${verdict.reason}` : ''}`, onclick: () => this.pickNamed(verdict.name, false),
    }, h('span', { class: 'mark' }, icon(icons[kind])), h('span', { class: 'words' }, prose(shortWords(verdict))),
    h('span', { class: 'sr-only' }, `, ${verdict.verdict}`), verdict.steps !== null && h('span', { class: 'steps-count', title: plural(verdict.steps, 'step') }, String(verdict.steps)));
  }

  private drawSummary(program: Program): void {
    const count = (mark: Mark): number => program.verdicts.filter((verdict) => markOf(verdict) === mark).length;
    const part = (mark: Mark, words: string): HTMLElement | null => {
      const number = count(mark);
      return number === 0 ? null : h('span', { class: `tally ${mark}`, title: `${number.toLocaleString('en')} ${words}` }, icon(icons[mark]), String(number));
    };
    const parts = [part('error', 'bad'), part('warning', count('warning') === 1 ? 'warning' : 'warnings'), part('open', 'inconclusive'), part('good', 'good')];
    this.summary.replaceChildren(...parts.filter((it): it is HTMLElement => it !== null));
    this.summary.classList.toggle('stale', program.stale);
  }

  private options(): HTMLElement[] {
    return [...this.list.querySelectorAll<HTMLElement>('.verdict')];
  }

  private pickNamed(name: string | undefined, focus: boolean): void {
    const verdict = this.program?.verdicts.find((it) => it.name === name);
    if (!verdict) return;
    this.select(verdict.name);
    this.choose(verdict, focus);
  }

  private key(event: KeyboardEvent): void {
    const all = this.options();
    const at = all.indexOf(document.activeElement as HTMLElement);
    const to = { ArrowDown: at + 1, j: at + 1, ArrowUp: at - 1, k: at - 1, Home: 0, End: all.length - 1 }[event.key];
    if (to !== undefined) {
      const option = all[Math.min(Math.max(to, 0), all.length - 1)];
      this.reach(all, option);
      option?.focus();
    } else if (event.key === 'Enter' || event.key === ' ') {
      this.pickNamed(all[at]?.dataset['name'], event.key === 'Enter');
    } else return;
    event.preventDefault();
  }
}

function groupOf(subject: string): { element: HTMLElement; name: HTMLElement } {
  return { element: h('div', { role: 'group', 'aria-label': subject, class: 'subject' }), name: h('div', { class: 'subject-name' }, subject) };
}

function markSelected(option: HTMLElement, isSelected: boolean): void {
  if (option.getAttribute('aria-selected') !== String(isSelected)) option.setAttribute('aria-selected', String(isSelected));
}

/** Without the subject's name at the beginning, which is shown above. */
function shortWords(verdict: Verdict): string {
  const start = `\`${verdict.subject}\` `;
  return verdict.description.startsWith(start) ? verdict.description.slice(start.length) : verdict.description;
}
