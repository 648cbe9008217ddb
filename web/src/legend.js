// The scale of the colours: a bar with round ticks, on the page and in saved pictures.
import { by_id, element, format_number } from './panel.js';
import { ramp, ramp_gradient } from './ramp.js';
import { round_step } from './values.js';

const kTicks = 4;  // steps, about

// The round numbers in a range [low, high], as [{text, share}] with the place of each along the bar. Values below or above
// the range, if `exceeded` says that there are some, have the colours of its ends.
export function make_ticks([low, high], exceeded = {}) {
  if (!(high > low)) return [{ text: format_number(Number(low.toPrecision(4))), share: 0.5 }];
  const step = round_step(high - low, kTicks), slack = 1e-6 * step, ticks = [];
  for (let k = Math.ceil((low - slack) / step); k * step <= high + slack; ++k) {
    const value = Number((k * step).toPrecision(12));
    ticks.push({ text: format_number(value), share: (value - low) / (high - low) });
  }
  const at_end = (tick, share) => tick && Math.abs(tick.share - share) < 1e-6;
  if (exceeded.below && at_end(ticks[0], 0)) ticks[0].text = `≤ ${ticks[0].text}`;
  if (exceeded.above && at_end(ticks.at(-1), 1)) ticks.at(-1).text = `≥ ${ticks.at(-1).text}`;
  return ticks;
}

// Shows the title and the scale of a range; hides the legend where there is none.
export function show_legend(title, range, exceeded) {
  by_id('legend').hidden = !range;
  if (!range) return;
  by_id('legend-title').textContent = title;
  by_id('legend-bar').style.background = ramp_gradient();
  const ticks = make_ticks(range, exceeded).map(({ text, share }) => {
    const tick = element('span', { textContent: text });
    tick.style.left = `${100 * share}%`;
    return tick;
  });
  by_id('legend-ticks').replaceChildren(...ticks);
}

// Draws the legend into the lower left corner of a canvas whose pixels are `scale` times those of CSS.
export function draw_legend(canvas, scale, { title, range, exceeded, ink }) {
  const context = canvas.getContext('2d'), width = 240;
  context.setTransform(scale, 0, 0, scale, 26 * scale, canvas.height - 60 * scale);
  context.font = '13px system-ui, sans-serif';
  context.fillStyle = ink;
  context.fillText(title, 0, 8);
  context.textAlign = 'center';
  for (const { text, share } of make_ticks(range, exceeded)) {
    context.fillText(text, share * width, 46);
    context.fillRect(share * width - 0.5, 28, 1, 4);
  }
  for (let x = 0; x < width; ++x) {
    context.fillStyle = `rgb(${ramp(x / (width - 1))})`;
    context.fillRect(x, 14, 1.5, 14);
  }
}
