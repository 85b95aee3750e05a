import type { Host, Message, Method, News, NewsOf, Requests, Told } from '../api.ts';

/** Numbered requests, for a host that communicates by messages. */
export class MessageHost implements Host {
  private last = 0;
  private readonly open = new Map<number, { done: (result: never) => void; failed: (error: Error) => void }>();
  private readonly listeners: ((...news: NewsOf) => void)[] = [];

  constructor(private readonly post: (message: Message) => void) {}

  request<M extends Method>(method: M, params: Requests[M][0]): Promise<Requests[M][1]> {
    const id = ++this.last;
    return new Promise((done, failed) => {
      this.open.set(id, { done, failed });
      this.post({ type: 'request', id, method, params });
    });
  }

  tell<M extends keyof Told>(method: M, params: Told[M]): void {
    this.post({ type: 'told', method, params });
  }

  onNews(listener: (...news: NewsOf) => void): void {
    this.listeners.push(listener);
  }

  /** Handles a message of the host; ignores others. */
  receive(message: Message): void {
    if (message?.type === 'news')
      for (const listener of this.listeners) listener(...([message.method, message.params as News[keyof News]] as NewsOf));
    if (message?.type !== 'reply') return;
    const asked = this.open.get(message.id);
    this.open.delete(message.id);
    if (message.error !== undefined) asked?.failed(new Error(message.error));
    else asked?.done(message.result as never);
  }
}
