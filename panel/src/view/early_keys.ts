/** Older keys, in milliseconds, were meant for something else. */
export const kOldest = 5000;

/** Keys that are pressed before the view that the user waits for is there. They are passed on to it, so that none is lost. */
export class EarlyKeys {
  private readonly keys: KeyboardEvent[] = [];
  private readonly note = (event: KeyboardEvent): void => {
    const isForView = event.target === document.body || event.target === document.documentElement;
    if (event.isTrusted && isForView && !event.ctrlKey && !event.metaKey && !event.altKey) this.keys.push(event);
  };

  /** `root`: what an event that is passed on does not leave, since its environment has had the key. */
  constructor(root: HTMLElement) {
    addEventListener('keydown', this.note);
    root.addEventListener('keydown', (event) => {
      if (!event.isTrusted) event.stopPropagation();
    });
  }

  /** To an element that takes keys from now on. */
  pass(to: Element): void {
    removeEventListener('keydown', this.note);
    const oldest = performance.now() - kOldest;
    for (const { key, code, shiftKey, timeStamp } of this.keys.splice(0))
      if (timeStamp > oldest) to.dispatchEvent(new KeyboardEvent('keydown', { key, code, shiftKey, bubbles: true, cancelable: true }));
  }
}
