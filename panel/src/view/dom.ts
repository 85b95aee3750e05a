/** Builds elements without parsing strings: user text is never interpreted as HTML. */

type Child = Node | string | null | undefined | false;
type Attributes = { [name: string]: string | number | boolean | null | undefined | ((event: never) => void) };

const svgNamespace = 'http://www.w3.org/2000/svg';

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name.slice(2), value as EventListener);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children.filter((child): child is Node | string => !!child));
}

/** `h('button', { class: 'x', onclick: f }, 'text')`; attributes that are false are omitted. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

export function s<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS(svgNamespace, tag);
  fill(element, attributes, children);
  return element;
}

/** Replaces the children of an element; those that stay in their order are not moved, so that they keep focus and layout. */
export function setChildren(parent: Element, children: readonly Element[]): void {
  const kept = new Set<Node>(children);
  for (const child of [...parent.childNodes]) if (!kept.has(child)) child.remove();
  let at: Node | null = parent.firstChild;
  for (const child of children) {
    if (child === at) at = at.nextSibling;
    else parent.insertBefore(child, at);
  }
}

/** A line at the bottom of a view. It is always there, and longer words cover what is above, so that nothing moves when they come and go. */
export function foot(...children: Element[]): HTMLElement {
  return h('div', { class: 'foot' }, h('div', { class: 'foot-line' }, ...children));
}

/** Text in which names in backquotes become code. */
export function prose(text: string): DocumentFragment {
  const out = document.createDocumentFragment();
  text.split('`').forEach((part, index) => {
    if (part !== '') out.append(index % 2 ? h('code', {}, part) : part);
  });
  return out;
}

/** Calls at most once per frame, with the last arguments. */
export function onceAFrame(work: () => void): () => void {
  let due = false;
  return () => {
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
      due = false;
      work();
    });
  };
}

/** Whether a key is typed into a field. */
export function isTyping(event: Event): boolean {
  const target = event.target as HTMLElement | null;
  return !!target?.closest('input, select, textarea');
}

export const plural = (count: number, one: string, many = `${one}s`): string => `${count.toLocaleString('en')} ${count === 1 ? one : many}`;
