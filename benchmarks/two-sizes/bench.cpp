// Two sizes of particle in a weakly compressible liquid: what an interface between sizes costs, with and without splits and merges.
//   g++ -std=c++17 -O3 -march=native -fno-math-errno -o bench bench.cpp
//   ./bench CASE key=value ...      CASE: count rest wave dam drop header; keys: SetUp and the cases; README.md says what they are
// One thread, double precision. Units: fine spacing dx = 1, rho0 = 1, g = 1. A run prints one row of results.csv.
#include "liquid.h"

// ---------------------------------------------------------------------------------------------- options

struct Options {
    std::map<std::string, std::string> all;
    mutable std::map<std::string, bool> asked;
    Options(int count, char** words) {
        for (int i = 2; i < count; i++) {
            std::string word = words[i];
            auto at = word.find('=');
            if (at == std::string::npos) { std::fprintf(stderr, "%s: write key=value\n", words[i]); std::exit(2); }
            all[word.substr(0, at)] = word.substr(at + 1);
        }
    }
    double operator()(const char* key, double otherwise) const {
        auto at = all.find(key);
        asked[key] = true;
        return at == all.end() ? otherwise : std::atof(at->second.c_str());
    }
    std::string Text(const char* key, const char* otherwise) const {
        auto at = all.find(key);
        asked[key] = true;
        return at == all.end() ? otherwise : at->second;
    }
};

// ---------------------------------------------------------------------------------------------- cases

static const char* const Columns[] = {"particles", "fine", "coarse", "pairs_per_step", "fewest", "steps_per_time", "pairs_per_time",
    "other_per_time", "splits", "merges", "start_error_pc", "slope", "height", "v_rms1", "v_rms2", "v_rms3", "v_rms4", "period_over_theory",
    "first_quarter", "decay_per_period", "front1", "front2", "front3", "fastest", "potential_end", "kinetic_end", "spin_kept", "energy_end",
    "compressed_pc", "rarefied_pc", "wall_pc", "young_pc", "young_sum_pc", "error_max_pc", "error_rms_pc", "offset_max_pc",
    "mass_error", "momentum_error", "energy_grown", "wall_s"};

struct Row {
    std::map<std::string, double> values;
    void operator()(const std::string& name, double value) { values[name] = value; }
    void Print(const std::string& kind, const std::string& keys) const {
        std::printf("%s,%s", kind.c_str(), keys.c_str());
        for (auto name : Columns) {
            auto at = values.find(name);
            if (at == values.end()) std::printf(","); else std::printf(",%.5g", at->second);
        }
        std::printf("\n");
    }
};

// What a run collects at every step or so, in every case.
struct Record {
    double energy0 = 0, energyMost = -1e300, mass0 = 0, massError = 0, momentumError = 0, offsetMost = 0;
    double error = 0, errorRms = 0, errorWeight = 0, compressed = 0, rarefied = 0, wallCompressed = 0, youngError = 0, youngSum = 0;
    Vec momentum0;
    long steps0 = 0, pairs0 = 0, work0 = 0;
    double time0 = 0;
    double countSum = 0, countTime = 0;
    void Start(const Liquid& q) {
        energy0 = q.Energy(); mass0 = q.TotalMass(); momentum0 = q.Momentum();
        steps0 = q.steps; pairs0 = q.pairsSeen; work0 = q.otherWork; time0 = q.time;
    }
    // The density error of what is deeper than three spacings and 4.5 from walls; hydrostatic is what c makes of a head, 0 without gravity.
    void Take(const Liquid& q, bool gravityX) {
        energyMost = std::max(energyMost, q.Energy());
        massError = std::max(massError, std::fabs(q.TotalMass() / mass0 - 1));
        double scale;
        Vec p = q.Momentum(&scale), d = p - momentum0;
        double lost = gravityX ? std::hypot(d.x, d.y) : Length(d);
        if (scale > 0) momentumError = std::max(momentumError, lost / scale);
        countSum += q.Count() * q.dt; countTime += q.dt;
    }
    void TakeErrors(const Liquid& q) {
        for (int i = 0; i < q.Count(); i++) {
            offsetMost = std::max(offsetMost, std::fabs(q.offset[i]));
            if (q.buffer[i] || q.depth[i] < 3) continue;
            double e = q.rho[i] - 1, off = e - q.gravity * q.depth[i] / (q.c * q.c);
            if (q.youth > 0 && q.time < q.born[i] + q.youth) {
                youngError = std::max(youngError, std::fabs(e));
                youngSum = std::max(youngSum, std::fabs(e - q.offset[i]));
            }
            bool atWall = false;
            for (auto& w : q.walls) atWall |= Dot(w.normal, q.x[i]) - w.offset < 4.5;
            if (atWall) { wallCompressed = std::max(wallCompressed, e); continue; }
            compressed = std::max(compressed, e); rarefied = std::max(rarefied, -e);
            error = std::max(error, std::fabs(off));
            errorRms += q.m[i] * off * off; errorWeight += q.m[i];
        }
    }
    void Print(const Liquid& q, Row& row) const {
        double t = q.time - time0;
        row("particles", countSum / std::max(1e-9, countTime)); row("steps_per_time", (q.steps - steps0) / t);
        row("pairs_per_time", (q.pairsSeen - pairs0) / t); row("other_per_time", (q.otherWork - work0) / t);
        row("splits", q.splits); row("merges", q.merges);
        row("compressed_pc", 100 * compressed); row("rarefied_pc", 100 * rarefied);
        row("wall_pc", 100 * wallCompressed); row("young_pc", 100 * youngError);
        row("young_sum_pc", 100 * youngSum);
        row("error_max_pc", 100 * error); row("error_rms_pc", 100 * std::sqrt(errorRms / std::max(1e-30, errorWeight)));
        row("offset_max_pc", 100 * offsetMost);
        row("mass_error", massError); row("momentum_error", momentumError);
    }
};

// A box of liquid of the design's sizes between the origin and `size`, compressed as at rest under its own weight.
static void Fill(Liquid& q, const std::string& design, Vec size, double depth) {
    auto layer = [&](double low, double high, int l, bool isBuffer) {
        double s = q.Spacing(l);
        int nx = int(std::lround(size.x / s)), ny = int(std::lround(size.y / s));
        int nz = std::max(1, int(std::lround((high - low) * size.x * size.y / (s * s * s * nx * ny))));
        for (int i = 0; i < nx; i++) for (int j = 0; j < ny; j++) for (int k = 0; k < nz; k++) {
            double z = low + (k + .5) * (high - low) / nz;
            z -= q.gravity * (size.z * z - z * z / 2) / (q.c * q.c);
            q.buffer[q.Add({(i + .5) * size.x / nx, (j + .5) * size.y / ny, z}, {}, l)] = isBuffer;
        }
    };
    double edge = size.z - depth;
    if (design == "uniform") layer(0, size.z, 0, false);
    else if (design == "coarse") layer(0, size.z, 1, false);
    else if (design == "graded") {
        // bands of two layers between the smallest and the largest: 1.26 and 1.59, as high as their lattices in this box need
        double at = edge;
        layer(at, size.z, 0, false);
        for (int l = 1; l <= 2; l++) {
            double s = q.Spacing(l);
            int n = int(std::lround(size.x / s)) * int(std::lround(size.y / s));
            double height = 2 * s * s * s * n / (size.x * size.y);
            layer(at - height, at, l, false);
            at -= height;
        }
        layer(0, at, 3, false);
    } else {
        layer(edge, size.z, 0, false);
        layer(0, edge, 1, false);
        if (design == "nested") {
            layer(edge - q.buffers[0], edge, 0, true);
            layer(edge, edge + q.buffers[1], 1, true);
            q.nested = true;
            q.border = edge - q.gravity * (size.z * edge - edge * edge / 2) / (q.c * q.c);
        }
    }
}

static void SetUp(Liquid& q, const Options& o, const std::string& design) {
    std::string kernel = o.Text("kernel", "mean");
    q.kernel = kernel == "max" ? PairKernel::Max : kernel == "average" ? PairKernel::Average : kernel == "own" ? PairKernel::Own
                                                                                                               : PairKernel::Mean;
    q.arity = design == "graded" || o("arity", 8) == 2 ? 2 : 8;
    q.blend = int(o("blend", 10));
    q.offsetTime = o("offset", 0);
    q.viscosityRatio = o("nu", .001);
    q.youth = o("youth", 0);
    q.youthViscosity = o("youthnu", 30);
    q.arrange = int(o("arrange", 0));
    q.accept = o("accept", 0);
    q.shift = o("shift", 0);
    q.buffers[0] = o("buffer0", 3);
    q.buffers[1] = o("buffer1", 6);
    q.compact = o("compact", 1.35);
}

// Damps the liquid to rest; with offsets that never fade or fade slowly it starts from the density that rest has.
static void Relax(Liquid& q, const Options& o, double height, double& t) {
    if (q.offsetTime != 0 && o("start", 1) > 0) {
        q.Density();
        for (int i = 0; i < q.Count(); i++) {
            if (q.x[i].z > height - 3) continue;
            q.offset[i] = 1 + q.gravity * (height - q.x[i].z) / (q.c * q.c) - q.rho[i];
        }
    }
    unsigned seed = unsigned(o("seed", 1));
    auto random = [&] { seed = seed * 1664525u + 1013904223u; return (seed >> 8) / 8388608. - 1; };
    for (int i = 0; i < q.Count(); i++) q.x[i] += (o("jitter", .1) * q.Spacing(q.level[i])) * Vec{random(), random(), random()};
    q.damping = o("damp", .5) * q.c / height;
    while (q.time < t) q.Step();
    q.damping = 0;
}

static void Rest(const Options& o, Row& row) {
    std::string design = o.Text("design", "uniform");
    double H = o("H", 36), width = o("w", 12), D = o("D", 6);
    int every = int(o("every", 10));
    bool dynamic = o("dynamic", 0) > 0;
    Liquid q;
    SetUp(q, o, design);
    q.c = std::sqrt(H / o("eta", .01));
    q.period = {width, width, 0};
    q.walls = {{{0, 0, 1}, 0}};
    Fill(q, design, {width, width, H}, D);
    q.Density();
    q.Forces();
    q.FindDepths();
    double start = 0;
    for (int i = 0; i < q.Count(); i++)
        if (!q.buffer[i] && q.depth[i] > 3) start = std::max(start, std::fabs(q.rho[i] - 1 - q.depth[i] / (q.c * q.c)));
    double relax = o("relax", 2) * std::sqrt(H), end = relax + o("T", 20) * std::sqrt(H);
    Relax(q, o, H, relax);
    Record record;
    record.Start(q);
    double speed[4] = {}, weights[4] = {}, zz = 0, zp = 0, z1 = 0, p1 = 0, n1 = 0, top = 0, topWeight = 0;
    while (q.time < end) {
        double swung = D + o("swing", 0) * std::sin(2 * Pi * (q.time - relax) / (4 * std::sqrt(H)));
        if (dynamic && q.steps % every == 0) q.Adapt(swung, o("slack", .7), q.arity == 2 ? 3 : 1);
        q.Step();
        record.Take(q, true);
        int part = std::min(3, int(4 * (q.time - relax) / (end - relax)));
        double sum = 0, mass = 0;
        for (int i = 0; i < q.Count(); i++) if (!q.buffer[i]) { sum += q.m[i] * Dot(q.v[i], q.v[i]); mass += q.m[i]; }
        speed[part] += std::sqrt(sum / mass) * q.dt; weights[part] += q.dt;
        if (q.steps % 20) continue;
        q.FindDepths();
        record.TakeErrors(q);
        double centre = 0;
        for (int i = 0; i < q.Count(); i++) if (!q.buffer[i]) centre += q.m[i] / mass * q.x[i].z;
        top += 2 * centre; topWeight++;
        for (int i = 0; i < q.Count(); i++) {
            if (q.buffer[i] || q.x[i].z < 5 || q.depth[i] < 3) continue;
            double w = q.m[i], z = q.x[i].z, p = q.P[i] * q.rho[i] * q.rho[i];
            n1 += w; z1 += w * z; p1 += w * p; zz += w * z * z; zp += w * z * p;
        }
    }
    double slope = -(n1 * zp - z1 * p1) / (n1 * zz - z1 * z1);
    row("start_error_pc", 100 * start);
    row("slope", slope); row("height", top / topWeight / H);
    for (int k = 0; k < 4; k++) row((std::string("v_rms") + char('1' + k)), speed[k] / weights[k] / std::sqrt(H));
    record.Print(q, row);
    row("energy_grown", (record.energyMost - record.energy0) / (record.mass0 * H));
}

static void Wave(const Options& o, Row& row) {
    std::string design = o.Text("design", "uniform");
    double H = o("H", 32), L = o("L", 80), width = o("w", 10), D = o("D", 6), A = o("A", 3), k = 2 * Pi / L;
    int every = int(o("every", 10));
    bool dynamic = o("dynamic", 0) > 0;
    Liquid q;
    SetUp(q, o, design);
    q.c = std::sqrt(H / o("eta", .01));
    q.period = {L, width, 0};
    q.walls = {{{0, 0, 1}, 0}};
    Fill(q, design, {L, width, H}, D);
    double relax = o("relax", 1.5) * std::sqrt(H);
    Relax(q, o, H, relax);
    // Starts as it passes through rest level: a liquid that is moved to a crest at once is sheared by k A, and jolts.
    double omega = std::sqrt(k * std::tanh(k * H)), period = 2 * Pi / omega, before = 0, at = q.time, begin = q.time, peak = 0;
    for (int i = 0; i < q.Count(); i++) {
        double X = k * q.x[i].x, Z = k * q.x[i].z, f = A * omega / std::sinh(k * H);
        q.v[i] = {-f * std::cosh(Z) * std::sin(X), 0, f * std::sinh(Z) * std::cos(X)};
    }
    q.Density();
    vector<double> zeros, peaks;
    Record record;
    record.Start(q);
    while (q.time < begin + o("periods", 2.3) * period) {
        if (dynamic && q.steps % every == 0) q.Adapt(D, o("slack", .7), q.arity == 2 ? 3 : 1);
        q.Step();
        record.Take(q, true);
        if (q.steps % 20 == 0) { q.FindDepths(); record.TakeErrors(q); }
        double sum = 0, weight = 0;
        for (int i = 0; i < q.Count(); i++) {
            if (q.buffer[i]) continue;
            double f = q.m[i] * std::exp(k * (q.x[i].z - H)), s = std::cos(k * q.x[i].x);
            sum += f * q.v[i].z * s; weight += f * s * s;
        }
        double now = sum / weight, t = q.time - begin;
        if (before * now < 0 && t > .15 * period && (zeros.empty() || t - zeros.back() > .3 * period)) {
            zeros.push_back(at + (t - at) * before / (before - now));
            peaks.push_back(peak);
            peak = 0;
        }
        peak = std::max(peak, std::fabs(now));
        before = now; at = t;
    }
    int n = int(zeros.size());
    row("period_over_theory", n > 1 ? 2 * (zeros[n - 1] - zeros[0]) / (n - 1) / period : 0);
    row("first_quarter", n ? 4 * zeros[0] / period : 0);
    row("decay_per_period", n > 1 ? 2 * std::log(peaks[0] / peaks[n - 1]) / (n - 1) : 0);
    record.Print(q, row);
    row("energy_grown", (record.energyMost - record.energy0) / (.25 * A * A * L * width));
}

static void Dam(const Options& o, Row& row) {
    std::string design = o.Text("design", "uniform");
    double H = o("H", 36), B = o("B", 36), L = o("L", 108), width = o("w", 10), D = o("D", 6);
    int every = int(o("every", 10));
    Liquid q;
    SetUp(q, o, design);
    q.c = 10 * std::sqrt(2 * H);
    q.period = {0, width, 0};
    q.walls = {{{0, 0, 1}, 0}, {{1, 0, 0}, 0}, {{-1, 0, 0}, -L}};
    Fill(q, "uniform", {B, width, H}, D);
    q.Density();
    q.Forces();
    if (design != "uniform") q.Adapt(D, o("slack", .7), q.arity == 2 ? 3 : 1);
    Record record;
    record.Start(q);
    double end = o("T", 10) * std::sqrt(H), front[3] = {}, fastest = 0, least = 1e9;
    while (q.time < end) {
        if (design != "uniform" && q.steps % every == 0) q.Adapt(D, o("slack", .7), q.arity == 2 ? 3 : 1);
        q.Step();
        record.Take(q, true);
        if (q.steps % 20 == 0) { q.FindDepths(); record.TakeErrors(q); }
        fastest = std::max(fastest, q.Fastest());
        least = std::min(least, double(q.Count()));
        for (int k = 0; k < 3; k++)
            if (front[k] == 0 && q.time > (k + 1) * .7 * std::sqrt(H)) {
                vector<double> ahead;
                for (auto& p : q.x) ahead.push_back(p.x);
                std::nth_element(ahead.begin(), ahead.begin() + 6, ahead.end(), std::greater<double>());
                front[k] = ahead[6] / B;
            }
    }
    for (int k = 0; k < 3; k++) row((std::string("front") + char('1' + k)), front[k]);
    double potential = 0, kinetic = 0;
    for (int i = 0; i < q.Count(); i++) { potential += q.m[i] * q.x[i].z; kinetic += .5 * q.m[i] * Dot(q.v[i], q.v[i]); }
    row("potential_end", potential / record.energy0); row("kinetic_end", kinetic / record.energy0);
    row("fastest", fastest / std::sqrt(2 * H)); row("fewest", least);
    record.Print(q, row);
    row.values.erase("momentum_error");   // walls push
    row("energy_grown", (record.energyMost - record.energy0) / record.energy0);
}

// A cube in free flight that turns, and whose sizes are made to change: what splits and merges do to mass, momentum and energy.
static void Drop(const Options& o, Row& row) {
    std::string design = o.Text("design", "uniform");
    int n = int(o("n", 20)), every = int(o("every", 10));
    double D = o("D", 5);
    Liquid q;
    SetUp(q, o, design);
    q.gravity = 0;
    q.c = o("c", 10);
    Fill(q, "uniform", {double(n), double(n), double(n)}, D);
    for (int i = 0; i < q.Count(); i++) {
        Vec d = q.x[i] - Vec{n / 2., n / 2., n / 2.};
        q.v[i] = Vec{.5, .2, .1} + (1. / n) * Vec{-d.y, d.x, .0};
    }
    q.Density();
    q.Forces();
    Record record;
    record.Start(q);
    double end = o("T", 30), spin0 = 0, spin = 0;
    auto turning = [&] {
        double s = 0, mass = 0;
        Vec c{}, u{};
        for (int i = 0; i < q.Count(); i++) { c += q.m[i] * q.x[i]; u += q.m[i] * q.v[i]; mass += q.m[i]; }
        c = (1 / mass) * c; u = (1 / mass) * u;
        for (int i = 0; i < q.Count(); i++) { Vec d = q.x[i] - c, w = q.v[i] - u; s += q.m[i] * (d.x * w.y - d.y * w.x); }
        return s;
    };
    spin0 = turning();
    while (q.time < end) {
        double swung = D + 2 * std::sin(2 * Pi * q.time / 5);
        if (design != "uniform" && q.steps % every == 0) q.Adapt(swung, o("slack", .7), q.arity == 2 ? 3 : 1);
        q.Step();
        record.Take(q, false);
        if (q.steps % 20 == 0) { q.FindDepths(); record.TakeErrors(q); }
    }
    spin = turning();
    row("spin_kept", spin / spin0);
    record.Print(q, row);
    row("energy_end", q.Energy() / record.energy0);
    row("energy_grown", (record.energyMost - record.energy0) / record.energy0);
}

// A pool of equal particles and of two sizes, as lattices: particles, and pairs that a step's two passes visit.
static void Count(const Options& o, Row& row) {
    int X = int(o("X", 100)), Y = int(o("Y", 100)), Z = int(o("Z", 100));
    double D = o("D", 6);
    bool sides = o("sides", 0) > 0, floorToo = o("floor", 0) > 0;
    std::string design = o.Text("design", "mixed");
    Liquid q;
    SetUp(q, o, design);
    q.gravity = 0;
    auto fine = [&](double x, double y, double z) {
        double d = Z - z;
        if (floorToo) d = std::min(d, z);
        if (sides) d = std::min(std::min(d, std::min(x, X - x)), std::min(y, Y - y));
        return d < D;
    };
    if (design == "graded" || design == "nested") {
        q.period = {double(X), double(Y), 0};
        Fill(q, design, {double(X), double(Y), double(Z)}, D);
    } else for (int i = 0; i + 1 < X; i += 2) for (int j = 0; j + 1 < Y; j += 2) for (int k = Z % 2; k + 1 < Z; k += 2) {
        if (design != "uniform" && !fine(i + 1, j + 1, k + 1)) { q.Add({i + 1., j + 1., k + 1.}, {}, 1); continue; }
        for (int e = 0; e < 8; e++) q.Add({i + .5 + (e & 1), j + .5 + (e >> 1 & 1), k + .5 + (e >> 2)}, {}, 0);
    }
    q.Density();
    if (q.nested) q.InterpolateBuffers();
    long levels[4] = {};
    for (int l : q.level) levels[l]++;
    row("particles", q.Count()); row("fine", double(levels[0])); row("coarse", double(q.Count() - levels[0]));
    row("pairs_per_step", double(q.pairsSeen));
}

int main(int count, char** words) {
    std::string kind = count > 1 ? words[1] : "";
    Options o(count, words);
    Row row;
    auto begin = std::chrono::steady_clock::now();
    if (kind == "rest") Rest(o, row);
    else if (kind == "wave") Wave(o, row);
    else if (kind == "dam") Dam(o, row);
    else if (kind == "drop") Drop(o, row);
    else if (kind == "count") Count(o, row);
    else if (kind == "header") {
        std::printf("case,options");
        for (auto name : Columns) std::printf(",%s", name);
        std::printf("\n");
        return 0;
    } else { std::fprintf(stderr, "bench: write count, rest, wave, dam, drop or header, then key=value\n"); return 2; }
    double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    row("wall_s", wall);
    std::string keys;
    for (auto& [key, value] : o.all)
        if (!o.asked.count(key)) std::fprintf(stderr, "bench: %s has no use for %s\n", kind.c_str(), key.c_str());
    for (auto& [key, value] : o.all) keys += (keys.empty() ? "" : " ") + key + "=" + value;
    row.Print(kind, keys);
}
