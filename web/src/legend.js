// The scale of the colours: a bar with its ends and its middle, on the page and in saved pictures.
import { by_id, format_number } from './panel.js';
import { ramp, ramp_gradient } from './ramp.js';

// Shows the title and the range [low, high], which larger values may exceed; hides the legend where there is none.
export function show_legend(title, range, exceeded = false) {
  by_id('legend').hidden = !range;
  if (!range) return;
  by_id('legend-title').textContent = title;
  by_id('legend-bar').style.background = ramp_gradient();
  const texts = tick_texts(range, exceeded);
  by_id('legend-ticks')
    .querySelectorAll('span')
    .forEach((tick, i) => (tick.textContent = texts[i]));
}

export function tick_texts([low, high], exceeded) {
  const texts = [low, (low + high) / 2, high].map((value) => format_number(Number(value.toPrecision(4))));
  return exceeded ? [texts[0], texts[1], `≥ ${texts[2]}`] : texts;
}

// Draws the legend into the lower left corner of a canvas whose pixels are `scale` times those of CSS.
export function draw_legend(canvas, scale, { title, range, exceeded, ink }) {
  const context = canvas.getContext('2d'), width = 240;
  context.setTransform(scale, 0, 0, scale, 18 * scale, canvas.height - 60 * scale);
  context.font = '13px system-ui, sans-serif';
  context.fillStyle = ink;
  context.fillText(title, 0, 8);
  tick_texts(range, exceeded).forEach((text, i) => {
    context.textAlign = ['left', 'center', 'right'][i];
    context.fillText(text, (i * width) / 2, 44);
  });
  for (let x = 0; x < width; ++x) {
    context.fillStyle = `rgb(${ramp(x / (width - 1))})`;
    context.fillRect(x, 14, 1.5, 14);
  }
}
