/** Rows with known heights in pixels, of which only the visible ones are drawn. */
export class Rows {
  private readonly tops: Float64Array;

  constructor(heights: ArrayLike<number>) {
    this.tops = new Float64Array(heights.length + 1);
    for (let i = 0; i < heights.length; ++i) this.tops[i + 1] = this.tops[i]! + heights[i]!;
  }

  get count(): number {
    return this.tops.length - 1;
  }
  get height(): number {
    return this.tops[this.count]!;
  }
  top(row: number): number {
    return this.tops[row]!;
  }
  bottom(row: number): number {
    return this.tops[row + 1]!;
  }

  /** The row at this height; clamped to the first and the last. -1 if there are no rows. */
  at(y: number): number {
    let low = 0;
    let high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.tops[middle]! <= y) low = middle;
      else high = middle - 1;
    }
    return Math.min(low, this.count - 1);
  }

  /** The range of rows to draw, with a margin on both sides. */
  visible(scroll: number, height: number, margin = 0): [number, number] {
    if (this.count === 0) return [0, 0];
    return [this.at(scroll - margin), this.at(scroll + height + margin) + 1];
  }

  /** Scroll position at which a row is visible; unchanged if it already is. */
  reveal(row: number, scroll: number, height: number, margin = 0): number {
    if (this.top(row) - margin < scroll) return Math.max(0, this.top(row) - margin);
    if (this.bottom(row) + margin > scroll + height)
      return Math.max(0, Math.min(this.bottom(row) + margin, this.height) - height);
    return scroll;
  }
}
