import { h } from './dom.ts';
import { icon, type Icon } from './icons.ts';

export interface Item {
  label: string;
  hint?: string;
  /** undefined: an action; otherwise a choice that is on or off */
  checked?: boolean;
  /** class of its icon */
  mark?: string;
  choose: () => void;
}
export interface Section {
  title: string;
  items: Item[];
}

/** A button that opens a list. Toggling a choice keeps the list open. */
export function menu(options: { icon: Icon; text?: string; title: string; content: () => Section[] }): HTMLElement {
  const list = h('div', { class: 'menu-list', role: 'menu', 'aria-label': options.title, hidden: true });
  const opener = h('button', {
    type: 'button', class: options.text ? 'button' : 'button plain', title: options.title,
    'aria-label': options.title, 'aria-haspopup': 'menu', 'aria-expanded': 'false', onclick: () => (list.hidden ? show() : hide(true)),
  }, icon(options.icon), options.text);
  const root = h('div', { class: 'menu' }, opener, list);

  const items = (): HTMLElement[] => [...list.querySelectorAll<HTMLElement>('.menu-item')];
  function draw(): void {
    list.replaceChildren(...options.content().flatMap((section): HTMLElement[] => [
      h('div', { class: 'menu-title', hidden: section.title === '' }, section.title),
      ...section.items.map((item) => h('button', {
        type: 'button', class: 'menu-item', tabindex: -1, role: item.checked === undefined ? 'menuitem' : 'menuitemcheckbox',
        'aria-checked': item.checked === undefined ? null : String(item.checked),
        onclick: () => choose(item),
      }, item.checked !== undefined && h('span', { class: 'menu-check' }, item.checked && icon('good')),
      item.mark && h('span', { class: `dot ${item.mark}` }), h('span', { class: 'menu-label' }, item.label),
      item.hint && h('span', { class: 'menu-hint' }, item.hint))),
    ]));
  }
  function choose(item: Item): void {
    const at = items().indexOf(document.activeElement as HTMLElement);
    item.choose();
    if (item.checked === undefined) return hide(true);
    draw();
    items()[at]?.focus();
  }
  function show(): void {
    draw();
    list.hidden = false;
    opener.setAttribute('aria-expanded', 'true');
    list.classList.toggle('to-left', opener.getBoundingClientRect().left + list.offsetWidth > innerWidth - 8);
    items()[0]?.focus();
    document.addEventListener('pointerdown', outside, true);
  }
  function hide(back: boolean): void {
    list.hidden = true;
    opener.setAttribute('aria-expanded', 'false');
    document.removeEventListener('pointerdown', outside, true);
    if (back) opener.focus();
  }
  const outside = (event: Event): void => void (root.contains(event.target as Node) || hide(false));

  root.addEventListener('keydown', (event) => {
    if (list.hidden) return;
    const all = items();
    const at = all.indexOf(document.activeElement as HTMLElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key];
    if (to !== undefined) all[(to + all.length) % all.length]?.focus();
    else if (event.key === 'Escape') hide(true);
    else if (event.key !== 'Tab') return;
    else return hide(false);
    event.preventDefault();
    event.stopPropagation();
  });
  return root;
}
