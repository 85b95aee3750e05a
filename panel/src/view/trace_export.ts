import type { Trace } from '../api.ts';
import { fileName, traceJson, traceText } from '../model/export.ts';
import { h } from './dom.ts';
import type { LanesView } from './lanes_view.ts';
import type { Section } from './menu.ts';
import { standalone, type Saver } from './save.ts';

/** The menu to save and copy a trace; `within`: element whose styles apply to the picture of the lanes. */
export function exportSections(trace: Trace, lanes: LanesView, within: HTMLElement, saver: Saver): Section[] {
  const save = (extension: string, type: string, text: () => string) => (): void => void saver.text(fileName(trace.name, extension), type, text());
  return [{ title: 'Save', items: [
    { label: 'Trace as JSON', hint: 'can be opened again', choose: save('json', 'application/json', () => traceJson(trace)) },
    { label: 'Trace as text', choose: save('txt', 'text/plain', () => traceText(trace)) },
    { label: 'Lanes as SVG', choose: save('svg', 'image/svg+xml', () => lanesText(lanes, within)) }] },
  { title: 'Copy', items: [
    { label: 'Trace as text', choose: () => void saver.copy(traceText(trace), 'The trace') },
    { label: 'Trace as JSON', choose: () => void saver.copy(traceJson(trace), 'The trace') }] }];
}

function lanesText(lanes: LanesView, within: HTMLElement): string {
  const { svg, width, height } = lanes.picture();
  const holder = h('div', { class: 'lanes off-screen' }, svg);
  within.append(holder);
  const text = standalone(svg, width, height, getComputedStyle(document.body).backgroundColor);
  holder.remove();
  return text;
}
