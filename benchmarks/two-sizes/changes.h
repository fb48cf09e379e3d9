// Splits and merges: who changes, what its densities carry over, and how the parts and what is near them make room.
#pragma once
#include "liquid.h"

// Depth of every particle: how far the next particle of the surface is. The package would sweep its cells.
inline void Liquid::FindDepths() {
    if (stale) Density();
    vector<Vec> normal(Count());
    for (int i = 0; i < Count(); i++) normal[i] = .5 * wallGradient[i];   // the image moves too, so its slope counts twice
    for (size_t k = 0; k < pairs.size(); k++) {
        auto [i, j] = pairs[k];
        Real g = (slopeI[k] + slopeJ[k]) / 2;
        normal[i] += (m[j] * g) * direction[k];
        normal[j] += (-m[i] * g) * direction[k];
    }
    vector<Vec> surface;
    for (int i = 0; i < Count(); i++)
        if (!buffer[i] && (rho[i] < .7 || Length(normal[i]) * Support(level[i]) > .8)) surface.push_back(x[i]);
    for (int i = 0; i < Count(); i++) {
        Real near = 1e9;
        for (auto& q : surface) { Vec d = Separation(x[i], q); near = std::min(near, Dot(d, d)); }
        depth[i] = std::sqrt(near);
    }
}

// Starts splits above the depth and merges below it.
inline void Liquid::Adapt(double at, double slack, int coarsest) {
    FindDepths();
    otherWork += pairs.size() * 2 + long(Count()) * 26;   // the normals' pairs, and two sweeps of half the neighbour cells
    vector<Real> deep = depth;                            // below the surface, or from where the body is and will be
    if (body.radius > 0) {
        Vec way = lookAhead * body.speed;
        Real length2 = Dot(way, way);
        for (int i = 0; i < Count(); i++) {
            Vec d = Separation(x[i], body.at);
            Real share = length2 > 0 ? std::clamp<Real>(Dot(d, way) / length2, 0, 1) : 0;
            deep[i] = std::min(deep[i], Length(d - share * way) - body.radius);
        }
    }
    double bandStep = coarsest > 1 ? 2.8 : 0;      // each level of a graded liquid begins deeper
    int count = Count();
    vector<Vec> changed;
    auto free = [&](Vec p) {
        if (apart > 0) for (auto& q : changed) if (Length(Separation(p, q)) < apart) return false;
        changed.push_back(p);
        return true;
    };
    if (search) FindNeighbours();
    vector<int> late;
    for (int i = 0; i < count; i++)
        if (level[i] > 0 && group[i] < 0 && deep[i] < at - slack + (level[i] - 1) * bandStep) late.push_back(i);
    if (apart > 0) std::sort(late.begin(), late.end(), [&](int i, int j) { return deep[i] < deep[j]; });
    for (int i : late) {
        if (!free(x[i])) continue;
        Split(i);
        groups.back().late = at - slack + (level[i] - 1) * bandStep - deep[i];
    }
    vector<int> alone;
    for (int l = 0; l < coarsest; l++) {
        vector<int> ready;
        for (int i = 0; i < count; i++)
            if (level[i] == l && group[i] < 0 && deep[i] > at + slack + l * bandStep) ready.push_back(i);
        double edge = 2 * Spacing(l);
        auto cell = [&](Vec p) {
            return std::array<int, 3>{int(std::floor(p.x / edge)), int(std::floor(p.y / edge)), int(std::floor(p.z / edge))};
        };
        std::map<std::array<int, 3>, vector<int>> cells;
        for (int i : ready) cells[cell(x[i])].push_back(i);
        otherWork += ready.size();
        if (arity == 8)
            for (auto& [key, inside] : cells)
                if (inside.size() == 8 && Compact(inside) && free(x[inside[0]])) Merge(inside);
        // what is left over: the nearest that are free, or the partner of least error
        for (int i : ready) {
            if (group[i] >= 0) continue;
            auto key = cell(x[i]);
            double late = deep[i] - (at + slack + l * bandStep);
            vector<std::pair<double, int>> near;
            for (int p = -1; p <= 1; p++) for (int q = -1; q <= 1; q++) for (int s = -1; s <= 1; s++) {
                auto found = cells.find({key[0] + p, key[1] + q, key[2] + s});
                if (found == cells.end()) continue;
                for (int j : found->second) {
                    otherWork++;
                    if (j != i && group[j] < 0) near.push_back({Length(Separation(x[i], x[j])), j});
                }
            }
            if (deep[i] > at + slack + (l + 2) * bandStep) alone.push_back(i);
            if (int(near.size()) < arity - 1) continue;
            if (search && arity == 2) {
                vector<std::pair<double, int>> best;
                for (auto [r, j] : near) {
                    if (!Compact({i, j}, late)) continue;
                    best.push_back({ErrorOf({i, j}, {x[i] + .5 * Separation(x[j], x[i])}, l + 1), j});
                }
                if (best.empty()) continue;
                near = best;
            }
            std::sort(near.begin(), near.end());
            vector<int> parts{i};
            for (int k = 0; k < arity - 1; k++) parts.push_back(near[k].second);
            if (!Compact(parts, late) || !free(x[i])) continue;
            Merge(parts);
            groups.back().late = late;
        }
    }
    if (dissolve && arity == 2) Dissolve(alone, deep);
    if (arrange > 0 || accept > 0 || settle > 0) Arrange(at - slack - 1.5, deep);
}

inline void Liquid::Blend(vector<Real>* before) {
    bool changed = !held.empty();
    for (auto& g : groups) {
        g.step++;
        changed = true;
        double share = blend > 0 ? std::min<double>(1, double(g.step) / blend) : 1, toChildren = g.splits ? share : 1 - share;
        m[g.parent] = g.whole * (1 - toChildren);
        for (size_t k = 0; k < g.children.size(); k++) m[g.children[k]] = g.parts[k] * toChildren;
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

inline vector<int> Liquid::Remove(const vector<char>& dead) {
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

inline void Liquid::Split(int i) {
    int l = level[i] - 1;
    Group g{i, 0, {}, true, m[i], vector<Real>(arity, m[i] / arity)};
    Real half = (arity == 8 ? .5 : .63) * Spacing(l), floorRoom = 1e9;
    for (auto& w : walls) floorRoom = std::min(floorRoom, Dot(w.normal, x[i]) - w.offset);
    half = std::min(half, std::max<Real>(.1, floorRoom - .3 * Spacing(l)));
    int axis = int(splits % 3);
    Vec along = half * Vec{axis == 0 ? 1. : 0, axis == 1 ? 1. : 0, axis == 2 ? 1. : 0};
    if (search && arity == 2) {
        double least = HUGE_VAL;
        for (int k = 14; k < 27; k++) for (double far : {.7, .85, 1., 1.15}) {   // half of the directions to the 26 cells round one
            Vec d{k % 3 - 1., k / 3 % 3 - 1., k / 9 - 1.};
            d = (far * half / Length(d)) * d;
            double error = ErrorOf({i}, {x[i] - d, x[i] + d}, l);
            if (error < least) { least = error; along = d; }
        }
    }
    group[i] = 1;
    for (int k = 0; k < arity; k++) {
        Vec d = arity == 8 ? Vec{k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half} : (k ? 1 : -1) * along;
        int child = Add(x[i] + d, v[i], l);
        m[child] = 0; offset[child] = offset[i]; rho[child] = rho[i]; group[child] = 1; depth[child] = depth[i]; born[child] = time;
        g.children.push_back(child);
    }
    groups.push_back(g);
    splits++;
}

inline void Liquid::Merge(const vector<int>& parts) {
    Vec centre{}, speed{};
    Real whole = 0, o = 0, r = 0, deep = 0;
    vector<Real> masses;
    for (int k : parts) { whole += m[k]; masses.push_back(m[k]); }
    for (int k : parts) {
        Real share = m[k] / whole;
        centre += share * Separation(x[k], x[parts[0]]); speed += share * v[k];
        o += share * offset[k]; r += share * rho[k]; deep += share * depth[k]; group[k] = 1;
    }
    int parent = Add(x[parts[0]] + centre, speed, level[parts[0]] + 1);
    m[parent] = 0; group[parent] = 1; offset[parent] = o; rho[parent] = r; depth[parent] = deep; born[parent] = time;
    groups.push_back({parent, 0, parts, false, whole, masses});
    merges++;
}

// What is left alone goes into the nearest particle of two sizes more: centre, mass and momentum stay, and what densities jump by is
// carried. Masses of a size differ by up to a quarter then.
inline void Liquid::Dissolve(const vector<int>& alone, vector<Real>& deep) {
    vector<char> dead(Count(), 0), taken(Count(), 0);
    vector<int> nearest(Count(), -1);
    vector<Real> far(Count(), 1e9);
    for (int i : alone) if (group[i] < 0) taken[i] = 1;
    for (auto [i, j] : pairs) {
        for (auto [p, q] : {Pair{i, j}, Pair{j, i}}) {
            if (!taken[p] || group[q] >= 0 || level[q] < level[p] + 2 || m[p] + m[q] > 1.3 * Mass(level[q])) continue;
            Real r = Length(Separation(x[p], x[q]));
            if (r < far[p]) { far[p] = r; nearest[p] = q; }
        }
        otherWork += taken[i] + taken[j];
    }
    bool any = false;
    for (int i : alone) if (taken[i] && nearest[i] >= 0) any = true;
    if (!any) return;
    vector<Real> before = DensityBefore();
    for (int i : alone) {
        int q = nearest[i];
        if (!taken[i] || q < 0 || dead[i] || m[i] + m[q] > 1.3 * Mass(level[q])) continue;
        Real share = m[i] / (m[i] + m[q]);
        x[q] += share * Separation(x[i], x[q]);
        v[q] += share * (v[i] - v[q]);
        m[q] += m[i];
        born[q] = time;
        dead[i] = 1;
        dissolved++;
    }
    vector<int> now = Remove(dead);
    for (size_t i = 0; i < now.size(); i++) if (now[i] >= 0) before[now[i]] = before[i];
    for (size_t i = 0; i < deep.size(); i++) if (now[i] >= 0) deep[now[i]] = deep[i];
    Density();
    for (int i = 0; i < Count(); i++) offset[i] += before[i] - rho[i];
}

// Densities as they are before masses pass, and those that what is new takes over.
inline vector<Real> Liquid::DensityBefore() {
    Density();
    vector<Real> before = rho;
    for (auto& g : groups) {
        if (g.step) continue;
        if (!g.splits) before[g.parent] = 0;
        for (int k : g.children) {
            if (g.splits) before[k] = before[g.parent]; else before[g.parent] += before[k] / g.children.size();
        }
    }
    return before;
}

// Before the masses pass: moves the parts of new splits, about their centre, to where the kernel's gradients cancel, lets what is near
// settle, and takes back the changes that would alter a density by more than `accept`, but for splits that are overdue.
inline void Liquid::Arrange(double overdue, const vector<Real>& deep) {
    long seen = pairsSeen;
    vector<Real> kept = m, before = DensityBefore();
    vector<int> owner;
    auto pass = [&] {
        owner.assign(Count(), -1);
        for (size_t q = 0; q < groups.size(); q++) {
            auto& g = groups[q];
            if (g.step) continue;
            m[g.parent] = g.splits ? 0 : g.whole;
            for (size_t k = 0; k < g.children.size(); k++) {
                m[g.children[k]] = g.splits ? g.parts[k] : 0;
                if (g.splits) owner[g.children[k]] = int(q);
            }
            if (!g.splits) owner[g.parent] = int(q);
        }
    };
    pass();
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
            for (int k : g.children) mean += (1 / Real(g.children.size())) * gradient[k];
            for (int k : g.children) {
                Real s = Spacing(level[k]);
                x[k] += (-.15 * s * s) * (gradient[k] - mean);
                otherWork += 100;
            }
        }
    }
    for (int round = 0; round < (settle > 0 ? 6 : 1); round++) {
        vector<Vec> unsettled = x;
        if (settle > 0) Settle(before);
        if (accept <= 0) break;
        Density();
        vector<double> worst(groups.size(), 0);
        vector<Real> change(Count());
        for (int i = 0; i < Count(); i++) if (m[i] > 0) change[i] = std::fabs(rho[i] - (settle > 0 ? offset[i] : 0) - before[i]);
        auto worsen = [&](int i, int j) { if (owner[i] >= 0) worst[owner[i]] = std::max<double>(worst[owner[i]], change[j]); };
        for (int i = 0; i < Count(); i++) if (owner[i] >= 0) { worsen(i, i); otherWork += 50; }
        for (auto [i, j] : pairs)
            if (Length(Separation(x[i], x[j])) <= (settle > 0 ? .8 : .6) * PairSupport(level[i], level[j])) { worsen(i, j); worsen(j, i); }
        vector<char> dead(Count(), 0);
        bool any = false;
        for (size_t q = groups.size(); q-- > 0;) {
            auto& g = groups[q];
            double limit = accept * (patience > 0 ? 1 + g.late / patience : 1);
            if (g.step || worst[q] < limit || (g.splits && deep[g.parent] < overdue)) continue;
            if (g.splits) { group[g.parent] = -1; for (int k : g.children) dead[k] = 1; splits--; }
            else { for (int k : g.children) group[k] = -1; dead[g.parent] = 1; merges--; }
            g.step = -1;
            any = true;
        }
        if (!any) break;
        groups.erase(std::remove_if(groups.begin(), groups.end(), [](const Group& g) { return g.step < 0; }), groups.end());
        x = unsettled;
        vector<int> now = Remove(dead);
        for (size_t i = 0; i < now.size(); i++) if (now[i] >= 0) { before[now[i]] = before[i]; kept[now[i]] = kept[i]; }
        before.resize(Count());
        kept.resize(Count());
        m = kept;
        pass();
    }
    m = kept;
    rho = before;
    if (settle > 0) held = before;
    pairsSeen = seen;
}

// Moves what lies within `rings` neighbourhoods of a change to where the sums of one more neighbourhood are the densities before it:
// least squares by conjugate gradients, linearised anew three times. The common centre of what moves stays.
inline void Liquid::Settle(const vector<Real>& before) {
    const int anew = 3;
    for (int n = 0; n < anew; n++) {
        stale = true;
        Density();
        vector<int> ring(Count(), 99);
        for (auto& g : groups) {
            if (g.step) continue;
            if (g.splits) for (int k : g.children) ring[k] = 0; else ring[g.parent] = 0;
        }
        for (int r = 0; r <= rings; r++)
            for (size_t k = 0; k < pairs.size(); k++) {
                auto [i, j] = pairs[k];
                if (slopeI[k] == 0 || m[i] == 0 || m[j] == 0) continue;
                if (ring[i] == r && ring[j] > r + 1) ring[j] = r + 1;
                if (ring[j] == r && ring[i] > r + 1) ring[i] = r + 1;
            }
        vector<int> near, active;
        for (int i = 0; i < Count(); i++) if (ring[i] <= rings + 1) near.push_back(i);
        if (near.empty()) return;
        for (size_t k = 0; k < pairs.size(); k++) {
            auto [i, j] = pairs[k];
            int near = std::min(ring[i], ring[j]), far = std::max(ring[i], ring[j]);
            if (slopeI[k] != 0 && m[i] > 0 && m[j] > 0 && near <= rings && far <= rings + 1) active.push_back(int(k));
        }
        auto moves = [&](int i) { return ring[i] <= rings; };
        // J: how densities answer to moves; its transpose over the masses
        auto answer = [&](const vector<Vec>& by, vector<Real>& out) {
            for (int i : near) out[i] = moves(i) ? Dot(wallGradient[i], by[i]) : 0;
            for (int k : active) {
                auto [i, j] = pairs[k];
                Real s = slopeI[k] * Dot(direction[k], by[i] - by[j]);
                out[i] += m[j] * s;
                out[j] += m[i] * s;
            }
            for (int i : near) out[i] /= TheLattice.moment;
            otherWork += 2 * active.size();
        };
        auto back = [&](const vector<Real>& of, vector<Vec>& out) {
            for (int i : near) out[i] = moves(i) ? (of[i] / m[i]) * wallGradient[i] : Vec{};
            for (int k : active) {
                auto [i, j] = pairs[k];
                Vec s = (slopeI[k] * (m[j] * of[i] + m[i] * of[j])) * direction[k];
                if (moves(i)) out[i] += (1 / m[i]) * s;
                if (moves(j)) out[j] += (-1 / m[j]) * s;
            }
            for (int i : near) out[i] = (1 / TheLattice.moment) * out[i];
            otherWork += 2 * active.size();
        };
        vector<Real> rest(Count()), q(Count());
        vector<Vec> move(Count()), s(Count()), p(Count());
        for (int i : near) rest[i] = before[i] - (rho[i] - offset[i]);
        back(rest, s);
        p = s;
        auto norm = [&](const vector<Vec>& u) { double sum = 0; for (int i : near) sum += m[i] * Dot(u[i], u[i]); return sum; };
        double gamma = norm(s);
        for (int k = 0; k < settle / anew && gamma > 0; k++) {
            answer(p, q);
            double q2 = 0;
            for (int i : near) q2 += double(q[i]) * q[i];
            q2 += 1e-4 * norm(p);
            Real step = gamma / q2;
            for (int i : near) { move[i] += step * p[i]; rest[i] -= step * q[i]; }
            back(rest, s);
            for (int i : near) if (moves(i)) s[i] += -1e-4 * move[i];
            double next = norm(s);
            for (int i : near) p[i] = s[i] + (next / gamma) * p[i];
            gamma = next;
        }
        Vec mean{};
        Real mass = 0;
        for (int i : near) if (moves(i)) {
            move[i] = std::min<Real>(1, .2 * Spacing(level[i]) / std::max<Real>(1e-9, Length(move[i]))) * move[i];
            mean += m[i] * move[i];
            mass += m[i];
        }
        for (int i : near) if (moves(i)) x[i] += move[i] - (1 / mass) * mean;
    }
    stale = true;
}

// Sum over squares of what densities change by, where particles `from` give way to new ones of a level at `to`.
inline double Liquid::ErrorOf(const vector<int>& from, const vector<Vec>& to, int l) {
    double sum = 0;
    vector<Real> at(to.size());
    Real mean = 0;
    for (int i : from) mean += rho[i] / from.size();
    for (size_t k = 0; k < to.size(); k++) {
        Vec gradient, ofBody;
        at[k] = Mass(l) * W(0, Support(l)) + WallDensity(to[k], l, gradient, ofBody);
        for (size_t q = 0; q < to.size(); q++) if (q != k) at[k] += Mass(l) * W(Length(to[k] - to[q]), Support(l));
    }
    vector<int> near;
    for (int i : from) near.insert(near.end(), neighbours.begin() + neighbourStart[i], neighbours.begin() + neighbourStart[i + 1]);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (int j : near) {
        if (std::find(from.begin(), from.end(), j) != from.end()) continue;
        Real change = 0;
        for (int i : from) change -= m[i] * W(Length(Separation(x[i], x[j])), PairSupport(level[i], level[j]));
        for (size_t k = 0; k < to.size(); k++) {
            Real w = W(Length(Separation(to[k], x[j])), PairSupport(l, level[j]));
            change += Mass(l) * w;
            at[k] += m[j] * w;
        }
        sum += change * change;
        otherWork += from.size() + to.size();
    }
    for (Real r : at) sum += (r - 1 - (mean - 1) * TheLattice.moment) * (r - 1 - (mean - 1) * TheLattice.moment);
    return sum;
}

inline void Liquid::FindNeighbours() {
    neighbourStart.assign(Count() + 1, 0);
    for (auto [i, j] : pairs) { neighbourStart[i + 1]++; neighbourStart[j + 1]++; }
    for (int i = 0; i < Count(); i++) neighbourStart[i + 1] += neighbourStart[i];
    neighbours.resize(2 * pairs.size());
    vector<int> at(neighbourStart.begin(), neighbourStart.end() - 1);
    for (auto [i, j] : pairs) { neighbours[at[i]++] = j; neighbours[at[j]++] = i; }
}

// Whether parts lie as near to their centre as those of a lattice cell, with some room.
inline bool Liquid::Compact(const vector<int>& parts, double late) const {
    double room = arity == 8 ? compact : patience > 0 ? std::min<double>(1.2, .75 + .15 * late / patience) : .75;
    Vec centre{};
    for (int k : parts) centre += (1 / Real(parts.size())) * Separation(x[k], x[parts[0]]);
    for (int k : parts)
        if (Length(Separation(x[k], x[parts[0]]) - centre) > room * Spacing(level[k])) return false;
    return true;
}
