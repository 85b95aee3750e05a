import type { Host, Method, News, NewsOf, Requests } from '../api.ts';
import { convert, programOf } from './convert.ts';

interface Answer {
  result?: unknown;
  error?: string;
}
interface RawNews {
  next: number;
  news: { method: keyof News; params: unknown }[];
}

/**
 * `proskill view`: `POST api/METHOD` below the address of the page, whose path has the token. The page requests events in a loop; the server answers
 * when there are some.
 */
export class HttpHost implements Host {
  private readonly listeners: ((...news: NewsOf) => void)[] = [];

  async request<M extends Method>(method: M, params: Requests[M][0]): Promise<Requests[M][1]> {
    const result = await this.post(`api/${method}`, params);
    if (method === 'hello') void this.listen();
    return convert(method, result) as Requests[M][1];
  }

  tell(): void {
    // The panel shows the source itself; nobody else listens.
  }

  onNews(listener: (...news: NewsOf) => void): void {
    this.listeners.push(listener);
  }

  private async post(path: string, params: unknown): Promise<unknown> {
    const response = await fetch(path, {
      method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(params),
    });
    if (!response.ok) throw new Error(`proskill view answers ${response.status} ${response.statusText}`);
    const answer = (await response.json()) as Answer;
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.result;
  }

  private async listen(): Promise<void> {
    for (let next = 0; ; ) {
      try {
        const answer = (await this.post('api/news', { after: next })) as RawNews;
        next = answer.next;
        for (const { method, params } of answer.news) this.announce(method, params);
      } catch {
        this.announce('gone', {});
        return;
      }
    }
  }

  private announce(method: keyof News, params: unknown): void {
    const news = method === 'program' ? programOf(params) : params;
    for (const listener of this.listeners) listener(...([method, news] as NewsOf));
  }
}
