// A weakly compressible liquid whose particles may have several sizes: pairs, walls, a body, forces. changes.h has splits and merges,
// nested.h nested regions, bench.cpp the cases. Units: fine spacing 1, rest density 1, gravity 1.
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
#include <type_traits>
#include <vector>
using std::vector;

// State and sums over pairs; what a run is measured by is summed in double.
#ifdef SINGLE
using Real = float;
#else
using Real = double;
#endif

template <class T> struct Vector {
    T x = 0, y = 0, z = 0;
    Vector() = default;
    template <class A, class B, class C> Vector(A x, B y, C z) : x(T(x)), y(T(y)), z(T(z)) {}
};
using Vec = Vector<Real>;
using Vec64 = Vector<double>;
template <class T> Vector<T> operator+(Vector<T> a, Vector<T> b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class T> Vector<T> operator-(Vector<T> a, Vector<T> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class T> Vector<T> operator*(std::common_type_t<T> s, Vector<T> a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T> void operator+=(Vector<T>& a, Vector<T> b) { a = a + b; }
template <class T> T Dot(Vector<T> a, Vector<T> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> T Length(Vector<T> a) { return std::sqrt(Dot(a, a)); }
inline Vec64 Wide(Vec a) { return {a.x, a.y, a.z}; }

// ---------------------------------------------------------------------------------------------- kernel and wall

constexpr Real Pi = 3.14159265358979323846, Kappa = 2.25, KernelScale = 21 / (2 * Pi);

// Wendland C2 of support R, and its slope over r.
inline Real W(Real r, Real R) {
    Real q = r / R, u = 1 - q;
    return q < 1 ? KernelScale * u * u * u * u * (4 * q + 1) / (R * R * R) : 0;
}
inline Real G(Real r, Real R) {
    Real q = r / R, u = 1 - q;
    return q < 1 ? -20 * KernelScale * u * u * u / (R * R * R * R * R) : 0;
}

inline void Kernel(Real r, Real R, Real& value, Real& slope) {
    Real inverse = 1 / R, q = r * inverse, u = q < 1 ? 1 - q : 0, scale = KernelScale * inverse * inverse * inverse * u * u * u;
    value = scale * u * (4 * q + 1);
    slope = -20 * scale * inverse * inverse;
}

// Sum of the kernel over the lattice, and its moment M: a lattice compressed by 1 % raises its sum by M %.
struct Lattice {
    Real sum = 0, moment = 0;
    Lattice() {
        for (int i = -2; i <= 2; i++)
            for (int j = -2; j <= 2; j++)
                for (int k = -2; k <= 2; k++) {
                    Real r = std::sqrt(Real(i * i + j * j + k * k));
                    sum += W(r, Kappa);
                    moment -= i * i * G(r, Kappa);
                }
        moment /= sum;
    }
};
static const Lattice TheLattice;

// Density that a wall at distance d adds: three mirror layers of the particle's own spacing. Its slope is the force's.
inline void WallShare(Real d, Real dx, Real& share, Real& slope) {
    Real R = Kappa * dx;
    share = slope = 0;
    for (int layer = 0; layer < 3; layer++) {
        Real z = (2 * std::max<Real>(d, 0) + layer * dx) / R;
        if (z >= 1) break;
        Real z2 = z * z, u = 1 - z;
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
    Real offset;
};

// A sphere that goes by a prescribed way. Its face has the mirror layers of a wall, as if it were flat.
struct Body {
    Real radius = 0;               // 0: there is none
    Vec at, speed;
    Vec64 impulse;                 // that the liquid has given it
    double work = 0;               // that it has done on the liquid
};

// A particle that becomes `children`, or the other way round. Until the blend ends both are there and share the mass; the parent is
// carried by the children's centre.
struct Group {
    int parent, step = 0;
    vector<int> children;
    bool splits;
    Real whole = 0;                // mass of the parent
    vector<Real> parts{};          // of the children
    double late = 0;               // how far beyond the depth at which it was due
};

class Liquid {
public:
    // set by a case
    PairKernel kernel = PairKernel::Mean;
    int arity = 8;                 // parts of a split: 8 for spacings 1 and 2, 2 for spacings 1, 1.26, 1.59 and 2
    bool nested = false;           // particles of different levels do not see each other
    Vec period{0, 0, 0};           // 0: not periodic
    vector<Wall> walls;
    Body body;
    Real c = 10, gravity = 1, viscosityRatio = .001, damping = 0;
    int blend = 10;                // steps of a split or merge
    Real offsetTime = 0;           // time in which a density offset fades; 0: none are made, < 0: never
    Real youth = 0, youthViscosity = 0;   // for how long what is new is more viscous, and by how many times

    // particles
    vector<Vec> x, v, a;
    vector<Real> m, rho, P, offset, depth, born;
    vector<int> level, group;
    vector<char> buffer;

    vector<Group> groups;
    double time = 0;
    Real dt = 0;
    long steps = 0, pairsSeen = 0, otherWork = 0, splits = 0, merges = 0, dissolved = 0;
    bool stale = true;

    Real Spacing(int l) const {
        static const std::array<double, 4> Eight{1, 2, 4, 8}, Two{1, std::cbrt(2.), std::cbrt(4.), 2};
        return arity == 8 ? Eight[l] : Two[l];
    }
    Real Support(int l) const { return Kappa * Spacing(l); }
    Real Mass(int l) const { return std::pow(Real(arity), Real(l)) / TheLattice.sum; }
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

    Real PairSupport(int a, int b) const {
        Real A = Support(a), B = Support(b);
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
                Real reach = (nested ? Support(b) : PairSupport(l, b)) * skin, reach2 = reach * reach;
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

    Real BodyDistance(Vec p, Vec* normal = nullptr) const {
        Vec d = Separation(p, body.at);
        Real r = Length(d);
        if (normal) *normal = (1 / std::max<Real>(r, 1e-6)) * d;
        return r - body.radius;
    }

    // The density of walls and body at a place, its gradient, and the body's part of that.
    Real WallDensity(Vec at, int l, Vec& gradient, Vec& ofBody) const {
        Real share[4], slope[4], rest = 1;
        int count = 0, bodyAt = -1;
        Vec normal[4];
        auto see = [&](Real d, Vec n) {
            if (d >= Support(l) / 2 || count == 4) return false;
            normal[count] = n;
            WallShare(d, Spacing(l), share[count], slope[count]);
            rest *= 1 - share[count++];
            return true;
        };
        for (auto& w : walls) see(Dot(w.normal, at) - w.offset, w.normal);
        if (body.radius > 0) {
            Vec n;
            Real d = BodyDistance(at, &n);
            if (see(d, n)) bodyAt = count - 1;
        }
        gradient = ofBody = {};
        for (int k = 0; k < count; k++) {
            Real others = 1;
            for (int q = 0; q < count; q++) if (q != k) others *= 1 - share[q];
            Vec part = (slope[k] * others) * normal[k];
            gradient += part;
            if (k == bodyAt) ofBody = part;
        }
        return 1 - rest;
    }

    void Density() {
        if (!stale) {
            Real gone = 0;
            for (int i = 0; i < Count(); i++) { Vec d = Separation(x[i], places[i]); gone = std::max(gone, Dot(d, d)); }
            if (std::sqrt(gone) > .05 * Support(0) * .98) stale = true;
        }
        if (stale) FindPairs();
        wallGradient.resize(Count());
        bodyGradient.resize(Count());
        for (int i = 0; i < Count(); i++)
            rho[i] = m[i] * W(0, Support(level[i])) + WallDensity(x[i], level[i], wallGradient[i], bodyGradient[i]);
        Real support[4], far2[4][4];
        for (int l = 0; l < 4; l++) support[l] = Support(l);
        for (int k = 0; k < 4; k++) for (int l = 0; l < 4; l++) far2[k][l] = std::pow(k == l ? support[k] : PairSupport(k, l), Real(2));
        for (size_t k = 0; k < pairs.size(); k++) {
            auto [i, j] = pairs[k];
            Vec d = Separation(x[i], x[j]);
            Real r2 = Dot(d, d), toI, toJ;
            direction[k] = d;
            slopeI[k] = slopeJ[k] = 0;
            if (r2 >= far2[level[i]][level[j]]) continue;
            Real r = std::sqrt(r2), A = support[level[i]], B = support[level[j]];
            if (level[i] == level[j] || kernel == PairKernel::Mean || kernel == PairKernel::Max) {
                Real R = kernel == PairKernel::Max ? std::max(A, B) : (A + B) / 2;
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
            if (!buffer[i]) P[i] = std::max<Real>(0, c * c * (rho[i] - 1)) / (rho[i] * rho[i]);
            a[i] = (-P[i] / TheLattice.moment) * wallGradient[i];
        }
        Real support[4];
        for (int l = 0; l < 4; l++) support[l] = Support(l);
        for (size_t k = 0; k < pairs.size(); k++) {
            if (slopeI[k] == 0 && slopeJ[k] == 0) continue;
            auto [i, j] = pairs[k];
            Real nu = viscosityRatio * c * (support[level[i]] + support[level[j]]) / 2, f = P[i] * slopeI[k] + P[j] * slopeJ[k];
            if (youth > 0 && (time < born[i] + youth || time < born[j] + youth)) nu *= 1 + youthViscosity;
            Vec push = (1 / TheLattice.moment) * ((nu * (slopeI[k] + slopeJ[k])) * (v[i] - v[j]) - f * direction[k]);
            a[i] += m[j] * push;
            a[j] += -m[i] * push;
        }
        // A group moves by its whole force; its children move apart by their own.
        for (auto& g : groups) {
            Real mass = m[g.parent];
            Vec whole = m[g.parent] * a[g.parent], mean{};
            for (int k : g.children) { mass += m[k]; whole += m[k] * a[k]; mean += (1 / Real(g.children.size())) * a[k]; }
            for (int k : g.children) a[k] = a[k] - mean + (1 / mass) * whole;
            a[g.parent] = (1 / mass) * whole;
        }
        for (auto& q : a) q.z -= gravity;
    }

    Real Fastest() const {
        Real most = 0;
        for (auto& q : v) most = std::max(most, Length(q));
        return most;
    }

    void Step() {
        if (offsetTime == 0 || (groups.empty() && held.empty())) Blend();
        else {
            vector<Real> before = held.empty() ? DensityBefore() : held;
            Blend(&before);
            held.clear();
        }
        Density();
        if (nested) InterpolateBuffers();
        Forces();
        dt = .6 * Support(0) / (c + Fastest());
        Real keep = std::exp(-damping * dt), fade = offsetTime > 0 ? std::exp(-dt / offsetTime) : 1;
        for (int i = 0; i < Count(); i++) {
            if (body.radius > 0) Give((-dt * m[i] * P[i] / TheLattice.moment) * bodyGradient[i]);
            if (!buffer[i]) v[i] = keep * (v[i] + dt * a[i]);
            auto stop = [&](Real d, Vec normal, Vec moves, bool isBody) {
                Real speed = Dot(normal, v[i] - moves), limit = -std::max<Real>(0, d - .25 * Spacing(level[i])) / dt;
                if (speed >= limit) return;
                v[i] += (limit - speed) * normal;
                if (isBody) Give((limit - speed) * m[i] * normal);
            };
            for (auto& w : walls) stop(Dot(w.normal, x[i]) - w.offset, w.normal, {}, false);
            if (body.radius > 0) {
                Vec normal;
                Real d = BodyDistance(x[i], &normal);
                stop(d, normal, body.speed, true);
            }
            x[i] += dt * v[i];
            offset[i] *= fade;
        }
        body.at += dt * body.speed;
        for (auto& g : groups) {   // exact but where a wall has stopped a child
            Vec centre{}, speed{};
            for (int k : g.children) {
                centre += (1 / Real(g.children.size())) * Separation(x[k], x[g.parent]);
                speed += (1 / Real(g.children.size())) * v[k];
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

    // Less what the body has done.
    double Energy() const {
        double sum = -body.work;
        for (int i = 0; i < Count(); i++)
            if (!buffer[i]) {
                double r = rho[i], elastic = r > 1 ? c * c * (std::log(r) + 1 / r - 1) : 0;
                Vec64 u = Wide(v[i]);
                sum += m[i] * (.5 * Dot(u, u) + gravity * x[i].z + elastic);
            }
        return sum;
    }
    double TotalMass() const {
        double sum = 0;
        for (int i = 0; i < Count(); i++) if (!buffer[i]) sum += m[i];
        return sum;
    }
    // Of the liquid, and what the body has taken.
    Vec64 Momentum(double* scale = nullptr) const {
        Vec64 sum = body.impulse;
        double all = 0;
        for (int i = 0; i < Count(); i++) if (!buffer[i]) { sum += m[i] * Wide(v[i]); all += m[i] * Length(v[i]); }
        if (scale) *scale = all;
        return sum;
    }

    // changes.h
    double accept = 0;             // the change of a density above which a split or merge is taken back; 0: none is
    int arrange = 0;               // moves of new parts about their centre
    double compact = 1.35;         // how far from their centre eight parts of a merge may lie
    double lookAhead = 0;          // time for which the body's way is kept free of coarse particles
    double apart = 0;              // distance within which a sort changes one thing only; 0: all that are ready
    bool dissolve = false;         // a fine particle that is left alone among coarse ones goes into the nearest
    double patience = 0;           // spacings by which a change is late when twice the error is accepted; 0: never more
    bool search = false;           // splits take the direction and distance, and merges the partner, of least error
    int settle = 0, rings = 1;     // moves of the neighbours too, and over how many neighbourhoods, to the densities before a change
    void FindDepths();
    void Adapt(double at, double slack, int coarsest);

    // nested.h
    double border = 0;             // fine liquid above this height, coarse below
    double buffers[2] = {3, 6};    // heights of the fine buffer, below the border, and the coarse one, above it
    double shift = 0;              // of buffer particles, towards evenness
    vector<double> ledger[2];      // mass that has flowed through patches of a buffer's outer face and is not yet particles
    int levelOf[2] = {0, 1};
    void InterpolateBuffers();

private:
    // The body gives the liquid an impulse.
    void Give(Vec impulse) {
        body.impulse = body.impulse - Wide(impulse);
        body.work += Dot(Wide(impulse), Wide(body.speed));
    }
    void Blend(vector<Real>* before = nullptr);
    vector<int> Remove(const vector<char>& dead);
    void Split(int i);
    void Merge(const vector<int>& parts);
    void Dissolve(const vector<int>& alone, vector<Real>& deep);
    vector<Real> DensityBefore();
    void Arrange(double overdue, const vector<Real>& deep);
    void Settle(const vector<Real>& before);
    double ErrorOf(const vector<int>& from, const vector<Vec>& to, int l);
    void FindNeighbours();
    void Exchange();
    bool Compact(const vector<int>& parts, double late = 0) const;

    vector<Vec> places, direction, wallGradient, bodyGradient;
    vector<Real> slopeI, slopeJ, held;   // held: densities that a settled change is to go on with
    vector<int> neighbourStart, neighbours;
};
