// What covers the picture: panels at its right, or on a phone above and below it.

const phone = matchMedia('(max-width: 720px), (max-height: 480px)');

const kTall = 1.6;  // height of a phone's screen, in its widths, from which a wide picture leaves room for a panel

const box_of = (element) => element.getBoundingClientRect();
const panels = () => [...document.querySelectorAll('aside > details')];

// Pixels at each side of the picture that panels cover: at the right, or on a phone above and below. Panels that are open
// count on an upright phone only; on its side they would leave too little.
export function covered() {
  const [side, bar, head] = ['aside', '#bar', 'header'].map((name) => document.querySelector(name));
  if (!phone.matches) return { left: 0, right: box_of(side).width && innerWidth - box_of(side).left, top: 0, bottom: 0 };
  const upright = innerWidth < innerHeight;  // on its side there is room beside the title
  const buttons = [bar, ...panels().filter((panel) => upright || !panel.open)].map(box_of).filter(({ height }) => height > 0);
  const bottom = innerHeight - Math.min(innerHeight, ...buttons.map(({ top }) => top));
  return { left: 0, right: 0, top: upright && box_of(head).height ? box_of(head).bottom : 0, bottom };
}

// The panels that were open when the window became narrow; those that the page names where it was narrow at first.
let open_when_wide = null;

// Opens the panels that the page names, and shows the first of them. A phone has none open, but the first one below a
// picture that is `wide`.
export function open_first_panels(wide = false) {
  open_when_wide = null;
  for (const box of panels()) box.open = !phone.matches && box.dataset.open !== undefined;
  if (phone.matches && wide && innerHeight > kTall * innerWidth) panels()[0].open = true;
  document.querySelector('aside').scrollTop = 0;
}

// Closes all panels where the window has become narrow, and opens them again where it has become wide.
function follow_width() {
  if (!phone.matches && !open_when_wide) return open_first_panels();
  if (phone.matches) open_when_wide = panels().filter((box) => box.open);
  for (const box of panels()) box.open = !phone.matches && open_when_wide.includes(box);
}

// A panel that is opened comes into view; on a phone the others are closed.
export function arrange_panels() {
  open_first_panels();
  // On a narrow phone the buttons have two rows: cards are above them.
  const measure = () => document.documentElement.style.setProperty('--covered', `${covered().bottom}px`);
  new ResizeObserver(measure).observe(document.querySelector('aside'));
  phone.addEventListener('change', follow_width);
  for (const box of panels()) {
    box.addEventListener('toggle', () => {
      if (!phone.matches || !box.open) return;
      panels().forEach((other) => (other.open = other === box));
    });
    box.querySelector('summary').addEventListener('click', () => {
      requestAnimationFrame(() => box.open && box.scrollIntoView({ block: 'nearest' }));
    });
  }
}
