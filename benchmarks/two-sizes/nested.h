// Nested regions: each sees only its own size; buffers beside the border take velocity and pressure from the other region.
#pragma once
#include "liquid.h"

// A linear fit at p to velocity and pressure of those particles of the other region that lie around it.
struct Fit {
    double A[4][4] = {}, b[4][4] = {};
    void Take(Vec d, double w, Vec v, double p) {
        double f[4] = {1, d.x, d.y, d.z}, g[4] = {v.x, v.y, v.z, p};
        for (int r = 0; r < 4; r++) for (int s = 0; s < 4; s++) { A[r][s] += w * f[r] * f[s]; b[r][s] += w * f[r] * g[s]; }
    }
    bool Solve(double out[4]) {
        double weight = A[0][0];
        if (weight <= 0) return false;
        for (int s = 0; s < 4; s++) out[s] = b[0][s] / weight;   // the mean, where a plane cannot be told
        double B[4][8];
        for (int r = 0; r < 4; r++) for (int s = 0; s < 4; s++) {
            B[r][s] = A[r][s] + (r == s && r ? 1e-3 * weight : 0);
            B[r][s + 4] = b[r][s];
        }
        for (int k = 0; k < 4; k++) {
            if (B[k][k] < 1e-9 * weight) return true;
            for (int r = k + 1; r < 4; r++) { double f = B[r][k] / B[k][k]; for (int s = k; s < 8; s++) B[r][s] -= f * B[k][s]; }
        }
        for (int s = 0; s < 4; s++) {
            double y[4];
            for (int r = 3; r >= 0; r--) {
                y[r] = B[r][s + 4];
                for (int q = r + 1; q < 4; q++) y[r] -= B[r][q] * y[q];
                y[r] /= B[r][r];
            }
            out[s] = y[0];
        }
        return true;
    }
};

inline void Liquid::InterpolateBuffers() {
    vector<Fit> fits(Count());
    double R = Support(levelOf[1]);
    for (int i = 0; i < Count(); i++)
        if (!buffer[i]) P[i] = std::max<Real>(0, c * c * (rho[i] - 1)) / (rho[i] * rho[i]);
    for (auto [i, j] : cross) {
        Vec d = Separation(x[j], x[i]);
        double r = Length(d);
        if (r >= R) continue;
        pairsSeen += 1;
        fits[i].Take(d, m[j] * W(r, R), v[j], P[j] * rho[j] * rho[j]);
    }
    for (int i = 0; i < Count(); i++) {
        double out[4];
        if (!buffer[i] || !fits[i].Solve(out)) continue;
        v[i] = {out[0], out[1], out[2]};
        double p = std::max<double>(0, out[3]);
        rho[i] = 1 + p / (c * c);
        P[i] = p / (rho[i] * rho[i]);
    }
}

// After the drift: who has crossed the border changes between liquid and buffer, who has left a buffer goes, and the flux
// through the buffers' outer faces becomes particles.
inline void Liquid::Exchange() {
    vector<char> dead(Count(), 0);
    bool any = false, changed = false;
    int nx[2], ny[2];
    for (int s = 0; s < 2; s++) {
        double edge = Spacing(levelOf[s]);
        nx[s] = int(std::lround(period.x / edge)); ny[s] = int(std::lround(period.y / edge));
        if (ledger[s].empty()) ledger[s].assign(nx[s] * ny[s], 0);
    }
    auto patch = [&](int s, Vec p) {
        int X = std::clamp(int(p.x / period.x * nx[s]), 0, nx[s] - 1), Y = std::clamp(int(p.y / period.y * ny[s]), 0, ny[s] - 1);
        return X * ny[s] + Y;
    };
    if (shift > 0) {
        vector<Vec> gradient(Count());
        for (size_t k = 0; k < pairs.size(); k++) {
            auto [i, j] = pairs[k];
            gradient[i] += (m[j] * slopeI[k]) * direction[k];
            gradient[j] += (-m[i] * slopeI[k]) * direction[k];
        }
        for (int i = 0; i < Count(); i++) {
            double inside = level[i] == levelOf[0] ? x[i].z - (border - buffers[0]) : border + buffers[1] - x[i].z;
            if (!buffer[i] || inside < Support(level[i])) continue;   // an outer face is no surface
            Vec by = (-shift * Spacing(level[i]) * Spacing(level[i])) * gradient[i];
            x[i] += std::min<Real>(1, .1 * Spacing(level[i]) / std::max<Real>(1e-9, Length(by))) * by;
        }
    }
    for (int i = 0; i < Count(); i++) {
        int s = level[i] == levelOf[0] ? 0 : 1;
        double beyond = s == 0 ? border - x[i].z : x[i].z - border;
        char now = beyond > 0;
        if (now != buffer[i]) { buffer[i] = now; changed = true; }
        if (beyond > buffers[s]) { dead[i] = 1; any = true; ledger[s][patch(s, x[i])] += Mass(level[i]); }
    }
    // The flux at a patch is that of the buffer's particles near its face: they go with the other region's liquid.
    for (int s = 0; s < 2; s++) {
        double edge = Spacing(levelOf[s]), face = s == 0 ? border - buffers[0] : border + buffers[1];
        vector<double> speed(ledger[s].size(), 0), weight(ledger[s].size(), 0);
        for (int i = 0; i < Count(); i++) {
            if (level[i] != levelOf[s] || !buffer[i] || std::fabs(x[i].z - face) > 1.5 * edge) continue;
            int k = patch(s, x[i]);
            speed[k] += v[i].z; weight[k] += 1;
        }
        for (size_t k = 0; k < ledger[s].size(); k++) {
            double up = weight[k] > 0 ? speed[k] / weight[k] : 0, area = period.x * period.y / ledger[s].size();
            ledger[s][k] += (s == 0 ? up : -up) * area * dt / TheLattice.sum;
            double mass = Mass(levelOf[s]);
            if (ledger[s][k] < mass / 2) continue;
            ledger[s][k] -= mass;
            int X = int(k) / ny[s], Y = int(k) % ny[s];
            Vec at{(X + .5) * period.x / nx[s], (Y + .5) * period.y / ny[s], face + (s == 0 ? .5 : -.5) * edge};
            buffer[Add(at, {0, 0, up}, levelOf[s])] = 1;
            dead.push_back(0);
        }
    }
    if (any) Remove(dead);
    if (any || changed) stale = true;
}
