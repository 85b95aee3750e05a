import type { Host, Location, Picture, PictureKind, PictureName, Program } from '../api.ts';
import type { ActorColours } from '../model/colours.ts';
import { fileName } from '../model/export.ts';
import type { Active } from '../model/active.ts';
import { activeParts, find, neighbour, partAt, partsOf, skillAt, type Box, type Part } from '../model/picture.ts';
import { foot, h, isTyping } from './dom.ts';
import { button, icon, toggle } from './icons.ts';
import { menu, type Section } from './menu.ts';
import { toPng, type Saver } from './save.ts';
import { readSvg, Stage } from './stage.ts';
import { isDark } from './theme.ts';

const kinds: { [K in PictureKind]: string } = { calls: 'Program', body: 'Bodies', skill: 'Skills', sv: 'State variables' };

/** A picture of a skill, a body, a state variable or the calls, linked to the source in both directions. */
export class AutomatonView {
  readonly element: HTMLElement;
  private readonly stage: Stage;
  private readonly chooser = h('select', { class: 'pictures', 'aria-label': 'Picture', onchange: () => this.chosen() });
  private readonly notice = h('div', { class: 'notice', role: 'status', hidden: true });
  private readonly words = h('div', { class: 'part-words faint', 'aria-live': 'polite' });
  private readonly field: HTMLInputElement;
  private readonly follow;
  private readonly forbidden;
  private readonly foldMenu: HTMLElement;
  private wanted: { kind: PictureKind; name: string } | null = null;
  private picture: Picture | null = null;
  private parts = new Map<string, Part>();
  private boxes = new Map<string, Box>();
  private fold: string[] | undefined;
  private selected: string | null = null;
  private caret: Location | null = null;
  private found: string[] = [];
  private pictures: PictureName[] = [];
  /** counts requests, so that a late answer does not replace a newer one */
  private asked = 0;
  /** places of possible steps, by the parts that show them */
  private offers: { places: readonly (Location | null)[]; taken: (indices: number[]) => void } | null = null;
  private offered = new Map<string, number[]>();
  /** current states of a run that is watched, and the values of its variables */
  private active: { places: readonly Active[]; values: { [variable: string]: string } } | null = null;

  constructor(private readonly host: Host, private readonly saver: Saver, private readonly changed: (picture: PictureName) => void,
    private readonly colours: ActorColours) {
    this.stage = new Stage((id, twice) => this.click(id, twice));
    this.field = h('input', {
      type: 'search', class: 'search', placeholder: 'Search', 'aria-label': 'Search the picture',
      oninput: () => this.search(), onkeydown: (event: KeyboardEvent) => this.searchKey(event),
    });
    this.follow = toggle({ icon: 'follow', title: 'Follow: mark what is at the caret or the current step', on: true, changed: () => this.markCaret(true) });
    this.forbidden = toggle({ icon: 'forbidden', title: 'Also show forbidden moves', on: false, changed: () => void this.load(true) });
    this.foldMenu = menu({ icon: 'fold', title: 'Fold branches', content: () => this.foldSections() });
    this.element = h('div', { class: 'automaton-view', onkeydown: (event: KeyboardEvent) => this.key(event) },
      h('div', { class: 'bar toolbar', role: 'toolbar', 'aria-label': 'Picture' }, this.chooser,
        h('label', { class: 'search-frame' }, icon('search'), this.field), this.foldMenu, this.forbidden.element, this.follow.element,
        h('span', { class: 'push' }),
        button({ icon: 'minus', title: 'Zoom out (−)', onclick: () => this.stage.zoom(1 / 1.3) }),
        button({ icon: 'plus', title: 'Zoom in (+)', onclick: () => this.stage.zoom(1.3) }),
        button({ icon: 'fit', title: 'Fit (0)', onclick: () => this.stage.fit() }),
        menu({ icon: 'download', title: 'Save and copy', content: () => this.saveSections() })),
      this.stage.element, foot(this.notice, this.words));
  }

  /** The picture that will be shown, so that no other is requested before. */
  expect(picture: { kind: PictureKind; name: string }): void {
    this.wanted = picture;
  }

  /** The list of pictures. By default the body of the mission is shown. */
  setProgram(program: Program): void {
    this.pictures = program.pictures;
    const groups = (['calls', 'body', 'skill', 'sv'] as const).map((kind) => ({ kind, list: program.pictures.filter((it) => it.kind === kind) }));
    this.chooser.replaceChildren(...groups.filter(({ list }) => list.length > 0).map(({ kind, list }) =>
      h('optgroup', { label: kinds[kind] }, ...list.map((it) => h('option', { value: `${it.kind} ${it.name}` }, it.name || 'Who calls whom')))));
    if (this.picture) this.colour(this.picture);
    const main = program.pictures.find((it) => it.name === program.main && it.kind === 'body') ?? program.pictures[0];
    if (this.wanted) this.chooser.value = `${this.wanted.kind} ${this.wanted.name}`;
    else if (main) void this.show(main.kind, main.name);
  }

  async show(kind: PictureKind, name: string): Promise<void> {
    this.wanted = { kind, name };
    this.fold = undefined;
    this.chooser.value = `${kind} ${name}`;
    const title = this.pictures.find((it) => it.kind === kind && it.name === name)?.title ?? name;
    this.changed({ kind, name, title });
    await this.load(false);
  }

  /** Requests the picture again after a change of the text or the theme. */
  async load(keep: boolean): Promise<void> {
    if (!this.wanted) return;
    const request = ++this.asked;
    try {
      const picture = await this.host.request('picture', this.params('svg'));
      if (request === this.asked) this.take(picture, keep);
    } catch (error) {
      if (request === this.asked) this.say(this.isShown() ? `${(error as Error).message}. This is the last valid picture.` : (error as Error).message, true);
    }
  }

  private params(format: 'svg' | 'dot') {
    return { ...this.wanted!, format, dark: isDark(), ...(this.forbidden.on && { forbidden: true }), ...(this.fold && { fold: this.fold }) };
  }

  private isShown(): boolean {
    return this.picture?.kind === this.wanted?.kind && this.picture?.name === this.wanted?.name;
  }

  /** A picture of a text with errors never replaces a valid one. */
  private take(picture: Picture, keep: boolean): void {
    if (picture.errors && this.isShown() && !this.picture!.errors)
      return this.say('The text has errors: this is the last valid picture.', true);
    keep &&= this.isShown();
    this.picture = picture;
    this.parts = partsOf(picture);
    this.stage.show(readSvg(picture.content), keep);
    this.stage.element.dataset['picture'] = `${picture.kind} ${picture.name}`;
    this.stage.element.setAttribute('aria-label', `${picture.title}: ${picture.nodes.length} nodes. Arrows walk, Enter goes to the source.`);
    this.boxes = new Map(picture.nodes.flatMap((node) => { const box = this.stage.box(node.id); return box ? [[node.id, box]] : []; }));
    this.label();
    this.colour(picture);
    if (this.selected && !this.parts.has(this.selected)) this.selected = null;
    this.select(this.selected, false);
    this.markCaret(false);
    this.markOffers();
    this.markActive();
    this.search();
    this.forbidden.element.hidden = picture.kind !== 'sv';
    this.foldMenu.hidden = (picture.foldable ?? []).length === 0;
    if (picture.errors) this.say('The text has errors: the picture may lack parts.', true);
    else this.say(picture.foldedBecause ?? '', false);
  }

  /** Descriptions for screen readers and tooltips. */
  private label(): void {
    for (const part of this.parts.values()) {
      const group = this.stage.group(part.id);
      if (!group || part.type === 'edge') continue;
      group.setAttribute('role', 'button');
      group.setAttribute('tabindex', '-1');
      group.setAttribute('aria-label', `${part.role}: ${part.label || part.role}`);
    }
  }

  /** The colours that skills have in steps and lanes. */
  private colour(picture: Picture): void {
    this.stage.dot(picture.nodes.flatMap((node) => {
      const actor = skillAt(picture, node);
      const hue = actor === null ? undefined : this.colours.ofSkill(actor);
      return actor !== null && hue !== undefined ? [{ id: node.id, actor, hue }] : [];
    }));
  }

  /** Below the picture, which does not move when errors come and go. */
  private say(words: string, stale: boolean): void {
    this.notice.textContent = words;
    this.notice.hidden = words === '';
    this.element.classList.toggle('stale', stale);
  }

  private chosen(): void {
    const [kind, ...name] = this.chooser.value.split(' ');
    void this.show(kind as PictureKind, name.join(' '));
  }

  private click(id: string | null, twice: boolean): void {
    const offered = id && this.offered.get(id);
    if (offered) return twice ? undefined : this.offers!.taken(offered);
    if (id && twice && this.toggleFold(id)) return;
    this.select(id, true);
    if (id) this.reveal(id, twice);
    else this.stage.element.focus({ preventScroll: true });
  }

  private reveal(id: string, focus: boolean): void {
    const location = this.parts.get(id)?.location;
    if (location) this.host.tell('reveal', { location, focus });
  }

  private select(id: string | null, focus: boolean): void {
    this.selected = id;
    this.stage.ring('selected', id ? [id] : []);
    const part = id ? this.parts.get(id) : undefined;
    this.words.textContent = part ? `${part.role}${part.label ? `: ${part.label}` : ''}` : (this.picture?.note ?? '');
    const group = id ? this.stage.group(id) : null;
    if (focus && part?.type !== 'edge') group?.focus({ preventScroll: true });
  }

  /** The place of the caret or of the current step. */
  follows(location: Location): void {
    this.caret = location;
    this.markCaret(true);
  }

  /** Marks the node at a place and scrolls to it, even if the view does not follow. */
  goTo(location: Location): void {
    const part = this.picture && partAt(this.picture, location);
    if (!part) return;
    this.select(part.id, false);
    this.stage.reveal(part.id);
  }

  /** Lets the current states of a run shine. */
  shine(places: readonly Active[], values: { [variable: string]: string }): void {
    this.active = { places, values };
    this.markActive();
  }

  private markActive(): void {
    if (!this.picture || !this.active) return;
    const shining = activeParts(this.picture, this.active.places, this.active.values);
    for (const part of this.parts.values()) this.stage.group(part.id)?.classList.toggle('active', shining.has(part.id));
    this.stage.ring('active', [...shining]);
  }

  /** Makes parts clickable that show these places. Returns whether there are any. */
  offer(places: readonly (Location | null)[], taken: (indices: number[]) => void): boolean {
    this.offers = { places, taken };
    this.markOffers();
    return this.offered.size > 0;
  }

  private markOffers(): void {
    this.offered = new Map();
    if (!this.picture || !this.offers) return;
    this.offers.places.forEach((place, index) => {
      const part = place && partAt(this.picture!, place);
      if (part && part.type !== 'cluster') this.offered.set(part.id, [...(this.offered.get(part.id) ?? []), index]);
    });
    this.stage.ring('offered', [...this.offered.keys()]);
    for (const part of this.parts.values()) this.stage.group(part.id)?.classList.toggle('offered', this.offered.has(part.id));
  }

  /** Marks the part that shows one of the places. */
  point(index: number | null): void {
    const at = [...this.offered].find(([, indices]) => index !== null && indices.includes(index))?.[0];
    this.stage.ring('selected', at ? [at] : []);
  }

  /** The picture of a skill, unless it is already shown. */
  showOf(name: string): void {
    const found = ['body', 'skill'].map((kind) => this.pictures.find((it) => it.kind === kind && it.name === name)).find(Boolean);
    if (this.follow.on && found && (found.kind !== this.wanted?.kind || found.name !== this.wanted?.name)) void this.show(found.kind, found.name);
  }

  private markCaret(move: boolean): void {
    const part = this.follow.on && this.caret && this.picture ? partAt(this.picture, this.caret) : null;
    this.stage.ring('caret', part ? [part.id] : []);
    if (part && move && part.type !== 'cluster') this.stage.reveal(part.id);
  }

  private search(): void {
    if (!this.picture) return;
    this.found = find(this.picture, this.field.value);
    const found = new Set(this.found);
    const searching = this.field.value.trim() !== '';
    this.field.classList.toggle('fails', searching && this.found.length === 0);
    this.stage.svg?.classList.toggle('searching', searching);
    for (const part of this.parts.values()) this.stage.group(part.id)?.classList.toggle('found', found.has(part.id));
    if (searching && this.found[0] && !this.found.includes(this.selected ?? '')) this.toFound(this.found[0]);
  }

  private toFound(id: string): void {
    this.select(id, false);
    this.stage.reveal(id);
  }

  private searchKey(event: KeyboardEvent): void {
    const at = this.found.indexOf(this.selected ?? '');
    if (event.key === 'Enter' && this.found.length > 0) {
      const by = event.shiftKey ? this.found.length - 1 : 1;
      this.toFound(this.found[(at + by) % this.found.length]!);
    } else if (event.key === 'Escape') {
      this.field.value = '';
      this.search();
      this.stage.element.focus();
    } else return;
    event.preventDefault();
  }

  /** Folds or unfolds a cluster; returns false if the part is not one. */
  private toggleFold(id: string): boolean {
    const all = this.picture?.foldable ?? [];
    const found = all.find((it) => it.part === id);
    if (!found) return false;
    const folded = all.filter((it) => it.folded !== (it === found)).map((it) => it.key);
    // parts inside a folded one keep their state
    this.setFold([...folded, ...(this.fold ?? []).filter((key) => all.some((it) => it.key === key && it.part === null))]);
    return true;
  }

  private setFold(keys: string[]): void {
    this.fold = keys;
    void this.load(false);
  }

  private foldSections(): Section[] {
    const all = this.picture?.foldable ?? [];
    const shown = all.filter((it) => it.part !== null);
    return [{ title: '', items: [
      { label: 'Fold all', choose: () => this.setFold(all.map((it) => it.key)) }, { label: 'Open all', choose: () => this.setFold([]) }] },
    { title: 'Folded', items: shown.map((it) => ({ label: it.label, checked: it.folded, choose: () => void this.toggleFold(it.part!) })) }];
  }

  private saveSections(): Section[] {
    const run = (work: () => Promise<void>) => (): void => void work().catch((error: Error) => this.say(error.message, false));
    const name = (extension: string): string => fileName([this.wanted?.kind, this.wanted?.name].filter(Boolean).join('_'), extension);
    return [{ title: 'Save', items: [
      { label: 'SVG', choose: run(() => this.saver.text(name('svg'), 'image/svg+xml', this.picture!.content)) },
      { label: 'PNG', choose: run(async () => this.saver.blob(name('png'), await this.png())) },
      { label: 'DOT', choose: run(async () => this.saver.text(name('dot'), 'text/vnd.graphviz', await this.dot())) }] },
    { title: 'Copy', items: [
      { label: 'SVG', choose: run(() => this.saver.copy(this.picture!.content, 'The SVG')) },
      { label: 'PNG', choose: run(async () => this.saver.copyImage(await this.png())) },
      { label: 'DOT', choose: run(async () => this.saver.copy(await this.dot(), 'The DOT')) }] }];
  }

  private async dot(): Promise<string> {
    return (await this.host.request('picture', this.params('dot'))).content;
  }

  private png(): Promise<Blob> {
    const size = /viewBox="[\d.-]+ [\d.-]+ ([\d.]+) ([\d.]+)"/.exec(this.picture!.content);
    return toPng(this.picture!.content, Number(size?.[1] ?? 800), Number(size?.[2] ?? 600));
  }

  private key(event: KeyboardEvent): void {
    if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    const walk = event.key as 'ArrowUp';
    const arrows: { [key: string]: [number, number] } = { ArrowUp: [0, -60], ArrowDown: [0, 60], ArrowLeft: [-60, 0], ArrowRight: [60, 0] };
    const keys: { [key: string]: () => void } = {
      '+': () => this.stage.zoom(1.3), '=': () => this.stage.zoom(1.3), '-': () => this.stage.zoom(1 / 1.3), '0': () => this.stage.fit(),
      '/': () => this.field.focus(), Escape: () => { this.select(null, false); this.stage.element.focus(); },
      Enter: () => this.selected && this.reveal(this.selected, true), ' ': () => this.selected && void this.toggleFold(this.selected),
    };
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) this.stage.pan(...arrow);
    else if (arrow) this.walk(walk);
    else if (keys[event.key]) keys[event.key]!();
    else return;
    event.preventDefault();
  }

  /** Moves to the next node in a direction; first to the picture's first node. */
  private walk(key: 'ArrowUp' | 'ArrowDown' | 'ArrowLeft' | 'ArrowRight'): void {
    const to = this.selected && this.boxes.has(this.selected) ? neighbour(this.boxes, this.selected, key) : (this.picture?.nodes[0]?.id ?? null);
    if (!to) return;
    this.select(to, true);
    this.stage.reveal(to);
    this.reveal(to, false);
  }
}
