// What a map draws on a canvas, written as SVG: lines and words stay lines and words, the field of colours is a picture.

const escaped = (text) => String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
const plain = (value) => String(Math.round(100 * value) / 100);
const ANCHOR = { left: 'start', center: 'middle', right: 'end' };
/** Height of the baseline below the place of a word, in sizes of its letters. */
const BASELINE = { top: 0.8, middle: 0.36, bottom: -0.2, alphabetic: 0 };

/** Clips so far: names of one page differ. */
let clips = 0;

/** The part of CanvasRenderingContext2D that maps use. Coordinates are those of the place, not of its pixels. */
export class SvgContext {
  constructor(width, height, ground) {
    Object.assign(this, { width, height, parts: [`<rect width="${plain(width)}" height="${plain(height)}" fill="${ground}"/>`], path: '', open: 0, stack: [], transform: [] });
    Object.assign(this, { fillStyle: '#000', strokeStyle: '#000', lineWidth: 1, font: '10px sans-serif', textAlign: 'left', textBaseline: 'alphabetic', dash: [] });
    this.measure = document.createElement('canvas').getContext('2d');
  }

  setTransform() {}
  clearRect() {}
  setLineDash(dash) {
    this.dash = dash;
  }

  beginPath() {
    this.path = '';
  }

  moveTo(x, y) {
    this.path += `M${plain(x)} ${plain(y)}`;
  }

  lineTo(x, y) {
    this.path += `${this.path ? 'L' : 'M'}${plain(x)} ${plain(y)}`;
  }

  rect(x, y, width, height) {
    this.path += `M${plain(x)} ${plain(y)}h${plain(width)}v${plain(height)}h${plain(-width)}z`;
  }

  closePath() {
    this.path += 'z';
  }

  /** Whole circles alone. */
  arc(x, y, radius) {
    const r = plain(radius);
    this.path += `M${plain(x - radius)} ${plain(y)}a${r} ${r} 0 1 0 ${plain(2 * radius)} 0a${r} ${r} 0 1 0 ${plain(-2 * radius)} 0z`;
  }

  stroke() {
    this.#shape(`fill="none" ${this.#stroke()}`);
  }

  fill() {
    this.#shape(`fill="${escaped(this.fillStyle)}"`);
  }

  strokeRect(...box) {
    this.beginPath();
    this.rect(...box);
    this.stroke();
  }

  fillRect(...box) {
    this.beginPath();
    this.rect(...box);
    this.fill();
  }

  #shape(style) {
    if (this.path) this.parts.push(`<path d="${this.path}" ${style}/>`);
  }

  #stroke() {
    const dash = this.dash.length ? ` stroke-dasharray="${this.dash.join(' ')}"` : '';
    return `stroke="${escaped(this.strokeStyle)}" stroke-width="${plain(this.lineWidth)}"${dash}`;
  }

  clip() {
    const id = `clip-${clips++}`;
    this.#group(`<clipPath id="${id}"><path d="${this.path}"/></clipPath><g clip-path="url(#${id})">`);
  }

  translate(x, y) {
    this.#group(`<g transform="translate(${plain(x)} ${plain(y)})">`);
  }

  rotate(angle) {
    this.#group(`<g transform="rotate(${plain((180 * angle) / Math.PI)})">`);
  }

  #group(begin) {
    this.parts.push(begin);
    this.open++;
  }

  save() {
    const { fillStyle, strokeStyle, lineWidth, font, textAlign, textBaseline, dash, open } = this;
    this.stack.push({ fillStyle, strokeStyle, lineWidth, font, textAlign, textBaseline, dash, open });
  }

  restore() {
    const { open, ...before } = this.stack.pop();
    this.parts.push('</g>'.repeat(this.open - open));
    Object.assign(this, before, { open });
  }

  measureText(text) {
    this.measure.font = this.font;
    return this.measure.measureText(text);
  }

  fillText(text, x, y) {
    const [, weight = '', size, family] = /^(?:(\d+) )?([\d.]+)px (.*)$/.exec(this.font) ?? [undefined, '', '10', 'sans-serif'];
    const style = `font-size="${plain(Number(size))}"${weight ? ` font-weight="${weight}"` : ''} font-family="${escaped(family)}"`;
    const at = y + BASELINE[this.textBaseline] * size;
    this.parts.push(`<text x="${plain(x)}" y="${plain(at)}" ${style} text-anchor="${ANCHOR[this.textAlign]}" fill="${escaped(this.fillStyle)}">${escaped(text)}</text>`);
  }

  drawImage(canvas, x, y, width, height) {
    this.parts.push(`<image x="${plain(x)}" y="${plain(y)}" width="${plain(width)}" height="${plain(height)}" preserveAspectRatio="none" href="${canvas.toDataURL('image/png')}"/>`);
  }

  text() {
    const [width, height] = [plain(this.width), plain(this.height)];
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">${this.parts.join('')}${'</g>'.repeat(this.open)}</svg>`;
  }
}
