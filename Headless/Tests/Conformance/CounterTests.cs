using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Conformance;

/// <summary>Append, consume and counted buffers.</summary>
public sealed class CounterTests : HlslFixture
{
    private const string Append = """
        #pragma kernel Main
        struct Entry { float3 place; float value; };
        AppendStructuredBuffer<Entry> _List;
        [numthreads(64, 1, 1)] void Main(uint id : SV_DispatchThreadID)
        {
            Entry entry;
            entry.place = id;
            entry.value = id + 1;
            if (id % 3 == 0) _List.Append(entry);
        }
        """;

    private const string Consume = """
        #pragma kernel Main
        struct Entry { float3 place; float value; };
        ConsumeStructuredBuffer<Entry> _List;
        RWStructuredBuffer<float> _Result;
        [numthreads(1, 1, 1)] void Main(uint id : SV_DispatchThreadID)
        {
            _Result[0] = _List.Consume().value;
            _Result[1] = _List.Consume().value;
        }
        """;

    private const string Count = """
        #pragma kernel Main
        RWStructuredBuffer<uint> _List;
        [numthreads(1, 1, 1)] void Main()
        {
            _List[0] = _List.IncrementCounter();
            _List[1] = _List.IncrementCounter();
            _List[2] = _List.DecrementCounter();
        }
        """;

    private static uint CountOf(GraphicsBuffer buffer)
    {
        using var count = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 4, 4);
        GraphicsBuffer.CopyCount(buffer, count, 8);
        var words = new uint[4];
        count.GetData(words);
        return words[2];
    }

    [Test]
    public void AppendedElementsAreCountedAndKept()
    {
        using var list = new GraphicsBuffer(GraphicsBuffer.Target.Append, 128, 16);
        ComputeShader shader = Compute(Append);
        shader.SetBuffer(0, "_List", list);
        list.SetCounterValue(0);
        shader.Dispatch(0, 2, 1, 1);
        Assert.That(CountOf(list), Is.EqualTo(43u));
        var entries = new Vector4[43];
        list.GetData(entries);
        Assert.That(entries.Select(e => e.w - 1f).Order(), Is.EqualTo(Enumerable.Range(0, 43).Select(i => i * 3f)));
        Assert.That(entries.All(e => e.x == e.w - 1f), Is.True);
    }

    [Test]
    public void ACounterGoesOnBetweenDispatchesUntilItIsSet()
    {
        using var list = new ComputeBuffer(128, 16, ComputeBufferType.Append);
        ComputeShader shader = Compute(Append);
        shader.SetBuffer(0, "_List", list);
        shader.Dispatch(0, 1, 1, 1);
        shader.Dispatch(0, 1, 1, 1);
        using var count = new ComputeBuffer(1, 4, ComputeBufferType.Raw);
        var words = new uint[1];
        ComputeBuffer.CopyCount(list, count, 0);
        count.GetData(words);
        Assert.That(words[0], Is.EqualTo(44u));
        list.SetCounterValue(7);
        ComputeBuffer.CopyCount(list, count, 0);
        count.GetData(words);
        Assert.That(words[0], Is.EqualTo(7u));
    }

    [Test]
    public void ConsumeTakesTheLastElementFirst()
    {
        using var list = new GraphicsBuffer(GraphicsBuffer.Target.Append, 3, 16);
        using GraphicsBuffer result = Floats(0, 0);
        list.SetData(new[] { new Vector4(0, 0, 0, 10), new Vector4(0, 0, 0, 20), new Vector4(0, 0, 0, 30) });
        list.SetCounterValue(3);
        ComputeShader shader = Compute(Consume);
        shader.SetBuffer(0, "_List", list);
        shader.SetBuffer(0, "_Result", result);
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(Read(result), Is.EqualTo(new float[] { 30, 20 }));
        Assert.That(CountOf(list), Is.EqualTo(1u));
    }

    [Test]
    public void IncrementYieldsTheValueBeforeAndDecrementTheValueAfter()
    {
        using var list = new GraphicsBuffer(GraphicsBuffer.Target.Counter, 3, 4);
        ComputeShader shader = Compute(Count);
        shader.SetBuffer(0, "_List", list);
        list.SetCounterValue(5);
        shader.Dispatch(0, 1, 1, 1);
        var words = new uint[3];
        list.GetData(words);
        Assert.That(words, Is.EqualTo(new uint[] { 5, 6, 6 }));
        Assert.That(CountOf(list), Is.EqualTo(6u));
    }

    [Test]
    public void ACommandBufferSetsAndCopiesCountersInOrder()
    {
        using var list = new GraphicsBuffer(GraphicsBuffer.Target.Append, 128, 16);
        using var counts = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 2, 4);
        ComputeShader shader = Compute(Append);
        shader.SetBuffer(0, "_List", list);
        using var commands = new CommandBuffer();
        commands.SetBufferCounterValue(list, 9);
        commands.CopyCounterValue(list, counts, 0);
        commands.SetBufferCounterValue(list, 0);
        commands.DispatchCompute(shader, 0, 1, 1, 1);
        commands.CopyCounterValue(list, counts, 4);
        Graphics.ExecuteCommandBuffer(commands);
        var words = new uint[2];
        counts.GetData(words);
        Assert.That(words, Is.EqualTo(new uint[] { 9, 22 }));
    }

    [Test]
    public void ABufferWithoutACounterIsNamed()
    {
        using var list = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 128, 16) { name = "Plain" };
        ComputeShader shader = Compute(Append);
        shader.SetBuffer(0, "_List", list);
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(TakeErrors().Single(), Does.Contain("_List").And.Contain("Append or Counter"));
        Assert.That(() => list.SetCounterValue(1), Throws.ArgumentException.With.Message.Contains("Plain"));
        Assert.That(() => CountOf(list), Throws.ArgumentException.With.Message.Contains("no counter"));
    }
}
