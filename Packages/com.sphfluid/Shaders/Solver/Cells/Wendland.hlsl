#ifndef SPHFLUID_WENDLAND
#define SPHFLUID_WENDLAND

// Wendland's C2 kernel in three dimensions, support R: W = 21/(2 pi R^3) (1-q)^4 (4q+1), q = r/R
// (Wendland 1995; Dehnen & Aly 2012). One kernel for density and force: two would feed energy in.
float _InverseSupport; // 1/R

// W without its factor; zero outside.
float WendlandShape(float distanceSquared)
{
    const float u = saturate(1.0 - sqrt(distanceSquared) * _InverseSupport); // 1 - q
    return u * u * (u * u) * (5.0 - 4.0 * u);
}

// (1-q)^3: grad W = -210/(pi R^5) (1-q)^3 d for the separation d. No division by r, so none by zero.
float WendlandSlope(float distanceSquared)
{
    const float u = saturate(1.0 - sqrt(distanceSquared) * _InverseSupport);
    return u * u * u;
}

#endif
