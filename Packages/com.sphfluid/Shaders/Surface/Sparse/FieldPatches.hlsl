#ifndef SPHFLUID_FIELD_PATCHES
#define SPHFLUID_FIELD_PATCHES

// Sums over the particles at the samples of a patch, in registers: a particle is read once for 27 samples, and no thread
// writes where another does. What a particle gives to a sample, and the order of the particles, depend on places alone:
// whoever computes a sample gets the same bits. Particles in no reach of it add exact zeros.
#include "BlockParticles.hlsl"

#if defined(SURFACE_ANISOTROPIC)
StructuredBuffer<KernelShape> _SurfaceShapes;
#endif

#define PATCH_ROWS (PATCH_SIDE * PATCH_SIDE)
#define PATCH_SAMPLES (PATCH_ROWS * PATCH_SIDE)

// Places of the samples of a patch along each axis.
struct PatchPlaces
{
    float3 x;
    float3 y;
    float3 z;
};

PatchPlaces PlacesOf(int3 first)
{
    const float3 numbers = float3(0.0, 1.0, 2.0);
    precise PatchPlaces places;
    places.x = _FieldStep.x * (float(first.x) + numbers);
    places.y = _FieldStep.y * (float(first.y) + numbers);
    places.z = _FieldStep.z * (float(first.z) + numbers);
    return places;
}

// Adds a kernel of a loaded particle to the samples of a patch. Along x, d . M d is left + x (tilt + x stretch).
void AddKernel(float4 kernel, uint place, PatchPlaces places, inout float3 sums[PATCH_ROWS])
{
#if defined(SURFACE_ANISOTROPIC)
    const KernelShape shape = _SurfaceShapes[pool[LOADED_INDICES_AT + place]];
#endif
    precise const float3 x = kernel.x - places.x;
    precise const float3 y = kernel.y - places.y;
    precise const float3 z = kernel.z - places.z;
    [unroll]
    for (int row = 0; row < PATCH_ROWS; row++)
    {
        const float2 d = float2(y[row % PATCH_SIDE], z[row / PATCH_SIDE]);
#if defined(SURFACE_ANISOTROPIC)
        precise const float left = 1.0 - d.x * d.x * shape.Diagonal.y - d.y * d.y * shape.Diagonal.z - 2.0 * d.x * d.y * shape.Mixed.z;
        precise const float tilt = 2.0 * (d.x * shape.Mixed.x + d.y * shape.Mixed.y);
        precise const float3 t = saturate(left - x * (tilt + x * shape.Diagonal.x));
#else
        precise const float left = mad(-d.y, d.y, mad(-d.x, d.x, 1.0));
        precise const float3 t = saturate(mad(-x, x, left));
#endif
        precise const float3 cube = t * t * t;
        precise const float3 sum = mad(abs(kernel.w), cube, sums[row]);
        sums[row] = sum;
    }
}

// Adds what a load of particles gives to the samples of a patch. In one loop over all of its bits: threads that run side by
// side then wait less for each other.
void AddLoad(uint load, int3 patch, PatchPlaces places, inout float3 sums[PATCH_ROWS])
{
    uint4 mask = MaskOf(load, patch);
    uint behind = 0u;
    while ((mask.x | mask.y | mask.z | mask.w) != 0u)
    {
        const uint2 word = FirstWord(mask);
        const uint place = 32u * word.x + firstbitlow(word.y);
        const float4 kernel = LoadedKernel(place + behind);
        const bool hasSecond = KERNELS == 2 && kernel.w < 0.0;
        behind = hasSecond ? LOAD_SIZE : 0u;
        const uint rest = hasSecond ? word.y : word.y & (word.y - 1u);
        mask = word.x == uint4(0u, 1u, 2u, 3u) ? rest : mask;
        AddKernel(kernel, place, places, sums);
    }
}

// Sums at the samples of a thread's patch; threads from PATCH_COUNT on have none. first: first sample of the block.
// Barriers within.
void SumPatch(int3 first, uint thread, out float3 sums[PATCH_ROWS])
{
    [unroll]
    for (int cleared = 0; cleared < PATCH_ROWS; cleared++)
    {
        sums[cleared] = float3(0.0, 0.0, 0.0);
    }
    ClearMasks(0u, thread);
    const int3 patch = PatchAt(min(thread, PATCH_COUNT - 1u));
    const PatchPlaces places = PlacesOf(first + PATCH_SIDE * patch);
    uint load = 0u;
    uint rows = 1u; // at least; known after the first turn: FXC takes minutes for a do-while
    for (uint firstRow = 0u; firstRow < rows; firstRow += SAMPLE_THREADS)
    {
        const uint2 taken = TakeRows(first, firstRow, thread);
        const uint count = taken.x;
        rows = taken.y;
        uint row = 0u;
        for (uint candidate = 0u; candidate < count; candidate += LOAD_SIZE)
        {
            // Not before the loops: few registers stay in use while particles are added.
            LoadCandidates(PatchesOf(first), candidate, count, load, thread, row);
            ClearMasks(load + 1u, thread);
            GroupMemoryBarrierWithGroupSync();
            if (thread < PATCH_COUNT)
            {
                AddLoad(load, patch, places, sums);
            }
            GroupMemoryBarrierWithGroupSync();
            load++;
        }
    }
}

#endif
