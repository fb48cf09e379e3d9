using Headless.Engine;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class BufferTests : RenderFixture
{
    private struct WithReference
    {
        public string Text;
    }

    [Test]
    public void NewBuffersHoldZeros()
    {
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1000, 12);
        Assert.That(Read(buffer), Is.All.EqualTo(0f));
        Assert.That((buffer.count, buffer.stride), Is.EqualTo((1000, 12)));
    }

    [Test]
    public void RangesOfArraysListsAndNativeArrays()
    {
        using GraphicsBuffer buffer = Floats(0, 0, 0, 0, 0, 0);
        buffer.SetData(new float[] { 9, 1, 2, 9 }, 1, 0, 2);
        buffer.SetData(new List<float> { 9, 3, 9 }, 1, 2, 1);
        using var native = new NativeArray<float>(new float[] { 4, 5 }, Allocator.Temp);
        buffer.SetData(native, 0, 3, 2);
        Assert.That(Read(buffer), Is.EqualTo(new float[] { 1, 2, 3, 4, 5, 0 }));
        var part = new float[4];
        buffer.GetData(part, 1, 2, 2);
        Assert.That(part, Is.EqualTo(new float[] { 0, 3, 4, 0 }));
    }

    [Test]
    public void StructsMustFitTheStride()
    {
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 16);
        Assert.That(() => buffer.SetData(new Vector3[4]), Throws.ArgumentException.With.Message.Contains("stride"));
        Assert.That(() => buffer.SetData(new Vector4[5]), Throws.ArgumentException);
        Assert.That(() => buffer.SetData(new WithReference[4]), Throws.ArgumentException.With.Message.Contains("blittable"));
        Assert.That(() => buffer.SetData(new Vector4[4], 0, 0, 5), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(0, 4)]
    [TestCase(4, 0)]
    [TestCase(4, 6)]
    public void BadSizesAreRefused(int count, int stride) =>
        Assert.That(() => new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, stride), Throws.ArgumentException);

    [Test]
    public void SizesBeyondTheDeviceAreRefusedByName()
    {
        int count = (int)Math.Min(int.MaxValue, (SystemInfo.maxGraphicsBufferSize / 16) + 1);
        Assume.That(count, Is.LessThan(int.MaxValue));
        Assert.That(
            () => new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, 16),
            Throws.ArgumentException.With.Message.Contains(SystemInfo.maxGraphicsBufferSize.ToString()));
    }

    [Test]
    public void ReleasedBuffersSayWhatIsWrong()
    {
        GraphicsBuffer buffer = Floats(1f);
        buffer.name = "Particles";
        Assert.That(buffer.IsValid(), Is.True);
        buffer.Release();
        buffer.Release();
        Assert.That(buffer.IsValid(), Is.False);
        Assert.That(() => buffer.SetData(new float[1]), Throws.Exception.With.Message.Contains("Particles"));
    }

    [Test]
    public void ForgottenBuffersAreReportedAndFreed()
    {
        long before = Headless.Engine.GraphicsDevice.Device.AllocatedBytes;
        Forget();
        for (int i = 0; i < 20 && !Warnings.Any(w => w.Contains("GarbageCollector disposing of GraphicsBuffer")); i++)
        {
            Headless.Engine.GraphicsDevice.FindLeaks();
        }

        Assert.That(Warnings, Has.Some.Contains("Please use GraphicsBuffer.Release() or .Dispose()").And.Some.Contains("Forgotten"));
        Assert.That(Headless.Engine.GraphicsDevice.Device.AllocatedBytes - before, Is.LessThan(1 << 20));
    }

    [Test]
    public void LockedBuffersAreWrittenOnUnlock()
    {
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, GraphicsBuffer.UsageFlags.LockBufferForWrite, 4, 4);
        NativeArray<float> memory = buffer.LockBufferForWrite<float>(1, 2);
        memory[0] = 5f;
        memory[1] = 6f;
        buffer.UnlockBufferAfterWrite<float>(2);
        Assert.That(Read(buffer), Is.EqualTo(new float[] { 0, 5, 6, 0 }));
    }

    [Test]
    public void CopiesKeepTheirPlaceInTheOrder()
    {
        using var a = new GraphicsBuffer(GraphicsBuffer.Target.CopySource | GraphicsBuffer.Target.Structured, 2, 4);
        using var b = new GraphicsBuffer(GraphicsBuffer.Target.CopyDestination | GraphicsBuffer.Target.Structured, 2, 4);
        a.SetData(new float[] { 1, 2 });
        Graphics.CopyBuffer(a, b);
        a.SetData(new float[] { 3, 4 });
        Assert.That(Read(b), Is.EqualTo(new float[] { 1, 2 }));
    }

    [Test]
    public void CopiesNeedTheirTargetFlags()
    {
        using GraphicsBuffer a = Floats(1, 2);
        using GraphicsBuffer b = Floats(0, 0);
        Assert.That(() => Graphics.CopyBuffer(a, b), Throws.ArgumentException.With.Message.Contains("CopySource"));
    }

    [Test]
    public void ReadbacksSeeTheDataOfTheirTime()
    {
        using GraphicsBuffer buffer = Floats(1, 2, 3);
        float[]? called = null;
        AsyncGPUReadbackRequest whole = AsyncGPUReadback.Request(buffer, r => called = r.GetData<float>().ToArray());
        AsyncGPUReadbackRequest part = AsyncGPUReadback.Request(buffer, 4, 8);
        buffer.SetData(new float[] { 9, 9, 9 });
        Assert.That(called, Is.Null);
        whole.WaitForCompletion();
        Assert.That(called, Is.EqualTo(new float[] { 1, 2, 3 }));
        part.WaitForCompletion();
        Assert.That(part.GetData<float>()[0], Is.EqualTo(3f));
        Assert.That((part.done, part.hasError, part.layerDataSize), Is.EqualTo((true, false, 4)));
    }

    [Test]
    public void ReadbacksFinishByThemselvesWithinFrames()
    {
        using GraphicsBuffer buffer = Floats(4f);
        float seen = 0f;
        AsyncGPUReadback.Request(buffer, r => seen = r.GetData<float>()[0]);
        for (int i = 0; i < 100 && seen == 0f; i++)
        {
            Frame();
            Thread.Sleep(5);
        }

        Assert.That(seen, Is.EqualTo(4f));
    }

    [TestCase(1)]
    [TestCase(3)]
    public void ReadbacksArriveNoSoonerThanTheyMay(int frames)
    {
        using GraphicsBuffer buffer = Floats(4f);
        AsyncReadbacks.Frames = frames;
        try
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer);
            for (int i = 1; i < frames; i++)
            {
                Frame();
                Thread.Sleep(5);
                Assert.That(request.done, Is.False);
            }

            for (int i = 0; i < 100 && !request.done; i++)
            {
                Frame();
                Thread.Sleep(5);
            }

            Assert.That(request.done);
        }
        finally
        {
            AsyncReadbacks.Frames = 1;
        }
    }

    [Test]
    public void ReadbacksOfNothingFailWithAMessage()
    {
        GraphicsBuffer buffer = Floats(1f);
        buffer.Release();
        AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer);
        Assert.That((request.done, request.hasError), Is.EqualTo((true, true)));
        Assert.That(TakeErrors(), Has.Some.Contains("released"));
    }

    [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]
    private static void Forget() => _ = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1 << 20, 16) { name = "Forgotten" };

    [TestCase(GraphicsBuffer.Target.Index)]
    [TestCase(GraphicsBuffer.Target.Vertex)]
    public void DrawnBuffersAreRawNotStructured(GraphicsBuffer.Target target)
    {
        Assert.That(
            () => new GraphicsBuffer(target | GraphicsBuffer.Target.Structured, 4, 4), Throws.ArgumentException.With.Message.Contains("DirectX 11").And.Message.Contains("Raw"));
        using var raw = new GraphicsBuffer(target | GraphicsBuffer.Target.Raw, 4, 4);
        Assert.That(raw.IsValid(), Is.True);
    }
}
