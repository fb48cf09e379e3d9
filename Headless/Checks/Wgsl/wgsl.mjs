// node wgsl.mjs CACHE FOLDER: translates each FOLDER/NUMBER.spv into WGSL by naga and gives that to Dawn, without a device. A line each on
// standard output, with tabs: number, "naga", "tint" or "limit" with a message, or "ok".
import { createRequire } from "node:module";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [cache, folder] = process.argv.slice(2);
const naga = await import(pathToFileURL(join(cache, "naga.mjs")));
naga.initSync({ module: readFileSync(join(cache, "naga_bg.wasm")) });
const { create, globals } = createRequire(import.meta.url)(join(cache, "dawn.node"));
Object.assign(globalThis, globals);
const gpu = create(["backend=null"]);
const device = await (await gpu.requestAdapter()).requestDevice(); // with the limits that every device has

const oneLine = (text) => String(text).replace(/[\s│┌─]+/gu, " ").trim();

function translate(spirV) {
    const module = naga.parseSpirv(spirV);
    return naga.writeWgsl(module, naga.validate(module));
}

async function check(file) {
    let code;
    try {
        code = translate(readFileSync(join(folder, file)));
    } catch (e) {
        return `naga\t${oneLine(e.message ?? e)}`;
    }
    device.pushErrorScope("validation");
    const module = device.createShaderModule({ code });
    const invalid = await device.popErrorScope();
    if (invalid) return `tint\t${oneLine(invalid.message)}`;
    if (!code.includes("@compute")) return "ok";
    device.pushErrorScope("validation");
    device.createComputePipeline({ layout: "auto", compute: { module } });
    const refused = await device.popErrorScope();
    return refused ? `limit\t${oneLine(refused.message.split("\n")[0])}` : "ok";
}

for (const file of readdirSync(folder).filter((name) => name.endsWith(".spv"))) console.log(`${file.slice(0, -4)}\t${await check(file)}`);
process.exit(0);
