import type { Box } from '../model/picture.ts';
import { h, onceAFrame, s } from './dom.ts';

const margin = 16; // margin around the picture, in its units
const largest = 6; // pixels per unit
const smallest = 0.02;

/** Shows an SVG picture: it is moved with the mouse, zoomed with the wheel, both also with keys. */
export class Stage {
  readonly element: HTMLElement;
  svg: SVGSVGElement | null = null;
  private groups = new Map<string, SVGGElement>();
  private size = { width: 1, height: 1 };
  private scale = 1;
  private left = 0;
  private top = 0;
  private fitted = true;
  private readonly rings = s('g', { class: 'rings' });
  private readonly dots = s('g', { class: 'dots' });
  private readonly apply = onceAFrame(() => this.applyNow());

  constructor(private readonly clicked: (id: string | null, twice: boolean) => void) {
    this.element = h('div', { class: 'stage', tabindex: 0, role: 'group', 'aria-roledescription': 'picture' });
    new ResizeObserver(() => (this.fitted ? this.fit() : this.apply())).observe(this.element);
    this.listen();
  }

  /** Replaces the picture. `keep`: keeps zoom and position. */
  show(svg: SVGSVGElement, keep: boolean): void {
    const box = svg.viewBox.baseVal;
    this.size = { width: box.width || 1, height: box.height || 1 };
    svg.setAttribute('width', '100%');
    svg.setAttribute('height', '100%');
    this.svg = svg;
    this.groups = new Map([...svg.querySelectorAll<SVGGElement>('g[id]')].map((group) => [group.id, group]));
    this.rings.replaceChildren();
    (svg.querySelector('g.graph') ?? svg).append(this.rings, this.dots);
    this.element.replaceChildren(svg);
    if (keep && !this.fitted) this.applyNow();
    else this.fit();
  }

  fit(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0) return;
    this.scale = Math.min((width - 2 * margin) / this.size.width, (height - 2 * margin) / this.size.height, 1.6);
    this.left = (this.size.width - width / this.scale) / 2;
    this.top = (this.size.height - height / this.scale) / 2;
    this.fitted = true;
    this.applyNow();
  }

  /** Zooms around a point of the element; by default its centre. */
  zoom(factor: number, x = this.element.clientWidth / 2, y = this.element.clientHeight / 2): void {
    const scale = Math.min(Math.max(this.scale * factor, smallest), largest);
    this.left += x / this.scale - x / scale;
    this.top += y / this.scale - y / scale;
    this.scale = scale;
    this.fitted = false;
    this.apply();
  }

  /** In pixels. */
  pan(x: number, y: number): void {
    this.left += x / this.scale;
    this.top += y / this.scale;
    this.fitted = false;
    this.apply();
  }

  group(id: string): SVGGElement | null {
    return this.groups.get(id) ?? null;
  }

  /** In units of the picture. */
  box(id: string): Box | null {
    return this.group(id)?.getBBox() ?? null;
  }

  /** Frames around some parts. */
  ring(kind: 'selected' | 'caret' | 'offered' | 'active', ids: readonly string[]): void {
    for (const old of [...this.rings.children]) if (old.classList.contains(kind)) old.remove();
    for (const id of ids) {
      const box = this.box(id);
      if (box) this.rings.append(s('rect', { class: `ring ${kind}`, x: box.x - 5, y: box.y - 5, width: box.width + 10, height: box.height + 10, rx: 8 }));
    }
  }

  /** Dots at the corners of parts, in the colours of actors. */
  dot(actors: readonly { id: string; actor: string; hue: number }[]): void {
    this.dots.replaceChildren(...actors.flatMap(({ id, actor, hue }) => {
      const box = this.box(id);
      return box ? [s('circle', { class: `actor-dot hue-${hue}`, 'data-actor': actor, cx: box.x + 3, cy: box.y + 3, r: 5.5 })] : [];
    }));
  }

  /** Moves only if a part is not visible, and no more than necessary. */
  reveal(id: string): void {
    const group = this.group(id);
    if (!group) return;
    this.applyNow();
    const here = this.element.getBoundingClientRect();
    const it = group.getBoundingClientRect();
    if (it.width * it.height > 0 && this.scale * 11 < 5) this.zoom(9 / (this.scale * 11), it.x + it.width / 2 - here.x, it.y + it.height / 2 - here.y);
    const edge = 24;
    const off = (from: number, to: number, low: number, high: number): number =>
      from < low + edge ? from - low - edge : to > high - edge ? Math.min(to - high + edge, from - low - edge) : 0;
    const x = off(it.left, it.right, here.left, here.right);
    const y = off(it.top, it.bottom, here.top, here.bottom);
    if (x !== 0 || y !== 0) this.pan(x, y);
  }

  private applyNow(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!this.svg || width === 0) return;
    this.svg.setAttribute('viewBox', `${this.left} ${this.top} ${width / this.scale} ${height / this.scale}`);
  }

  private listen(): void {
    const { element } = this;
    let from: { x: number; y: number; moved: boolean } | null = null;
    element.addEventListener('pointerdown', (event) => {
      if (event.button === 0) from = { x: event.clientX, y: event.clientY, moved: false };
    });
    element.addEventListener('pointermove', (event) => {
      if (!from || event.buttons === 0) return;
      const [x, y] = [from.x - event.clientX, from.y - event.clientY];
      if (!from.moved && Math.hypot(x, y) < 4) return;
      if (!from.moved) element.setPointerCapture(event.pointerId);
      from = { x: event.clientX, y: event.clientY, moved: true };
      element.classList.add('dragging');
      this.pan(x, y);
    });
    element.addEventListener('pointerup', (event) => {
      element.classList.remove('dragging');
      if (from && !from.moved) this.clicked(idOf(event.target), event.detail > 1);
      from = null;
    });
    element.addEventListener('dblclick', (event) => this.clicked(idOf(event.target), true));
    element.addEventListener('wheel', (event) => {
      event.preventDefault();
      const here = element.getBoundingClientRect();
      if (event.shiftKey) this.pan(event.deltaX || event.deltaY, 0);
      else this.zoom(Math.exp(-event.deltaY / (event.ctrlKey ? 120 : 400)), event.clientX - here.x, event.clientY - here.y);
    }, { passive: false });
  }
}

const idOf = (target: EventTarget | null): string | null => (target as Element | null)?.closest('g.node, g.edge, g.cluster')?.id ?? null;

/** The text of a picture as elements, without links and scripts. */
export function readSvg(text: string): SVGSVGElement {
  const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  if (root.nodeName !== 'svg') throw new Error('the picture cannot be read');
  const svg = document.importNode(root, true) as unknown as SVGSVGElement;
  for (const element of svg.querySelectorAll('script, foreignObject, title')) element.remove();
  for (const element of svg.querySelectorAll('*'))
    for (const name of element.getAttributeNames())
      if (/^on|href$|^xlink:|^style$/i.test(name)) element.removeAttribute(name);
  return svg;
}
