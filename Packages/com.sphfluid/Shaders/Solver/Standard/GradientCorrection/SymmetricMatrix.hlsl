#ifndef SPHFLUID_SYMMETRIC_MATRIX
#define SPHFLUID_SYMMETRIC_MATRIX

struct SymmetricMatrix
{
    float3 Diagonal; // xx, yy, zz
    float3 Shear;    // yz, zx, xy
};

SymmetricMatrix Scaled(SymmetricMatrix a, float factor)
{
    a.Diagonal *= factor;
    a.Shear *= factor;
    return a;
}

void AddScaled(inout SymmetricMatrix sum, SymmetricMatrix a, float factor)
{
    sum.Diagonal += factor * a.Diagonal;
    sum.Shear += factor * a.Shear;
}

// Adds the symmetric part of a b^T.
void AddProduct(inout SymmetricMatrix sum, float3 a, float3 b)
{
    sum.Diagonal += a * b;
    sum.Shear += 0.5 * (a.yzx * b.zxy + a.zxy * b.yzx);
}

float3 Times(SymmetricMatrix a, float3 v)
{
    return a.Diagonal * v + a.Shear.zxy * v.yzx + a.Shear.yzx * v.zxy;
}

// In a mirror: -1 along each axis that is mirrored, else 1.
SymmetricMatrix Mirrored(SymmetricMatrix a, float3 mirror)
{
    a.Shear *= mirror.yzx * mirror.zxy;
    return a;
}

// As six half floats.
uint3 PackMatrix(SymmetricMatrix a)
{
    const uint3 low = uint3(f32tof16(a.Diagonal.x), f32tof16(a.Diagonal.y), f32tof16(a.Diagonal.z));
    const uint3 high = uint3(f32tof16(a.Shear.x), f32tof16(a.Shear.y), f32tof16(a.Shear.z));
    return low | (high << 16u);
}

SymmetricMatrix UnpackMatrix(uint3 packed)
{
    SymmetricMatrix a;
    a.Diagonal = f16tof32(packed & 0xffffu);
    a.Shear = f16tof32(packed >> 16u);
    return a;
}

// Eigenvalues of a matrix about the mean of its diagonal, the largest first: 2 p cos(phi + 2 pi k/3) of its deviator (Smith 1961).
float3 Eigenvalues(SymmetricMatrix deviator, float p)
{
    const SymmetricMatrix unit = Scaled(deviator, 1.0 / p);
    const float3 x = unit.Diagonal;
    const float3 s = unit.Shear;
    const float determinant = x.x * x.y * x.z + 2.0 * s.x * s.y * s.z - dot(x, s * s);
    const float angle = acos(clamp(0.5 * determinant, -1.0, 1.0)) / 3.0;
    const float first = 2.0 * p * cos(angle);
    const float last = 2.0 * p * cos(angle + 2.0943951);
    return float3(first, -first - last, last);
}

#define LEAST_EIGENVALUE 0.77 // what is less is inverted as this

// The divided difference of 1/max(x, 0.77) between two eigenvalues. Of equal ones any slope serves: it is multiplied by their difference.
float InverseSlope(float a, float b, float apart)
{
    const float within = max(a, LEAST_EIGENVALUE) - max(b, LEAST_EIGENVALUE);
    const float part = apart > 1e-12 ? saturate(within / apart) : 1.0;
    return -part / (max(a, LEAST_EIGENVALUE) * max(b, LEAST_EIGENVALUE));
}

// B - 1 of a mean moment over M: its eigenvalues x become w (min(1/x, 1.3) - 1), where w falls from 1 to 0 with the least x from 0.45 to
// 0.2: particles alone are not changed. By Newton's polynomial through the eigenvalues, which is right to second order in their errors,
// however near they are to each other.
SymmetricMatrix Correction(SymmetricMatrix a)
{
    const float mean = (a.Diagonal.x + a.Diagonal.y + a.Diagonal.z) / 3.0;
    SymmetricMatrix k = a;
    k.Diagonal -= mean;
    const float p = sqrt((dot(k.Diagonal, k.Diagonal) + 2.0 * dot(k.Shear, k.Shear)) / 6.0);
    const float3 x = p > 1e-7 ? Eigenvalues(k, max(p, 1e-7)) : float3(0.0, 0.0, 0.0);
    const float3 own = mean + x;
    const float t = saturate((own.z - 0.2) / 0.25);
    const float weight = t * t * (3.0 - 2.0 * t);
    const float first = InverseSlope(own.x, own.y, x.x - x.y);
    const float second = p > 1e-7 ? (first - InverseSlope(own.y, own.z, x.y - x.z)) / max(x.x - x.z, 1e-7) : 0.0;
    // 1/max(a, 0.77) = f + first (k - x1) + second (k - x1)(k - x2)
    const float constant = 1.0 / max(own.x, LEAST_EIGENVALUE) - first * x.x + second * x.x * x.y - 1.0;
    const float rise = first - second * (x.x + x.y);
    const float3 d = k.Diagonal;
    const float3 s = k.Shear;
    const float3 squares = s * s;
    SymmetricMatrix correction;
    correction.Diagonal = weight * (constant + rise * d + second * (d * d + squares.yzx + squares.zxy));
    correction.Shear = weight * (rise * s + second * (s * (d.yzx + d.zxy) + s.yzx * s.zxy));
    return correction;
}

#endif
