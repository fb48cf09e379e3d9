// A weakly compressible liquid whose particles may have several sizes: pairs, forces, splits and merges, nested regions.
// Units: fine spacing 1, rest density 1, gravity 1. bench.cpp has the cases.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>
using std::vector;

struct Vec {
    double x = 0, y = 0, z = 0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline void operator+=(Vec& a, Vec b) { a = a + b; }
inline double Dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double Length(Vec a) { return std::sqrt(Dot(a, a)); }

// ---------------------------------------------------------------------------------------------- kernel and wall

constexpr double Pi = 3.14159265358979323846, Kappa = 2.25, KernelScale = 21 / (2 * Pi);

// Wendland C2 of support R, and its slope over r.
inline double W(double r, double R) {
    double q = r / R, u = 1 - q;
    return q < 1 ? KernelScale * u * u * u * u * (4 * q + 1) / (R * R * R) : 0;
}
inline double G(double r, double R) {
    double q = r / R, u = 1 - q;
    return q < 1 ? -20 * KernelScale * u * u * u / (R * R * R * R * R) : 0;
}

inline void Kernel(double r, double R, double& value, double& slope) {
    double inverse = 1 / R, q = r * inverse, u = q < 1 ? 1 - q : 0, scale = KernelScale * inverse * inverse * inverse * u * u * u;
    value = scale * u * (4 * q + 1);
    slope = -20 * scale * inverse * inverse;
}

// Sum of the kernel over the lattice, and its moment M: a lattice compressed by 1 % raises its sum by M %.
struct Lattice {
    double sum = 0, moment = 0;
    Lattice() {
        for (int i = -2; i <= 2; i++)
            for (int j = -2; j <= 2; j++)
                for (int k = -2; k <= 2; k++) {
                    double r = std::sqrt(double(i * i + j * j + k * k));
                    sum += W(r, Kappa);
                    moment -= i * i * G(r, Kappa);
                }
        moment /= sum;
    }
};
static const Lattice TheLattice;

// Density that a wall at distance d adds: three mirror layers of the particle's own spacing. Its slope is the force's.
static void WallShare(double d, double dx, double& share, double& slope) {
    double R = Kappa * dx;
    share = slope = 0;
    for (int layer = 0; layer < 3; layer++) {
        double z = (2 * std::max(d, 0.) + layer * dx) / R;
        if (z >= 1) break;
        double z2 = z * z, u = 1 - z;
        share += 21 * (1. / 14 - z2 * (.5 - 2.5 * z2 + 4 * z2 * z - 2.5 * z2 * z2 + 4. / 7 * z2 * z2 * z)) / Kappa;
        slope -= 42 / (Kappa * R) * z * u * u * u * u * (4 * z + 1);
    }
}

// ---------------------------------------------------------------------------------------------- liquid

// What a pair's kernel is where supports differ: of the mean, of the larger, the mean of both kernels, or each particle's own
// (density by its own support, forces by both: the gradient of the same energy).
enum class PairKernel { Mean, Max, Average, Own };

struct Wall {
    Vec normal;
    double offset;
};

// A particle that becomes `children`, or the other way round. Until the blend ends both are there and share the mass; the parent is
// carried by the children's centre.
struct Group {
    int parent, step = 0;
    vector<int> children;
    bool splits;
};

class Liquid {
public:
    // set by a case
    PairKernel kernel = PairKernel::Mean;
    int arity = 8;                 // parts of a split: 8 for spacings 1 and 2, 2 for spacings 1, 1.26, 1.59 and 2
    bool nested = false;           // particles of different levels do not see each other
    Vec period{0, 0, 0};           // 0: not periodic
    vector<Wall> walls;
    double c = 10, gravity = 1, viscosityRatio = .001, damping = 0;
    int blend = 10;                // steps of a split or merge
    double offsetTime = 0;         // time in which a density offset fades; 0: none are made, < 0: never
    double youth = 0, youthViscosity = 0;   // for how long what is new is more viscous, and by how many times

    // particles
    vector<Vec> x, v, a;
    vector<double> m, rho, P, offset, depth, born;
    vector<int> level, group;
    vector<char> buffer;

    vector<Group> groups;
    double time = 0, dt = 0;
    long steps = 0, pairsSeen = 0, otherWork = 0, splits = 0, merges = 0;
    bool stale = true;

    double Spacing(int l) const { return std::cbrt(std::pow(double(arity), l)); }
    double Support(int l) const { return Kappa * Spacing(l); }
    double Mass(int l) const { return std::pow(double(arity), l) / TheLattice.sum; }
    int Count() const { return int(x.size()); }

    int Add(Vec at, Vec speed, int l) {
        x.push_back(at); v.push_back(speed); a.push_back({}); m.push_back(Mass(l)); rho.push_back(1); P.push_back(0);
        offset.push_back(0); depth.push_back(0); born.push_back(-1e9); level.push_back(l); group.push_back(-1); buffer.push_back(0);
        stale = true;
        return Count() - 1;
    }

    Vec Separation(Vec p, Vec q) const {
        Vec d = p - q;
        if (period.x > 0) d.x -= period.x * std::rint(d.x / period.x);
        if (period.y > 0) d.y -= period.y * std::rint(d.y / period.y);
        return d;
    }

    double PairSupport(int a, int b) const {
        double A = Support(a), B = Support(b);
        return kernel == PairKernel::Mean ? (A + B) / 2 : std::max(A, B);
    }

    // Pairs within their support and a skin, found in one grid per level; kept until something has gone half the skin.
    struct Pair { int i, j; };
    vector<Pair> pairs, cross;
    void FindPairs() {
        const double skin = 1.1;
        pairs.clear(); cross.clear(); places = x;
        int levels = 0;
        for (int l : level) levels = std::max(levels, l + 1);
        vector<vector<int>> of(levels);
        for (int i = 0; i < Count(); i++) of[level[i]].push_back(i);
        for (int b = 0; b < levels; b++) {
            if (of[b].empty()) continue;
            double width = Support(b) * skin;
            Vec low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
            for (auto& p : x) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
            }
            if (period.x > 0) { low.x = 0; high.x = period.x; }
            if (period.y > 0) { low.y = 0; high.y = period.y; }
            double lows[3] = {low.x, low.y, low.z}, sizes[3] = {high.x - low.x, high.y - low.y, high.z - low.z};
            bool loops[3] = {period.x > 0, period.y > 0, false};
            int n[3];
            double w[3];
            for (int k = 0; k < 3; k++) {
                n[k] = std::clamp(int(sizes[k] / width), 1, 400);
                w[k] = std::max(width, sizes[k] / n[k]);
            }
            auto cell = [&](Vec p, int k) {
                double q = (k == 0 ? p.x : k == 1 ? p.y : p.z) - lows[k];
                return std::min(std::max(int(std::floor(q / w[k])), 0), n[k] - 1);
            };
            vector<int> start(n[0] * n[1] * n[2] + 1, 0), order(of[b].size()), at(of[b].size());
            for (size_t k = 0; k < of[b].size(); k++) {
                Vec p = x[of[b][k]];
                at[k] = (cell(p, 0) * n[1] + cell(p, 1)) * n[2] + cell(p, 2);
                start[at[k] + 1]++;
            }
            for (size_t k = 1; k < start.size(); k++) start[k] += start[k - 1];
            vector<int> fill(start.begin(), start.end() - 1);
            for (size_t k = 0; k < of[b].size(); k++) order[fill[at[k]]++] = of[b][k];
            auto range = [&](int at, int k, int* out) {
                int count = 0;
                if (n[k] < 3) for (int q = 0; q < n[k]; q++) out[count++] = q;
                else for (int q = at - 1; q <= at + 1; q++) {
                    if (loops[k]) out[count++] = (q + n[k]) % n[k];
                    else if (q >= 0 && q < n[k]) out[count++] = q;
                }
                return count;
            };
            for (int l = 0; l <= b; l++) {
                double reach = (nested ? Support(b) : PairSupport(l, b)) * skin, reach2 = reach * reach;
                for (int i : of[l]) {
                    int X[3], Y[3], Z[3];
                    int nx = range(cell(x[i], 0), 0, X), ny = range(cell(x[i], 1), 1, Y), nz = range(cell(x[i], 2), 2, Z);
                    for (int p = 0; p < nx; p++) for (int q = 0; q < ny; q++) for (int s = 0; s < nz; s++) {
                        int k = (X[p] * n[1] + Y[q]) * n[2] + Z[s];
                        for (int e = start[k]; e < start[k + 1]; e++) {
                            int j = order[e];
                            if ((l == b && j <= i) || (nested && l != b && buffer[i] == buffer[j])) continue;
                            Vec d = Separation(x[i], x[j]);
                            if (Dot(d, d) >= reach2) continue;
                            if (!nested || l == b) pairs.push_back({i, j});
                            else cross.push_back(buffer[i] ? Pair{i, j} : Pair{j, i});
                        }
                    }
                }
            }
        }
        direction.resize(pairs.size()); slopeI.resize(pairs.size()); slopeJ.resize(pairs.size());
        stale = false;
    }

    // The wall's density and its gradient at particle i.
    double WallDensity(int i, Vec& gradient) const {
        double share[4], slope[4], rest = 1;
        int count = 0;
        const Wall* seen[4];
        for (auto& w : walls) {
            double d = Dot(w.normal, x[i]) - w.offset;
            if (d >= Support(level[i]) / 2 || count == 4) continue;
            seen[count] = &w;
            WallShare(d, Spacing(level[i]), share[count], slope[count]);
            rest *= 1 - share[count++];
        }
        gradient = {};
        for (int k = 0; k < count; k++) {
            double others = 1;
            for (int q = 0; q < count; q++) if (q != k) others *= 1 - share[q];
            gradient += (slope[k] * others) * seen[k]->normal;
        }
        return 1 - rest;
    }

    void Density() {
        if (!stale) {
            double gone = 0;
            for (int i = 0; i < Count(); i++) { Vec d = Separation(x[i], places[i]); gone = std::max(gone, Dot(d, d)); }
            if (std::sqrt(gone) > .05 * Support(0) * .98) stale = true;
        }
        if (stale) FindPairs();
        wallGradient.resize(Count());
        for (int i = 0; i < Count(); i++) rho[i] = m[i] * W(0, Support(level[i])) + WallDensity(i, wallGradient[i]);
        double support[4], far2[4][4];
        for (int l = 0; l < 4; l++) support[l] = Support(l);
        for (int k = 0; k < 4; k++) for (int l = 0; l < 4; l++) far2[k][l] = std::pow(k == l ? support[k] : PairSupport(k, l), 2);
        for (size_t k = 0; k < pairs.size(); k++) {
            auto [i, j] = pairs[k];
            Vec d = Separation(x[i], x[j]);
            double r2 = Dot(d, d), toI, toJ;
            direction[k] = d;
            slopeI[k] = slopeJ[k] = 0;
            if (r2 >= far2[level[i]][level[j]]) continue;
            double r = std::sqrt(r2), A = support[level[i]], B = support[level[j]];
            if (level[i] == level[j] || kernel == PairKernel::Mean || kernel == PairKernel::Max) {
                double R = kernel == PairKernel::Max ? std::max(A, B) : (A + B) / 2;
                Kernel(r, R, toI, slopeI[k]);
                toJ = toI;
                slopeJ[k] = slopeI[k];
            } else {
                Kernel(r, A, toI, slopeI[k]);
                Kernel(r, B, toJ, slopeJ[k]);
                if (kernel == PairKernel::Average) { toI = toJ = (toI + toJ) / 2; slopeI[k] = slopeJ[k] = (slopeI[k] + slopeJ[k]) / 2; }
            }
            pairsSeen += 4;    // density and force passes see it from both sides
            rho[i] += m[j] * toI;
            rho[j] += m[i] * toJ;
        }
        for (int i = 0; i < Count(); i++) rho[i] = 1 + (rho[i] - 1) / TheLattice.moment + offset[i];
    }

    void Forces() {
        for (int i = 0; i < Count(); i++) {
            if (!buffer[i]) P[i] = std::max(0., c * c * (rho[i] - 1)) / (rho[i] * rho[i]);
            a[i] = (-P[i] / TheLattice.moment) * wallGradient[i];
        }
        double support[4];
        for (int l = 0; l < 4; l++) support[l] = Support(l);
        for (size_t k = 0; k < pairs.size(); k++) {
            if (slopeI[k] == 0 && slopeJ[k] == 0) continue;
            auto [i, j] = pairs[k];
            double nu = viscosityRatio * c * (support[level[i]] + support[level[j]]) / 2, f = P[i] * slopeI[k] + P[j] * slopeJ[k];
            if (youth > 0 && (time < born[i] + youth || time < born[j] + youth)) nu *= 1 + youthViscosity;
            Vec push = (1 / TheLattice.moment) * ((nu * (slopeI[k] + slopeJ[k])) * (v[i] - v[j]) - f * direction[k]);
            a[i] += m[j] * push;
            a[j] += -m[i] * push;
        }
        // A group moves by its whole force; its children move apart by their own.
        for (auto& g : groups) {
            double mass = m[g.parent];
            Vec whole = m[g.parent] * a[g.parent], mean{};
            for (int k : g.children) { mass += m[k]; whole += m[k] * a[k]; mean += (1. / g.children.size()) * a[k]; }
            for (int k : g.children) a[k] = a[k] - mean + (1 / mass) * whole;
            a[g.parent] = (1 / mass) * whole;
        }
        for (auto& q : a) q.z -= gravity;
    }

    double Fastest() const {
        double most = 0;
        for (auto& q : v) most = std::max(most, Length(q));
        return most;
    }

    void Step() {
        if (offsetTime == 0 || groups.empty()) Blend();
        else {
            vector<double> before = DensityBefore();
            Blend(&before);
        }
        Density();
        if (nested) InterpolateBuffers();
        Forces();
        dt = .6 * Support(0) / (c + Fastest());
        double keep = std::exp(-damping * dt), fade = offsetTime > 0 ? std::exp(-dt / offsetTime) : 1;
        for (int i = 0; i < Count(); i++) {
            if (!buffer[i]) v[i] = keep * (v[i] + dt * a[i]);
            for (auto& w : walls) {
                double d = Dot(w.normal, x[i]) - w.offset, speed = Dot(w.normal, v[i]);
                double limit = -std::max(0., d - .25 * Spacing(level[i])) / dt;
                if (speed < limit) v[i] += (limit - speed) * w.normal;
            }
            x[i] += dt * v[i];
            offset[i] *= fade;
        }
        for (auto& g : groups) {   // exact but where a wall has stopped a child
            Vec centre{}, speed{};
            for (int k : g.children) {
                centre += (1. / g.children.size()) * Separation(x[k], x[g.parent]);
                speed += (1. / g.children.size()) * v[k];
            }
            x[g.parent] += centre;
            v[g.parent] = speed;
        }
        for (auto& q : x) {
            if (period.x > 0) q.x -= period.x * std::floor(q.x / period.x);
            if (period.y > 0) q.y -= period.y * std::floor(q.y / period.y);
        }
        if (nested) Exchange();
        time += dt;
        steps++;
    }

    double Energy() const {
        double sum = 0;
        for (int i = 0; i < Count(); i++)
            if (!buffer[i]) {
                double elastic = rho[i] > 1 ? c * c * (std::log(rho[i]) + 1 / rho[i] - 1) : 0;
                sum += m[i] * (.5 * Dot(v[i], v[i]) + gravity * x[i].z + elastic);
            }
        return sum;
    }
    double TotalMass() const {
        double sum = 0;
        for (int i = 0; i < Count(); i++) if (!buffer[i]) sum += m[i];
        return sum;
    }
    Vec Momentum(double* scale = nullptr) const {
        Vec sum{};
        double all = 0;
        for (int i = 0; i < Count(); i++) if (!buffer[i]) { sum += m[i] * v[i]; all += m[i] * Length(v[i]); }
        if (scale) *scale = all;
        return sum;
    }

    // ------------------------------------------------------------------------------------------ splits and merges

    // Depth of every particle: how far the next particle of the surface is. The package would sweep its cells.
    void FindDepths() {
        if (stale) Density();
        vector<Vec> normal(Count());
        for (int i = 0; i < Count(); i++) normal[i] = .5 * wallGradient[i];   // the image moves too, so its slope counts twice
        for (size_t k = 0; k < pairs.size(); k++) {
            auto [i, j] = pairs[k];
            double g = (slopeI[k] + slopeJ[k]) / 2;
            normal[i] += (m[j] * g) * direction[k];
            normal[j] += (-m[i] * g) * direction[k];
        }
        vector<Vec> surface;
        for (int i = 0; i < Count(); i++)
            if (!buffer[i] && (rho[i] < .7 || Length(normal[i]) * Support(level[i]) > .8)) surface.push_back(x[i]);
        for (int i = 0; i < Count(); i++) {
            double near = 1e9;
            for (auto& q : surface) { Vec d = Separation(x[i], q); near = std::min(near, Dot(d, d)); }
            depth[i] = std::sqrt(near);
        }
    }

    // Starts splits above the depth and merges below it.
    void Adapt(double at, double slack, int coarsest) {
        FindDepths();
        otherWork += pairs.size() * 2 + long(Count()) * 26;   // the normals' pairs, and two sweeps of half the neighbour cells
        double bandStep = coarsest > 1 ? 2.8 : 0;      // each level of a graded liquid begins deeper
        int count = Count();
        for (int i = 0; i < count; i++)
            if (level[i] > 0 && group[i] < 0 && depth[i] < at - slack + (level[i] - 1) * bandStep) Split(i);
        for (int l = 0; l < coarsest; l++) {
            vector<int> ready;
            for (int i = 0; i < count; i++)
                if (level[i] == l && group[i] < 0 && depth[i] > at + slack + l * bandStep) ready.push_back(i);
            double edge = 2 * Spacing(l);
            std::map<std::array<int, 3>, vector<int>> cells;
            for (int i : ready) cells[Cell(x[i], edge)].push_back(i);
            otherWork += ready.size();
            if (arity == 8)
                for (auto& [key, inside] : cells)
                    if (inside.size() == 8 && Compact(inside)) Merge(inside);
            // what is left over: the nearest that are free
            for (int i : ready) {
                if (group[i] >= 0) continue;
                auto key = Cell(x[i], edge);
                vector<std::pair<double, int>> near;
                for (int p = -1; p <= 1; p++) for (int q = -1; q <= 1; q++) for (int s = -1; s <= 1; s++) {
                    auto found = cells.find({key[0] + p, key[1] + q, key[2] + s});
                    if (found == cells.end()) continue;
                    for (int j : found->second) {
                        otherWork++;
                        if (j != i && group[j] < 0) near.push_back({Length(Separation(x[i], x[j])), j});
                    }
                }
                if (int(near.size()) < arity - 1) continue;
                std::sort(near.begin(), near.end());
                vector<int> parts{i};
                for (int k = 0; k < arity - 1; k++) parts.push_back(near[k].second);
                if (Compact(parts)) Merge(parts);
            }
        }
        if ((arrange > 0 || accept > 0) && blend <= 1) Arrange(at - slack - 1.5);
    }

    void Blend(vector<double>* before = nullptr) {
        bool changed = false;
        for (auto& g : groups) {
            g.step++;
            changed = true;
            double share = blend > 0 ? std::min(1., double(g.step) / blend) : 1, toChildren = g.splits ? share : 1 - share;
            m[g.parent] = Mass(level[g.parent]) * (1 - toChildren);
            for (int k : g.children) m[k] = Mass(level[k]) * toChildren;
        }
        vector<char> dead(Count(), 0);
        bool any = false;
        for (size_t k = 0; k < groups.size();) {
            auto& g = groups[k];
            if (g.step < std::max(1, blend)) { k++; continue; }
            any = true;
            for (int q : g.children) { group[q] = -1; if (!g.splits) dead[q] = 1; }
            group[g.parent] = -1;
            if (g.splits) dead[g.parent] = 1;
            groups[k] = groups.back();
            groups.pop_back();
        }
        if (any) {
            vector<int> now = Remove(dead);
            if (before) {
                for (size_t i = 0; i < now.size(); i++) if (now[i] >= 0) (*before)[now[i]] = (*before)[i];
                before->resize(Count());
            }
        }
        // What a change of mass does to densities becomes an offset that fades, so pressures go on as they were.
        if (before && changed) {
            Density();
            for (int i = 0; i < Count(); i++) offset[i] += (*before)[i] - rho[i];
        }
    }

    vector<int> Remove(const vector<char>& dead) {
        vector<int> now(Count(), -1);
        int kept = 0;
        for (int i = 0; i < int(dead.size()); i++) {
            if (dead[i]) continue;
            now[i] = kept;
            x[kept] = x[i]; v[kept] = v[i]; a[kept] = a[i]; m[kept] = m[i]; rho[kept] = rho[i]; P[kept] = P[i]; offset[kept] = offset[i];
            depth[kept] = depth[i]; born[kept] = born[i]; level[kept] = level[i]; group[kept] = group[i]; buffer[kept] = buffer[i];
            kept++;
        }
        x.resize(kept); v.resize(kept); a.resize(kept); m.resize(kept); rho.resize(kept); P.resize(kept); offset.resize(kept);
        depth.resize(kept); born.resize(kept); level.resize(kept); group.resize(kept); buffer.resize(kept);
        for (auto& g : groups) { g.parent = now[g.parent]; for (int& k : g.children) k = now[k]; }
        stale = true;
        return now;
    }

    void Split(int i) {
        int l = level[i] - 1;
        Group g{i, 0, {}, true};
        double half = (arity == 8 ? .5 : .63) * Spacing(l), floorRoom = 1e9;
        for (auto& w : walls) floorRoom = std::min(floorRoom, Dot(w.normal, x[i]) - w.offset);
        half = std::min(half, std::max(.1, floorRoom - .3 * Spacing(l)));
        int axis = int(splits % 3);
        group[i] = 1;
        for (int k = 0; k < arity; k++) {
            Vec d = arity == 8 ? Vec{k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half}
                               : (k ? half : -half) * Vec{axis == 0 ? 1. : 0, axis == 1 ? 1. : 0, axis == 2 ? 1. : 0};
            int child = Add(x[i] + d, v[i], l);
            m[child] = 0; offset[child] = offset[i]; rho[child] = rho[i]; group[child] = 1; depth[child] = depth[i]; born[child] = time;
            g.children.push_back(child);
        }
        groups.push_back(g);
        splits++;
    }

    void Merge(const vector<int>& parts) {
        Vec centre{}, speed{};
        double share = 1. / parts.size(), o = 0, r = 0, deep = 0;
        for (int k : parts) {
            centre += share * Separation(x[k], x[parts[0]]); speed += share * v[k];
            o += share * offset[k]; r += share * rho[k]; deep += share * depth[k]; group[k] = 1;
        }
        int parent = Add(x[parts[0]] + centre, speed, level[parts[0]] + 1);
        m[parent] = 0; group[parent] = 1; offset[parent] = o; rho[parent] = r; depth[parent] = deep; born[parent] = time;
        groups.push_back({parent, 0, parts, false});
        merges++;
    }

    // Densities as they are before masses pass, and those that what is new takes over.
    vector<double> DensityBefore() {
        Density();
        vector<double> before = rho;
        for (auto& g : groups) {
            if (g.step) continue;
            if (!g.splits) before[g.parent] = 0;
            for (int k : g.children) {
                if (g.splits) before[k] = before[g.parent]; else before[g.parent] += before[k] / g.children.size();
            }
        }
        return before;
    }

    // Before the masses pass: moves the parts of new splits, about their centre, to where the kernel's gradients cancel, and takes
    // back the changes that would alter a density by more than `accept`, but for splits that are overdue.
    void Arrange(double overdue) {
        long seen = pairsSeen;
        vector<double> kept = m, before = DensityBefore(), change(Count());
        vector<int> owner(Count(), -1);
        for (size_t q = 0; q < groups.size(); q++) {
            auto& g = groups[q];
            if (g.step) continue;
            m[g.parent] = g.splits ? 0 : Mass(level[g.parent]);
            for (int k : g.children) { m[k] = g.splits ? Mass(level[k]) : 0; if (g.splits) owner[k] = int(q); }
            if (!g.splits) owner[g.parent] = int(q);
        }
        for (int n = 0; n < arrange; n++) {
            Density();
            vector<Vec> gradient = wallGradient;
            for (size_t k = 0; k < pairs.size(); k++) {
                auto [i, j] = pairs[k];
                gradient[i] += (m[j] * slopeI[k]) * direction[k];
                gradient[j] += (-m[i] * slopeJ[k]) * direction[k];
            }
            for (auto& g : groups) {
                if (g.step || !g.splits) continue;
                Vec mean{};
                for (int k : g.children) mean += (1. / g.children.size()) * gradient[k];
                for (int k : g.children) {
                    double s = Spacing(level[k]);
                    x[k] += (-.15 * s * s) * (gradient[k] - mean);
                    otherWork += 100;
                }
            }
        }
        if (accept > 0) {
            Density();
            vector<double> worst(groups.size(), 0);
            for (int i = 0; i < Count(); i++) if (m[i] > 0) change[i] = std::fabs(rho[i] - before[i]);
            for (int i = 0; i < Count(); i++)
                if (owner[i] >= 0) { worst[owner[i]] = std::max(worst[owner[i]], change[i]); otherWork += 50; }
            for (auto [i, j] : pairs) {
                if (Length(Separation(x[i], x[j])) > .6 * PairSupport(level[i], level[j])) continue;
                if (owner[i] >= 0) worst[owner[i]] = std::max(worst[owner[i]], change[j]);
                if (owner[j] >= 0) worst[owner[j]] = std::max(worst[owner[j]], change[i]);
            }
            vector<char> dead(Count(), 0);
            m = kept;
            rho = before;
            for (size_t q = groups.size(); q-- > 0;) {
                auto& g = groups[q];
                if (g.step || worst[q] < accept || (g.splits && depth[g.parent] < overdue)) continue;
                if (g.splits) { group[g.parent] = -1; for (int k : g.children) dead[k] = 1; splits--; }
                else { for (int k : g.children) group[k] = -1; dead[g.parent] = 1; merges--; }
                g.step = -1;
            }
            groups.erase(std::remove_if(groups.begin(), groups.end(), [](const Group& g) { return g.step < 0; }), groups.end());
            Remove(dead);
        }
        else { m = kept; rho = before; }
        pairsSeen = seen;
    }
    double accept = 0;
    int arrange = 0;
    // Whether parts lie as near to their centre as those of a lattice cell, with some room.
    bool Compact(const vector<int>& parts) const {
        Vec centre{};
        for (int k : parts) centre += (1. / parts.size()) * Separation(x[k], x[parts[0]]);
        for (int k : parts)
            if (Length(Separation(x[k], x[parts[0]]) - centre) > (arity == 8 ? compact : .75) * Spacing(level[k])) return false;
        return true;
    }
    double compact = 1.35;

    static std::array<int, 3> Cell(Vec p, double edge) {
        return {int(std::floor(p.x / edge)), int(std::floor(p.y / edge)), int(std::floor(p.z / edge))};
    }

    // ------------------------------------------------------------------------------------------ nested regions

    double border = 0;             // fine liquid above this height, coarse below
    double buffers[2] = {3, 6};    // heights of the fine buffer, below the border, and the coarse one, above it
    double shift = 0;              // of buffer particles, towards evenness
    vector<double> ledger[2];      // mass that has flowed through patches of a buffer's outer face and is not yet particles

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

    void InterpolateBuffers() {
        vector<Fit> fits(Count());
        double R = Support(levelOf[1]);
        for (int i = 0; i < Count(); i++)
            if (!buffer[i]) P[i] = std::max(0., c * c * (rho[i] - 1)) / (rho[i] * rho[i]);
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
            double p = std::max(0., out[3]);
            rho[i] = 1 + p / (c * c);
            P[i] = p / (rho[i] * rho[i]);
        }
    }

    // After the drift: who has crossed the border changes between liquid and buffer, who has left a buffer goes, and the flux
    // through the buffers' outer faces becomes particles.
    void Exchange() {
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
                x[i] += std::min(1., .1 * Spacing(level[i]) / std::max(1e-9, Length(by))) * by;
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
    int levelOf[2] = {0, 1};

private:
    vector<Vec> places, direction, wallGradient;
    vector<double> slopeI, slopeJ;
};
