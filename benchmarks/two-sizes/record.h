// What all cases share: options, what is measured, the row that is printed, the box that is filled and brought to rest.
#pragma once
#include "changes.h"
#include "nested.h"

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

static const char* const Columns[] = {"particles", "fine", "coarse", "pairs_per_step", "fewest", "steps_per_time", "pairs_per_time",
    "other_per_time", "splits", "merges", "start_error_pc", "slope", "height", "v_rms1", "v_rms2", "v_rms3", "v_rms4", "period_over_theory",
    "first_quarter", "decay_per_period", "front1", "front2", "front3", "fastest", "potential_end", "kinetic_end", "spin_kept", "energy_end",
    "compressed_pc", "rarefied_pc", "wall_pc", "young_pc", "young_sum_pc", "error_max_pc", "error_rms_pc", "offset_max_pc",
    "mass_error", "momentum_error", "energy_grown", "wall_s", "plain_pc", "plain_off_pc", "body_pc",
    "body_down", "body_hold", "body_up", "body_peak", "coarse_near", "coarse_nearest", "dissolved", "listed",
    "candidates_one", "candidates_each"};

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
    double energy0 = 0, energyMost = -HUGE_VAL, mass0 = 0, massError = 0, momentumError = 0, offsetMost = 0;
    double error = 0, errorRms = 0, errorWeight = 0, compressed = 0, rarefied = 0, wallCompressed = 0, youngError = 0, youngSum = 0;
    double plain = 0, plainOff = 0, bodyError = 0;
    Vec64 momentum0;
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
        massError = std::max<double>(massError, std::fabs(q.TotalMass() / mass0 - 1));
        double scale;
        Vec64 d = q.Momentum(&scale) - momentum0;
        double lost = gravityX ? std::hypot(d.x, d.y) : Length(d);
        if (scale > 0) momentumError = std::max(momentumError, lost / scale);
        countSum += q.Count() * q.dt; countTime += q.dt;
    }
    void TakeErrors(const Liquid& q) {
        for (int i = 0; i < q.Count(); i++) {
            offsetMost = std::max<double>(offsetMost, std::fabs(q.offset[i]));
            if (q.buffer[i] || q.depth[i] < 3) continue;
            double e = q.rho[i] - 1., off = e - q.gravity * q.depth[i] / (q.c * q.c);
            if (q.youth > 0 && q.time < q.born[i] + q.youth) {
                youngError = std::max<double>(youngError, std::fabs(e));
                youngSum = std::max<double>(youngSum, std::fabs(e - q.offset[i]));
            }
            bool atWall = false;
            for (auto& w : q.walls) atWall |= Dot(w.normal, q.x[i]) - w.offset < 4.5;
            if (q.body.radius > 0 && q.BodyDistance(q.x[i]) < 4.5) { bodyError = std::max<double>(bodyError, std::fabs(e)); continue; }
            if (atWall) { wallCompressed = std::max<double>(wallCompressed, e); continue; }
            compressed = std::max<double>(compressed, e); rarefied = std::max<double>(rarefied, -e);
            error = std::max<double>(error, std::fabs(off));
            errorRms += q.m[i] * off * off; errorWeight += q.m[i];
        }
    }
    // By the plain sum, without what is carried: worst just after a change.
    void TakePlain(const Liquid& q) {
        for (int i = 0; i < q.Count(); i++) {
            if (q.buffer[i] || q.depth[i] < 3 || (q.body.radius > 0 && q.BodyDistance(q.x[i]) < 4.5)) continue;
            bool atWall = false;
            for (auto& w : q.walls) atWall |= Dot(w.normal, q.x[i]) - w.offset < 4.5;
            if (atWall) continue;
            double e = q.rho[i] - 1. - q.offset[i];
            plain = std::max<double>(plain, std::fabs(e));
            plainOff = std::max<double>(plainOff, std::fabs(e - q.gravity * q.depth[i] / (q.c * q.c)));
        }
    }
    void Print(const Liquid& q, Row& row) const {
        double t = q.time - time0;
        row("particles", countSum / std::max<double>(1e-9, countTime)); row("steps_per_time", (q.steps - steps0) / t);
        row("pairs_per_time", (q.pairsSeen - pairs0) / t); row("other_per_time", (q.otherWork - work0) / t);
        row("splits", q.splits); row("merges", q.merges);
        if (q.dissolve) row("dissolved", q.dissolved);
        row("compressed_pc", 100 * compressed); row("rarefied_pc", 100 * rarefied);
        row("wall_pc", 100 * wallCompressed); row("young_pc", 100 * youngError);
        row("young_sum_pc", 100 * youngSum);
        row("error_max_pc", 100 * error); row("error_rms_pc", 100 * std::sqrt(errorRms / std::max<double>(1e-30, errorWeight)));
        row("offset_max_pc", 100 * offsetMost);
        row("plain_pc", 100 * plain); row("plain_off_pc", 100 * plainOff);
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
    q.apart = o("apart", 0);
    q.patience = o("patience", 0);
    q.dissolve = o("dissolve", 0) > 0;
    q.search = o("search", 0) > 0;
    q.settle = int(o("settle", 0));
    q.rings = int(o("rings", 1));
    q.lookAhead = o("ahead", 3);
}

static void Jitter(Liquid& q, const Options& o) {
    unsigned seed = unsigned(o("seed", 1));
    auto random = [&] { seed = seed * 1664525u + 1013904223u; return (seed >> 8) / 8388608. - 1; };
    for (int i = 0; i < q.Count(); i++) q.x[i] += (o("jitter", .1) * q.Spacing(q.level[i])) * Vec{random(), random(), random()};
}

// Damps the liquid to rest; with offsets that never fade or fade slowly it starts from the density that rest has.
static void Relax(Liquid& q, const Options& o, double height, double t) {
    if (q.offsetTime != 0 && o("start", 1) > 0) {
        q.Density();
        for (int i = 0; i < q.Count(); i++) {
            if (q.x[i].z > height - 3) continue;
            q.offset[i] = 1 + q.gravity * (height - q.x[i].z) / (q.c * q.c) - q.rho[i];
        }
    }
    Jitter(q, o);
    q.damping = o("damp", .5) * q.c / height;
    while (q.time < t) q.Step();
    q.damping = 0;
}
