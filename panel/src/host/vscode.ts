import type { Host, Message } from '../api.ts';
import { MessageHost } from './messages.ts';

declare function acquireVsCodeApi(): { postMessage(message: unknown): void };

/** The webview of VS Code; null in other environments. */
export function vsCodeHost(): Host | null {
  if (typeof acquireVsCodeApi !== 'function') return null;
  const code = acquireVsCodeApi();
  const host = new MessageHost((message) => code.postMessage(message));
  addEventListener('message', (event) => host.receive(event.data as Message));
  return host;
}
