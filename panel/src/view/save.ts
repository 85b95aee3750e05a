import type { Host } from '../api.ts';
import { h, s } from './dom.ts';

/** Files and the clipboard, by the host if it can, otherwise by the browser. */
export class Saver {
  constructor(private readonly host: Host, private readonly byHost: boolean, private readonly say: (words: string) => void) {}

  async text(name: string, type: string, text: string): Promise<void> {
    if (this.byHost) await this.host.request('save', { name, type, text });
    else this.download(name, new Blob([text], { type }));
  }

  async blob(name: string, blob: Blob): Promise<void> {
    if (!this.byHost) return this.download(name, blob);
    const bytes = new Uint8Array(await blob.arrayBuffer());
    let binary = '';
    for (let i = 0; i < bytes.length; i += 8192) binary += String.fromCharCode(...bytes.subarray(i, i + 8192));
    await this.host.request('save', { name, type: blob.type, base64: btoa(binary) });
  }

  async copy(text: string, what: string): Promise<void> {
    await navigator.clipboard.writeText(text);
    this.say(`${what} was copied to the clipboard`);
  }

  async copyImage(blob: Blob): Promise<void> {
    await navigator.clipboard.write([new ClipboardItem({ [blob.type]: blob })]);
    this.say('The picture was copied to the clipboard');
  }

  private download(name: string, blob: Blob): void {
    const url = URL.createObjectURL(blob);
    h('a', { href: url, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
    this.say(`${name} was saved`);
  }
}

const kept = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'font-family', 'font-size', 'font-weight', 'text-anchor'];

/** A copy that looks the same without the page's style sheets. \pre it is in the document */
export function standalone(svg: SVGSVGElement, width: number, height: number, background: string): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const from = svg.querySelectorAll('*');
  copy.querySelectorAll('*').forEach((element, index) => {
    const style = getComputedStyle(from[index]!);
    for (const property of kept) element.setAttribute(property, style.getPropertyValue(property));
    element.removeAttribute('class');
  });
  for (const [name, value] of Object.entries({ width, height, viewBox: `0 0 ${width} ${height}`, xmlns: 'http://www.w3.org/2000/svg' }))
    copy.setAttribute(name, String(value));
  copy.removeAttribute('class');
  copy.prepend(s('rect', { width: '100%', height: '100%', fill: background }));
  return new XMLSerializer().serializeToString(copy) + '\n';
}

/** An SVG text as a PNG with a high resolution. */
export async function toPng(svg: string, width: number, height: number): Promise<Blob> {
  const most = 8000; // in pixels; browsers draw nothing larger
  const scale = Math.min(2, most / width, most / height);
  const url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = h('canvas', { width: Math.round(width * scale), height: Math.round(height * scale) });
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((done, failed) =>
      canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error('the browser made no PNG'))), 'image/png'));
  } finally {
    URL.revokeObjectURL(url);
  }
}
