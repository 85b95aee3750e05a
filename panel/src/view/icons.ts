import { h, s } from './dom.ts';

/** Lines on a field of 16 by 16. */
const paths = {
  previous: 'M10 3.5 5.5 8l4.5 4.5',
  next: 'M6 3.5 10.5 8 6 12.5',
  first: 'M11 3.5 6.5 8l4.5 4.5M4.5 3.5v9',
  last: 'M5 3.5 9.5 8 5 12.5M11.5 3.5v9',
  search: 'M7 2.5a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM10.3 10.3l3.2 3.2',
  filter: 'M2.5 4h11M4.5 8h7M6.5 12h3',
  follow: 'M8 1.8v3M8 11.2v3M1.8 8h3M11.2 8h3M8 5a3 3 0 1 1 0 6 3 3 0 0 1 0-6z',
  compare: 'M3 3.5h4v9H3zM9.5 3.5h4v9h-4z',
  download: 'M8 2.5v7.5M5 7.5 8 10.5l3-3M3 13.5h10',
  copy: 'M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3',
  plus: 'M8 3.5v9M3.5 8h9',
  minus: 'M3.5 8h9',
  fit: 'M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10',
  fold: 'M5 2.5 8 5.5l3-3M5 13.5l3-3 3 3M2.5 8h11',
  pin: 'M6 2.5h4v4l2 2.5H4l2-2.5zM8 9v4.5',
  open: 'M2.5 12.5v-9h4l1.5 2h5.5v7z',
  again: 'M13 8a5 5 0 1 1-1.5-3.5M13.3 2.5v3h-3',
  theme: 'M8 2.5a5.5 5.5 0 1 0 0 11z M8 2.5a5.5 5.5 0 0 1 0 11',
  close: 'M4 4l8 8M12 4l-8 8',
  forbidden: 'M8 2.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11zM4.2 4.2l7.6 7.6',
  down: 'M4 6l4 4 4-4',
  good: 'M3.5 8.5 6.5 11.5l6-7',
  bad: 'M4.5 4.5l7 7M11.5 4.5l-7 7',
  warning: 'M8 3v6M8 11.5v1.2',
  open_question: 'M5.8 6a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.6M8 11.7v1',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
  go: 'M5 3.2 12 8l-7 4.8z',
  stop: 'M4 4h8v8H4z',
  event: 'M9 2 4 9h4l-1 5 5-7H8z',
  interrupt: 'M8 2.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11zM6 6h4v4H6z',
  changes: 'M2.5 5h8M7.5 2l3 3-3 3M13.5 11h-8M8.5 8l-3 3 3 3',
} as const;
export type Icon = keyof typeof paths;

export const icon = (name: Icon): SVGElement =>
  s('svg', { viewBox: '0 0 16 16', class: 'icon', 'aria-hidden': 'true' }, s('path', { d: paths[name] }));

export interface ButtonOptions {
  icon?: Icon;
  text?: string;
  title: string;
  pressed?: boolean;
  onclick: (event: MouseEvent) => void;
}
export function button(options: ButtonOptions): HTMLButtonElement {
  return h('button', {
    type: 'button', class: options.text ? 'button' : 'button plain', title: options.title,
    'aria-label': options.text ? null : options.title,
    'aria-pressed': options.pressed === undefined ? null : String(options.pressed),
    onclick: options.onclick,
  }, options.icon && icon(options.icon), options.text);
}

export interface Toggle {
  element: HTMLButtonElement;
  on: boolean;
  set(on: boolean): void;
}
/** A toggle button. */
export function toggle(options: Omit<ButtonOptions, 'onclick' | 'pressed'> & { on: boolean; changed: (on: boolean) => void }): Toggle {
  const it: Toggle = {
    on: options.on,
    element: button({ ...options, pressed: options.on, onclick: () => { it.set(!it.on); options.changed(it.on); } }),
    set(on) {
      it.on = on;
      it.element.setAttribute('aria-pressed', String(on));
    },
  };
  return it;
}

/** A button that explains in its tooltip why it is disabled. */
export function enable(element: HTMLButtonElement, why: string | null, title: string): void {
  element.disabled = why !== null;
  element.title = why ?? title;
}
