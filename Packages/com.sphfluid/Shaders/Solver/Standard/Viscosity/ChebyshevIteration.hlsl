#ifndef SPHFLUID_CHEBYSHEV_ITERATION
#define SPHFLUID_CHEBYSHEV_ITERATION

// The weights of Chebyshev's semi-iteration for a matrix whose spectrum lies in [1, b]. After K iterations an error of the start has
// been multiplied with T_K(l(x)) / T_K(l(0)) of its eigenvalue x, l from [a, b] to [-1, 1]. The lowest zero of T_K is put on x = 1,
// the eigenvalue of whatever moves as one: so a body of liquid that no wall touches has the momentum of v* to rounding, with any K.
//   l(1) = -cos(pi/2K):  a = (2 - b m) / (2 - m),  m = 1 - cos(pi/2K)
// Worked example: b = 47, K = 14: m = 0.00629, a = 0.855; errors are left by 1/T_14(1.037) = 0.044 at most.
StructuredBuffer<uint> _Spectrum; // bits of the largest rate, 1/s
uint _SpectrumSlot;
float _ZeroShare; // m
uint _Iteration;  // done before this one

struct SpectrumInterval
{
    float Low;
    float High;
};

SpectrumInterval Spectrum()
{
    SpectrumInterval interval;
    interval.High = 1.0 + max(_KickStep * asfloat(_Spectrum[_SpectrumSlot]), 0.5);
    // Too few iterations for this b would put a below 0. Then the momentum of the liquid is exact no more, but the step still stable.
    interval.Low = max((2.0 - interval.High * _ZeroShare) / (2.0 - _ZeroShare), 0.1);
    return interval;
}

float FirstStep()
{
    const SpectrumInterval interval = Spectrum();
    return 2.0 / (interval.High + interval.Low);
}

// T_k(s) / T_(k+1)(s), from t = s - sqrt(s^2 - 1).
float Ratio(float t, float k)
{
    const float power = pow(abs(t), 2.0 * k);
    return t * (1.0 + power) / (1.0 + power * t * t);
}

// x: of the last change, y: of the residual.
float2 LaterStep()
{
    const SpectrumInterval interval = Spectrum();
    const float width = interval.High - interval.Low;
    const float over = 2.0 * interval.Low / width; // s - 1
    const float t = 1.0 / (1.0 + over + sqrt(over * (2.0 + over)));
    const float ratio = Ratio(t, float(_Iteration));
    return float2(ratio * Ratio(t, float(_Iteration) - 1.0), 4.0 * ratio / width);
}

#endif
