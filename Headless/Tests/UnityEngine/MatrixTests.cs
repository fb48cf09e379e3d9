using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class MatrixTests
{
    static void Near(Vector3 actual, Vector3 expected, float tolerance = 1e-5f) =>
        Assert.That((actual - expected).magnitude, Is.LessThan(tolerance), $"{actual.ToString("F6")} is not {expected.ToString("F6")}");

    [Test]
    public void MemoryIsColumnMajor()
    {
        Matrix4x4 m = Matrix4x4.Translate(new Vector3(1f, 2f, 3f));
        Assert.That(m.m03, Is.EqualTo(1f));
        Assert.That(m[12], Is.EqualTo(1f));
        Assert.That(m[0, 3], Is.EqualTo(1f));
        Assert.That(m.GetColumn(3), Is.EqualTo(new Vector4(1f, 2f, 3f, 1f)));
        Assert.That(m.GetRow(0), Is.EqualTo(new Vector4(1f, 0f, 0f, 1f)));
        unsafe
        {
            float* first = &m.m00;
            Assert.That(first[13], Is.EqualTo(2f));
        }
    }

    [Test]
    public void TrsScalesThenRotatesThenMoves()
    {
        Matrix4x4 m = Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f), new Vector3(2f, 3f, 4f));
        Near(m.MultiplyPoint3x4(Vector3.forward), new Vector3(5f, 2f, 3f));
        Near(m.MultiplyVector(Vector3.right), new Vector3(0f, 0f, -2f));
        Near(m.lossyScale, new Vector3(2f, 3f, 4f));
        Assert.That(m.rotation == Quaternion.Euler(0f, 90f, 0f), Is.True);
        Assert.That(m.ValidTRS(), Is.True);
        Assert.That(m.determinant, Is.EqualTo(24f).Within(1e-4f));
    }

    [Test]
    public void InverseUndoesAnyRegularMatrix()
    {
        var m = Matrix4x4.Perspective(60f, 1.5f, 0.3f, 100f) * Matrix4x4.TRS(new Vector3(3f, -2f, 9f), Quaternion.Euler(10f, 20f, 30f), new Vector3(1f, -2f, 0.5f));
        Matrix4x4 product = m * m.inverse;
        for (int i = 0; i < 16; i++) Assert.That(product[i], Is.EqualTo(Matrix4x4.identity[i]).Within(1e-3f), i.ToString());
        Assert.That(Matrix4x4.zero.inverse, Is.EqualTo(Matrix4x4.zero));
    }

    [Test]
    public void PerspectiveIsOpenGl()
    {
        Matrix4x4 p = Matrix4x4.Perspective(90f, 2f, 1f, 3f);
        Assert.That(p.m11, Is.EqualTo(1f).Within(1e-6f));
        Assert.That(p.m00, Is.EqualTo(0.5f).Within(1e-6f));
        Assert.That(p.m32, Is.EqualTo(-1f));
        Near(p.MultiplyPoint(new Vector3(0f, 0f, -1f)), new Vector3(0f, 0f, -1f));
        Near(p.MultiplyPoint(new Vector3(0f, 0f, -3f)), new Vector3(0f, 0f, 1f));
        FrustumPlanes planes = p.decomposeProjection;
        Assert.That(planes.zNear, Is.EqualTo(1f).Within(1e-4f));
        Assert.That(planes.zFar, Is.EqualTo(3f).Within(1e-4f));
        Assert.That(planes.right, Is.EqualTo(2f).Within(1e-4f));
    }

    [Test]
    public void OrthoMapsItsBoxToTheUnitCube()
    {
        Matrix4x4 o = Matrix4x4.Ortho(-2f, 4f, -1f, 1f, 0.5f, 10.5f);
        Near(o.MultiplyPoint(new Vector3(-2f, -1f, -0.5f)), new Vector3(-1f, -1f, -1f));
        Near(o.MultiplyPoint(new Vector3(4f, 1f, -10.5f)), new Vector3(1f, 1f, 1f));
    }

    [Test]
    public void LookAtPlacesForwardOnTheTarget()
    {
        Matrix4x4 m = Matrix4x4.LookAt(new Vector3(0f, 0f, -5f), Vector3.zero, Vector3.up);
        Near(m.MultiplyPoint3x4(new Vector3(0f, 0f, 5f)), Vector3.zero);
    }
}
