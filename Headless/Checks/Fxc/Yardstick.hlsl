// Takes FXC about half a second, always the same work: see FxcYardstick.cs.
StructuredBuffer<float4> _In;
RWStructuredBuffer<float> _Out;

[numthreads(64, 1, 1)]
void Yardstick(uint id : SV_DispatchThreadID)
{
    float sums[8];
    [unroll]
    for (int i = 0; i < 8; i++)
    {
        sums[i] = 0.0;
    }
    for (uint j = 0u; j < 100u; j++)
    {
        const float4 a = _In[id + j];
        [unroll]
        for (int k = 0; k < 8; k++)
        {
            precise const float along = a.x - float(k) * a.y;
            precise const float t = max(a.z - along * (a.w + along * a.y), 0.0);
            sums[k] += t > a.x ? t * t * t : sqrt(t);
        }
    }
    [unroll]
    for (int m = 0; m < 8; m++)
    {
        _Out[id * 8u + m] = sums[m] / max(sums[(m + 3) % 8], 1e-6);
    }
}
