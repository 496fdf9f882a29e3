// What can be measured of how a page looks; each runs in the page.

// Pixels that the content is wider than the window.
export const overflow = () => document.documentElement.scrollWidth - window.innerWidth;

// Number of colours in a canvas and a fingerprint of its pixels.
export function pixelsOf(selector) {
  const canvas = document.querySelector(selector);
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
  let print = 0;
  const colours = new Set();
  for (const pixel of pixels) {
    print = (Math.imul(print, 31) + pixel) | 0;
    colours.add(pixel);
  }
  return { colours: colours.size, print };
}

// Texts whose contrast to their background is below AA (4.5, or 3 for large ones), by WCAG 2.
export function paleTexts() {
  const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
  const luminance = ([r, g, b]) => {
    const linear = [r, g, b].map((c) =>
      c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4,
    );
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  };
  const backgroundOf = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const colour = channels(getComputedStyle(at).backgroundColor);
      if (colour.length === 3 || colour[3] > 0.99) return colour;
    }
    return [255, 255, 255];
  };
  const pale = [];
  for (const element of document.querySelectorAll('main *')) {
    const own = [...element.childNodes].some(
      (node) => node.nodeType === 3 && node.textContent.trim(),
    );
    if (!own || !element.checkVisibility()) continue;
    const style = getComputedStyle(element);
    const [light, dark] = [luminance(channels(style.color)), luminance(backgroundOf(element))].sort(
      (a, b) => b - a,
    );
    const contrast = (light + 0.05) / (dark + 0.05);
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (contrast < (large ? 3 : 4.5))
      pale.push(`${element.textContent.trim().slice(0, 40)}: ${contrast.toFixed(2)}`);
  }
  return pale;
}

// What is said to those who do not see: images and charts without a text, tables without a name.
export function untold() {
  const bare = [];
  for (const image of document.querySelectorAll('main img:not(.leaflet-image-layer)')) {
    if (!image.alt) bare.push(image.outerHTML.slice(0, 80));
  }
  for (const box of document.querySelectorAll('[role=img], canvas.world')) {
    if (!box.getAttribute('aria-label')) bare.push(box.outerHTML.slice(0, 80));
  }
  for (const one of document.querySelectorAll('table')) {
    if (!one.caption?.textContent || !one.querySelector('th[scope=col]'))
      bare.push('a table without caption or header');
  }
  for (const control of document.querySelectorAll('input, select')) {
    if (!control.labels?.length && !control.getAttribute('aria-label'))
      bare.push(control.outerHTML.slice(0, 80));
  }
  return bare;
}
