import { h } from './dom.ts';

const least = 90; // pixels

/** A line that is dragged, or moved with the arrow keys, to resize the part after it. */
export function splitter(direction: 'vertical' | 'horizontal', behind: HTMLElement, name: string): HTMLElement {
  const vertical = direction === 'vertical';
  const property = vertical ? 'width' : 'height';
  const size = (): number => behind.getBoundingClientRect()[property];
  const line = h('div', {
    class: `splitter ${direction}`, role: 'separator', tabindex: 0, 'aria-orientation': direction, 'aria-label': `Size of the ${name}`, 'aria-valuenow': 0,
    onfocus: () => tellSize(),
  });
  const tellSize = (): void => line.setAttribute('aria-valuenow', String(Math.round(size())));
  const set = (pixels: number): void => {
    const all = behind.parentElement!.getBoundingClientRect()[property];
    behind.style.flexBasis = `${Math.round(Math.min(Math.max(pixels, least), all - least))}px`;
    tellSize();
  };
  let from: { at: number; size: number } | null = null;
  line.addEventListener('pointerdown', (event) => {
    from = { at: vertical ? event.clientX : event.clientY, size: size() };
    line.setPointerCapture(event.pointerId);
  });
  line.addEventListener('pointermove', (event) => {
    if (from) set(from.size + from.at - (vertical ? event.clientX : event.clientY));
  });
  line.addEventListener('pointerup', () => { from = null; });
  line.addEventListener('keydown', (event) => {
    const by = { ArrowLeft: 24, ArrowUp: 24, ArrowRight: -24, ArrowDown: -24 }[event.key];
    if (by === undefined) return;
    set(size() + by);
    event.preventDefault();
    event.stopPropagation();
  });
  return line;
}
