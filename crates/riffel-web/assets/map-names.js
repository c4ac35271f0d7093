// Names on a map: frequencies beside their lines, none over another.

/** Heights of a line of letters and distances, in the size of the letters. */
const LINE = 1.5;
const ASIDE = 0.5;
/** Share of a line, from its lower end, at which its name is tried first; then ever further from there. */
const FIRST = 0.86;
const STEPS = 24;

/** Whether two boxes have a point in common. */
export function overlap(a, b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/** The frame around `words` whose centre is at a place of the map. */
export function frame(context, words, size, { x, y }) {
  const half = context.measureText(words).width / 2 + 3;
  return { words, left: x - half, right: x + half, top: y - 0.5 * LINE * size, bottom: y + 0.5 * LINE * size };
}

/** The names of a map in the order of their weight. A name for which there is no room is left out. */
export class MapNames {
  /** `within` is the map, `size` that of the letters, `marks` are points that a name leaves free where it can. */
  constructor(context, within, size, marks) {
    Object.assign(this, { context, size, marks, placed: [] });
    const { left, top, width, height } = within;
    this.within = { left: left + 2, right: left + width - 2, top: top + 2, bottom: top + height - 2 };
  }

  /**
   * Write a name beside the line through `points`, or into it; `font` and `color` are those of its letters. Of all places
   * that no name has taken, it gets the first with the fewest marks under it.
   */
  write(words, points, { font, color, ground, into = false }) {
    const { context, size } = this;
    context.font = font;
    const spot = this.#spot(words, points, into);
    if (!spot) return;
    this.placed.push(spot);
    context.fillStyle = ground;
    context.fillRect(spot.left, spot.top, spot.right - spot.left, spot.bottom - spot.top);
    context.fillStyle = color;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(words, (spot.left + spot.right) / 2, spot.top + 0.5 * LINE * size + 0.5);
  }

  #spot(words, points, into) {
    const inside = points.filter(({ x, y }) => x >= this.within.left && x <= this.within.right && y >= this.within.top && y <= this.within.bottom);
    if (!inside.length) return null;
    let [best, fewest] = [null, Infinity];
    for (const share of shares()) {
      const at = inside[Math.round(share * (inside.length - 1))];
      for (const side of into ? [0] : [-1, 1]) {
        const spot = this.#beside(words, at, side);
        if (!this.#free(spot)) continue;
        const covered = this.marks.reduce((count, { x, y }) => count + (x > spot.left && x < spot.right && y > spot.top && y < spot.bottom), 0);
        if (covered < fewest) [best, fewest] = [spot, covered];
        if (covered === 0) return best;
      }
    }
    return best;
  }

  /** Left of the line and above it, on the line, or right of it and below: a line rises to the right. */
  #beside(words, { x, y }, side) {
    const { left, right, top, bottom } = frame(this.context, words, this.size, { x: 0, y: 0 });
    const away = ASIDE * this.size;
    return frame(this.context, words, this.size, { x: x + side * (0.5 * (right - left) + away), y: y + side * (0.25 * (bottom - top) + away) });
  }

  #free(spot) {
    const { left, right, top, bottom } = this.within;
    return spot.left >= left && spot.right <= right && spot.top >= top && spot.bottom <= bottom && !this.placed.some((other) => overlap(spot, other));
  }
}

/** Shares of a line from the one tried first, in turns towards both ends. */
function shares() {
  const all = Array.from({ length: STEPS + 1 }, (_, k) => k / STEPS);
  return all.sort((a, b) => Math.abs(a - FIRST) - Math.abs(b - FIRST));
}
