// Numbers as text, and vectors of three doubles. SPDX-License-Identifier: MIT

/** The double as printf("%a") writes it: "0x1.8p-2". */
function hexfloat(x) {
  if (x === 0) return Object.is(x, -0) ? '-0x0p+0' : '0x0p+0';
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, x);
  const high = bits.getUint32(0), low = bits.getUint32(4);
  const biased = (high >>> 20) & 0x7ff;
  const digits = (high & 0xfffff).toString(16).padStart(5, '0') + low.toString(16).padStart(8, '0');
  const fraction = digits.replace(/0+$/, '');
  const exponent = biased === 0 ? -1022 : biased - 1023;
  return (x < 0 ? '-' : '') + '0x' + (biased === 0 ? '0' : '1') + (fraction ? '.' + fraction : '') + 'p' +
      (exponent < 0 ? '' : '+') + exponent;
}

/** x times 2^exponent with few digits, also where that is no double: "1.2e-330". */
function shortScaled(x, exponent) {
  if (x === 0) return '0';
  const log = Math.log10(Math.abs(x)) + exponent * Math.LOG10E * Math.LN2;
  const sign = x < 0 ? '\u2212' : '';
  if (log > -3 && log < 5) return sign + Number(Math.pow(10, log).toPrecision(3)).toString();
  let power = Math.floor(log);
  let digits = Math.pow(10, log - power).toPrecision(2);
  if (digits === '10') {
    digits = '1.0';
    power += 1;
  }
  return sign + digits + 'e' + power;
}

/** The value of a polynomial, constant first. */
function valueOf(p, s) {
  let result = 0;
  for (let i = p.length; i-- > 0;) result = result * s + p[i];
  return result;
}
function vectorOf(p, s) { return [valueOf(p[0], s), valueOf(p[1], s), valueOf(p[2], s)]; }

function added(a, b) { return [a[0] + b[0], a[1] + b[1], a[2] + b[2]]; }
function times(a, x) { return [a[0] * x, a[1] * x, a[2] * x]; }
function dot(a, b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
function cross(a, b) { return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]; }
function lengthOf(a) { return Math.hypot(a[0], a[1], a[2]); }
function unit(a) {
  const size = lengthOf(a);
  return size > 0 ? times(a, 1 / size) : [0, 0, 1];
}

/** A new element with text, which is never HTML. */
function element(name, attributes, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) {
    if (key.startsWith('on')) {
      node.addEventListener(key.slice(2), value);
    } else if (value !== false) {
      node.setAttribute(key, value === true ? '' : value);
    }
  }
  node.append(...children);
  return node;
}

/** The JSON of a script element. */
function dataOf(id) { return JSON.parse(document.getElementById(id).textContent); }

/** A colour of the style sheet as [r, g, b] in [0, 1]. */
function colourOf(name) {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const number = parseInt(text.slice(1), 16);
  return [(number >> 16 & 255) / 255, (number >> 8 & 255) / 255, (number & 255) / 255];
}
