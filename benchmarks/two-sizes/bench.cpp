// Two sizes of particle in a weakly compressible liquid: what an interface between sizes costs, with and without splits and merges.
//   g++ -std=c++17 -O3 -march=native -fno-math-errno -o bench bench.cpp
//   ./bench CASE key=value ...      CASE: count rest wave dam drop body header; README.md says what the keys are
// One thread; double precision, with -DSINGLE -fsingle-precision-constant single. Units: fine spacing dx = 1, rho0 = 1, g = 1. A run prints
// one row of results.csv.
#include "record.h"

// Errors every twenty steps, and by the plain sum also just after splits and merges.
static void Measure(Liquid& q, Record& record, int every) {
    if (q.steps % 20 == 0) { q.FindDepths(); record.TakeErrors(q); }
    if (q.steps % 20 == 0 || q.steps % every == 1) record.TakePlain(q);
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
        if (!q.buffer[i] && q.depth[i] > 3) start = std::max<double>(start, std::fabs(q.rho[i] - 1 - q.depth[i] / (q.c * q.c)));
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
        Measure(q, record, every);
        if (q.steps % 20) continue;
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
        Measure(q, record, every);
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
        peak = std::max<double>(peak, std::fabs(now));
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
    q.walls = {{{0, 0, 1}, 0}, {{1, 0, 0}, 0}, {{-1, 0, 0}, Real(-L)}};
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
        Measure(q, record, every);
        fastest = std::max<double>(fastest, q.Fastest());
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
        Measure(q, record, every);
    }
    spin = turning();
    row("spin_kept", spin / spin0);
    record.Print(q, row);
    row("energy_end", q.Energy() / record.energy0);
    row("energy_grown", (record.energyMost - record.energy0) / record.energy0);
}

// A sphere goes down into a pool at a given speed, stops at mid-depth, and comes up: fine particles are asked for round it.
static void Sphere(const Options& o, Row& row) {
    std::string design = o.Text("design", "uniform");
    double H = o("H", 40), width = o("w", 44), D = o("D", 6), r = o("r", 4.5), U = o("U", .25) * std::sqrt(H), ramp = o("ramp", 3),
        hold = o("hold", 10);
    int every = int(o("every", 10));
    bool dynamic = o("dynamic", 0) > 0;
    Liquid q;
    SetUp(q, o, design);
    q.c = std::sqrt(H / o("eta", .01));
    q.period = {width, width, 0};
    q.walls = {{{0, 0, 1}, 0}};
    Fill(q, design, {width, width, H}, D);
    double relax = o("relax", 2) * std::sqrt(H), top = H + r + .5, way = top - H / 2, travel = way / U + ramp;
    Relax(q, o, H, relax);
    q.body.radius = r;
    q.body.at = {width / 2, width / 2, top};
    // The way down, gone after so long: speed rises and falls within `ramp`.
    auto gone = [&](double t) {
        t = std::clamp<double>(t, 0, travel);
        double s = std::min<double>(t, travel - t), part = s < ramp ? U * s * s / (2 * ramp) : U * (s - ramp / 2);
        return t > travel / 2 ? way - part : part;
    };
    auto height = [&](double t) { return t < travel + hold ? top - gone(t) : top - way + gone(t - travel - hold); };
    Record record;
    q.Density();
    record.Start(q);
    double begin = q.time, end = begin + 2 * travel + hold + o("after", 5), nearest = 1e9, peak = 0, mean = 0;
    double parts[3] = {}, lengths[3] = {}, before = 0;
    long near = 0;
    while (q.time < end) {
        double t = q.time - begin, next = .6 * q.Support(0) / (q.c + q.Fastest());
        q.body.at.z = height(t);
        q.body.speed = {0, 0, (height(t + next) - height(t)) / next};
        if (dynamic && q.steps % every == 0) q.Adapt(D, o("slack", .7), q.arity == 2 ? 3 : 1);
        q.Step();
        record.Take(q, true);
        Measure(q, record, every);
        double force = (q.body.impulse.z - before) / q.dt;
        before = q.body.impulse.z;
        mean += std::min<double>(1, q.dt) * (force - mean);   // over 1 sqrt(dx/g)
        peak = std::max(peak, std::fabs(mean));
        int part = t < travel ? 0 : t < travel + hold ? 1 : 2;
        if (part != 1 || t > travel + hold / 2) { parts[part] += force * q.dt; lengths[part] += q.dt; }
        long close = 0;
        for (int i = 0; i < q.Count(); i++) {
            if (q.level[i] == 0) continue;
            double d = q.BodyDistance(q.x[i]);
            nearest = std::min(nearest, d);
            close += d < 3;
        }
        near = std::max(near, close);
    }
    double lift = 4 * Pi / 3 * r * r * r;
    row("body_pc", 100 * record.bodyError); row("body_peak", peak / lift);
    const char* names[3] = {"body_down", "body_hold", "body_up"};
    for (int k = 0; k < 3; k++) row(names[k], parts[k] / lift / lengths[k]);
    if (design != "uniform") { row("coarse_near", double(near)); row("coarse_nearest", nearest); }
    record.Print(q, row);
    row("energy_end", (q.Energy() - record.energy0) / q.body.work);
    row("energy_grown", (record.energyMost - record.energy0) / q.body.work);
}

// The box of a graded liquid whose top has D of fine particles, and whose sides and floor have `walls` of them: shells of two layers of
// the sizes between, each a lattice that fits its box.
static void FillShells(Liquid& q, Vec size, double D, double walls, bool sides, bool floor) {
    Vec low{}, high = size;
    for (int l = 0; l < 4; l++) {
        double s = q.Spacing(l);
        int n[3] = {int(std::lround((high.x - low.x) / s)), int(std::lround((high.y - low.y) / s)), int(std::lround((high.z - low.z) / s))};
        Vec edge{(high.x - low.x) / n[0], (high.y - low.y) / n[1], (high.z - low.z) / n[2]};
        int side = !sides ? 0 : l ? 2 : int(walls), bottom = !floor ? 0 : l ? 2 : int(walls), top = l ? 2 : int(D);
        for (int i = 0; i < n[0]; i++) for (int j = 0; j < n[1]; j++) for (int k = 0; k < n[2]; k++) {
            bool shell = std::min(std::min(i, n[0] - 1 - i), std::min(j, n[1] - 1 - j)) < side || k < bottom || n[2] - 1 - k < top;
            if (shell || l == 3) q.Add({low.x + (i + .5) * edge.x, low.y + (j + .5) * edge.y, low.z + (k + .5) * edge.z}, {}, l);
        }
        low += Vec{side * edge.x, side * edge.y, bottom * edge.z};
        high = high - Vec{side * edge.x, side * edge.y, top * edge.z};
    }
}

// Particles that a search tests: in the 27 cells round each, of one grid with cells of the largest support; or in a grid a size with
// cells of that size's support, where a particle looks in its own and in coarser grids, and a pair goes into both lists.
static long Candidates(const Liquid& q, bool gridEach) {
    int levels = 0;
    for (int l : q.level) levels = std::max(levels, l + 1);
    long sum = 0;
    for (int b = gridEach ? 0 : levels - 1; b < levels; b++) {
        double edge = q.Support(b);
        std::map<std::array<int, 3>, std::pair<long, long>> cells;   // those that are in the grid, and those that look in it
        for (int i = 0; i < q.Count(); i++) {
            auto& cell = cells[{int(std::floor(q.x[i].x / edge)), int(std::floor(q.x[i].y / edge)), int(std::floor(q.x[i].z / edge))}];
            cell.first += !gridEach || q.level[i] == b;
            cell.second += q.level[i] <= b;
        }
        for (auto& [at, here] : cells)
            for (int p = -1; p <= 1; p++) for (int r = -1; r <= 1; r++) for (int s = -1; s <= 1; s++) {
                auto found = cells.find({at[0] + p, at[1] + r, at[2] + s});
                if (found != cells.end()) sum += here.second * found->second.first;
            }
    }
    return sum;
}

// A pool of equal particles and of two sizes, as lattices: particles, pairs that a step's two passes visit, and candidates of a search.
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
    if (design == "graded" && (sides || floorToo)) FillShells(q, Vec(X, Y, Z), D, o("walls", D), sides, floorToo);
    else if (design == "graded" || design == "nested") {
        q.period = Vec(X, Y, 0);
        Fill(q, design, Vec(X, Y, Z), D);
    } else for (int i = 0; i + 1 < X; i += 2) for (int j = 0; j + 1 < Y; j += 2) for (int k = Z % 2; k + 1 < Z; k += 2) {
        if (design != "uniform" && !fine(i + 1, j + 1, k + 1)) { q.Add({i + 1., j + 1., k + 1.}, {}, 1); continue; }
        for (int e = 0; e < 8; e++) q.Add({i + .5 + (e & 1), j + .5 + (e >> 1 & 1), k + .5 + (e >> 2)}, {}, 0);
    }
    if (o("jitter", 0) > 0) Jitter(q, o);
    q.Density();
    if (q.nested) q.InterpolateBuffers();
    long levels[4] = {};
    for (int l : q.level) levels[l]++;
    row("particles", q.Count()); row("fine", double(levels[0])); row("coarse", double(q.Count() - levels[0]));
    row("pairs_per_step", double(q.pairsSeen));
    if (o("cells", 0) > 0) {
        row("listed", double(q.pairsSeen) / 2);
        row("candidates_one", double(Candidates(q, false)));
        row("candidates_each", double(Candidates(q, true)));
    }
}

int main(int count, char** words) {
    std::string kind = count > 1 ? words[1] : "";
    Options o(count, words);
    bool asksFloat = o.Text("real", "double") == "float";
#ifdef SINGLE
    (void)asksFloat;
    o.all["real"] = "float";
#else
    if (asksFloat) { std::fprintf(stderr, "bench: build it with -DSINGLE for real=float\n"); return 2; }
#endif
    Row row;
    auto begin = std::chrono::steady_clock::now();
    if (kind == "rest") Rest(o, row);
    else if (kind == "wave") Wave(o, row);
    else if (kind == "dam") Dam(o, row);
    else if (kind == "drop") Drop(o, row);
    else if (kind == "count") Count(o, row);
    else if (kind == "body") Sphere(o, row);
    else if (kind == "header") {
        std::printf("case,options");
        for (auto name : Columns) std::printf(",%s", name);
        std::printf("\n");
        return 0;
    } else { std::fprintf(stderr, "bench: write count, rest, wave, dam, drop, body or header, then key=value\n"); return 2; }
    double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    row("wall_s", wall);
    std::string keys;
    for (auto& [key, value] : o.all)
        if (!o.asked.count(key)) std::fprintf(stderr, "bench: %s has no use for %s\n", kind.c_str(), key.c_str());
    for (auto& [key, value] : o.all) keys += (keys.empty() ? "" : " ") + key + "=" + value;
    row.Print(kind, keys);
}
