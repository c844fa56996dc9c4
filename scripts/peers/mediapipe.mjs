// SPDX-License-Identifier: MIT
// Shows MediaPipe Hands a folder of pictures in order of their names, as one video, in a Chromium without a window.
//   node mediapipe.mjs PACKAGES FRAMES RESULT.jsonl
// PACKAGES holds node_modules. RESULT has a line a frame: file, width, height, landmarks, world, handedness.
import fs from 'node:fs';
import http from 'node:http';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const FRAMES_A_CALL = 20; // so that no call waits for a whole sequence
const OPTIONS = {
  maxNumHands: 1,
  modelComplexity: 1,
  minDetectionConfidence: 0.5,
  minTrackingConfidence: 0.5,
  useCpuInference: true, // the nets run on the CPU: many times faster than on WebGL without a graphics card
};
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm', '.jpg': 'image/jpeg' };

// A server of our page, the package and the frames: a browser does not load wasm from files.
async function serve(folders) {
  const server = http.createServer((request, response) => {
    const url = decodeURIComponent(request.url.split('?')[0]);
    const file = path.join(folders[path.dirname(url)] ?? '/nowhere', path.basename(url));
    fs.readFile(file, (error, bytes) => {
      const type = TYPES[path.extname(file)] ?? 'application/octet-stream';
      response.writeHead(error ? 404 : 200, { 'content-type': type });
      response.end(bytes);
    });
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return server;
}

function launch(packages) {
  const puppeteer = createRequire(path.resolve(packages, 'package.json'))('puppeteer-core');
  const args = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
  args.push('--disable-dev-shm-usage'); // a container's is too small
  if (process.getuid() === 0) args.push('--no-sandbox'); // Chromium has no sandbox for root
  return puppeteer.launch({ executablePath: '/usr/bin/chromium', protocolTimeout: 3600e3, args });
}

async function openPage(browser, address) {
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.error(`mediapipe.mjs: ${error.message}`));
  await page.goto(`${address}/page.html`);
  await page.evaluate((options) => setup(options), OPTIONS);
  return page;
}

async function answer(page, files, address) {
  const urls = files.map((file) => `${address}/frames/${file}`);
  await page.evaluate((first) => warmUp(first), urls[0]);
  const answers = [];
  for (let i = 0; i < urls.length; i += FRAMES_A_CALL) {
    const part = urls.slice(i, i + FRAMES_A_CALL);
    answers.push(...(await page.evaluate((some) => readAll(some), part)));
  }
  return answers.map((one, i) => ({ file: files[i], ...one }));
}

async function main(packages, frames, result) {
  const files = fs.readdirSync(frames).filter((file) => file.endsWith('.jpg')).sort();
  const hands = path.join(packages, 'node_modules/@mediapipe/hands');
  const here = path.dirname(fileURLToPath(import.meta.url));
  const server = await serve({ '/': here, '/hands': hands, '/frames': frames });
  const address = `http://127.0.0.1:${server.address().port}`;
  const browser = await launch(packages);
  try {
    const answers = await answer(await openPage(browser, address), files, address);
    fs.writeFileSync(result, answers.map((one) => JSON.stringify(one) + '\n').join(''));
    const found = answers.filter((one) => one.world.length > 0).length;
    console.log(`${path.basename(frames)}: a hand in ${found} of ${files.length} frames`);
  } finally {
    await browser.close();
    server.close();
  }
}

await main(...process.argv.slice(2));
