using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Volume, first and second moments of shapes of density 1 about an origin.</summary>
struct MassSum
{
    double m_X, m_Y, m_Z;
    double m_XX, m_YY, m_ZZ, m_XY, m_YZ, m_ZX;

    public double Volume { get; private set; }

    /// <param name="volume">Volume.</param>
    /// <param name="center">Its centre.</param>
    /// <param name="turn">Its principal axes.</param>
    /// <param name="moments">Moments of inertia about those over the volume.</param>
    public void Add(double volume, Vector3 center, Quaternion turn, Vector3 moments)
    {
        Point(volume, center);
        double half = 0.5 * (moments.x + moments.y + moments.z);
        for (int axis = 0; axis < 3; axis++)
        {
            Vector3 direction = Vector3.zero;
            direction[axis] = 1f;
            Square(volume * (half - moments[axis]), turn * direction);
        }
    }

    public void AddTetrahedron(Vector3 a, Vector3 b, Vector3 c)
    {
        double volume = Vector3.Dot(a, Vector3.Cross(b, c)) / 6.0;
        Volume += volume;
        Vector3 sum = a + b + c;
        (m_X, m_Y, m_Z) = (m_X + volume * sum.x / 4.0, m_Y + volume * sum.y / 4.0, m_Z + volume * sum.z / 4.0);
        Square(volume / 20.0, a);
        Square(volume / 20.0, b);
        Square(volume / 20.0, c);
        Square(volume / 20.0, sum);
    }

    /// <summary>The mass over it all.</summary>
    public readonly MassProperties Spread(float mass)
    {
        var center = new Vector3((float)(m_X / Volume), (float)(m_Y / Volume), (float)(m_Z / Volume));
        MassSum about = this;
        about.Square(-Volume, center);
        double trace = about.m_XX + about.m_YY + about.m_ZZ, density = mass / Volume;
        double[,] inertia =
        {
            { trace - about.m_XX, -about.m_XY, -about.m_ZX }, { -about.m_XY, trace - about.m_YY, -about.m_YZ }, { -about.m_ZX, -about.m_YZ, trace - about.m_ZZ },
        };
        Quaternion axes = Diagonalise(inertia);
        return new MassProperties(center, new Vector3((float)(density * inertia[0, 0]), (float)(density * inertia[1, 1]), (float)(density * inertia[2, 2])), axes);
    }

    void Point(double volume, Vector3 at)
    {
        Volume += volume;
        (m_X, m_Y, m_Z) = (m_X + volume * at.x, m_Y + volume * at.y, m_Z + volume * at.z);
        Square(volume, at);
    }

    void Square(double weight, Vector3 v)
    {
        m_XX += weight * v.x * v.x;
        m_YY += weight * v.y * v.y;
        m_ZZ += weight * v.z * v.z;
        m_XY += weight * v.x * v.y;
        m_YZ += weight * v.y * v.z;
        m_ZX += weight * v.z * v.x;
    }

    // Jacobi's rotations; what is diagonal up to rounding stays as it is.
    static Quaternion Diagonalise(double[,] m)
    {
        var axes = Quaternion.identity;
        for (int sweep = 0; sweep < 24; sweep++)
        {
            int p = sweep % 3, q = (p + 1) % 3;
            if (Math.Abs(m[p, q]) <= 1e-6 * (m[0, 0] + m[1, 1] + m[2, 2])) continue;
            double angle = 0.5 * Math.Atan2(2.0 * m[p, q], m[p, p] - m[q, q]);
            double c = Math.Cos(angle), s = Math.Sin(angle);
            for (int k = 0; k < 3; k++) (m[k, p], m[k, q]) = (c * m[k, p] + s * m[k, q], c * m[k, q] - s * m[k, p]);
            for (int k = 0; k < 3; k++) (m[p, k], m[q, k]) = (c * m[p, k] + s * m[q, k], c * m[q, k] - s * m[p, k]);
            Vector3 around = Vector3.zero;
            around[3 - p - q] = 1f;
            axes *= Quaternion.AngleAxis((float)(angle * 180.0 / Math.PI), around);
        }
        return axes;
    }
}
