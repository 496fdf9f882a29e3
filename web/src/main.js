// Entry: makes of the plain page what people see.
import './style.css';
import './header.css';
import './tables.css';
import './moments.css';
import './replay.css';
import './narrow.css';
import './print.css';
import { comparePage } from './compare_page.js';
import { readData } from './data.js';
import { runPage } from './run_page.js';
import { tunePage } from './tune_page.js';

// The pictures that stand in the plain page, by name, to be put where they belong.
function takePictures(page) {
  const pictures = new Map();
  for (const figure of page.querySelectorAll('figure[data-picture]')) {
    pictures.set(figure.dataset.picture, figure);
  }
  return pictures;
}

const pages = { run: runPage, compare: comparePage, tune: tunePage };

async function makePage() {
  // Charts measure their labels: the typeface must be there, or its stand-in will do.
  await Promise.all(
    ['400 12px Inter', '600 13px Inter'].map((font) => document.fonts.load(font)),
  ).catch(() => {});
  const page = document.getElementById('page');
  const data = readData();
  const pictures = takePictures(page);
  page.replaceChildren(...pages[data.kind](data, pictures).filter(Boolean));
  document.documentElement.dataset.ready = 'true';
}

makePage();
