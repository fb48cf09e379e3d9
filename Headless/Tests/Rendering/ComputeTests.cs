using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class ComputeTests : RenderFixture
{
    private const string TwoKernels = """
        #pragma kernel Fill
        #pragma kernel Scale
        #pragma multi_compile_local _ TRIPLE
        RWStructuredBuffer<float> _Values;
        StructuredBuffer<float> _Source;
        uint _Count;
        float _Factor;

        [numthreads(8, 1, 1)]
        void Fill(uint3 id : SV_DispatchThreadID)
        {
            if (id.x < _Count) _Values[id.x] = id.x;
        }

        [numthreads(4, 2, 1)]
        void Scale(uint3 id : SV_DispatchThreadID)
        {
            uint i = id.x + id.y * 4;
        #ifdef TRIPLE
            if (i < _Count) _Values[i] = _Source[i] * 3;
        #else
            if (i < _Count) _Values[i] = _Source[i] * _Factor;
        #endif
        }
        """;

    [Test]
    public void KernelsShareValuesButNotBuffers()
    {
        ComputeShader shader = Compute(TwoKernels);
        using GraphicsBuffer a = Floats(new float[8]);
        using GraphicsBuffer b = Floats(new float[8]);
        int fill = shader.FindKernel("Fill");
        int scale = shader.FindKernel("Scale");
        shader.SetInt("_Count", 8);
        shader.SetFloat("_Factor", 0.5f);
        shader.SetBuffer(fill, "_Values", a);
        shader.SetBuffer(scale, "_Source", a);
        shader.SetBuffer(scale, "_Values", b);
        shader.Dispatch(fill, 1, 1, 1);
        shader.Dispatch(scale, 1, 1, 1);
        Assert.That(Read(a), Is.EqualTo(new float[] { 0, 1, 2, 3, 4, 5, 6, 7 }));
        Assert.That(Read(b), Is.EqualTo(new float[] { 0, 0.5f, 1, 1.5f, 2, 2.5f, 3, 3.5f }));
    }

    [Test]
    public void GroupSizesAndKernelNames()
    {
        ComputeShader shader = Compute(TwoKernels);
        shader.GetKernelThreadGroupSizes(shader.FindKernel("Scale"), out uint x, out uint y, out uint z);
        Assert.That((x, y, z), Is.EqualTo((4u, 2u, 1u)));
        Assert.That(shader.HasKernel("Fill"), Is.True);
        Assert.That(shader.HasKernel("Nothing"), Is.False);
        Assert.That(shader.IsSupported(0), Is.True);
        Assert.That(() => shader.FindKernel("Nothing"), Throws.ArgumentException.With.Message.Contains("Nothing"));
    }

    [Test]
    public void KeywordsSelectVariants()
    {
        ComputeShader shader = Compute(TwoKernels);
        Assert.That(shader.keywordSpace.keywordNames, Is.EqualTo(new[] { "TRIPLE" }));
        using GraphicsBuffer source = Floats(1, 2, 3);
        using GraphicsBuffer target = Floats(0, 0, 0);
        shader.SetInt("_Count", 3);
        shader.SetFloat("_Factor", 10f);
        shader.SetBuffer(1, "_Source", source);
        shader.SetBuffer(1, "_Values", target);
        var triple = new LocalKeyword(shader, "TRIPLE");
        shader.EnableKeyword(triple);
        shader.Dispatch(1, 1, 1, 1);
        Assert.That(Read(target), Is.EqualTo(new float[] { 3, 6, 9 }));
        shader.DisableKeyword(triple);
        shader.Dispatch(1, 1, 1, 1);
        Assert.That(Read(target), Is.EqualTo(new float[] { 10, 20, 30 }));
    }

    [Test]
    public void CommandBufferCapturesValuesAndRunsLater()
    {
        ComputeShader shader = Compute(TwoKernels);
        using GraphicsBuffer source = Floats(1, 2, 3);
        using GraphicsBuffer first = Floats(0, 0, 0);
        using GraphicsBuffer second = Floats(0, 0, 0);
        using var commands = new CommandBuffer { name = "Test" };
        float[] upload = [4, 5, 6];
        commands.SetBufferData(source, upload);
        commands.SetComputeIntParam(shader, "_Count", 3);
        commands.SetComputeBufferParam(shader, 1, "_Source", source);
        commands.SetComputeFloatParam(shader, "_Factor", 2f);
        commands.SetComputeBufferParam(shader, 1, "_Values", first);
        commands.DispatchCompute(shader, 1, 1, 1, 1);
        commands.SetComputeFloatParam(shader, "_Factor", 3f);
        commands.SetComputeBufferParam(shader, 1, "_Values", second);
        commands.DispatchCompute(shader, 1, 1, 1, 1);

        // Nothing of this reaches the recorded commands.
        upload[0] = 99f;
        shader.SetFloat("_Factor", 100f);
        shader.SetInt("_Count", 0);
        Assert.That(Read(first), Is.EqualTo(new float[] { 0, 0, 0 }));
        Graphics.ExecuteCommandBuffer(commands);
        Assert.That(Read(first), Is.EqualTo(new float[] { 8, 10, 12 }));
        Assert.That(Read(second), Is.EqualTo(new float[] { 12, 15, 18 }));

        // A second run starts from the same recorded values.
        source.SetData(new float[] { 0, 0, 0 });
        Graphics.ExecuteCommandBuffer(commands);
        Assert.That(Read(first), Is.EqualTo(new float[] { 8, 10, 12 }));
    }

    [Test]
    public void IndirectDispatchReadsItsGroupsFromABuffer()
    {
        ComputeShader shader = Compute(TwoKernels);
        using GraphicsBuffer values = Floats(new float[24]);
        using var arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 4, sizeof(uint));
        arguments.SetData(new uint[] { 0, 2, 1, 1 });
        shader.SetInt("_Count", 24);
        shader.SetBuffer(0, "_Values", values);
        shader.DispatchIndirect(0, arguments, 4);
        float[] read = Read(values);
        Assert.That(read[15], Is.EqualTo(15f));
        Assert.That(read[16], Is.EqualTo(0f), "two groups of eight were asked for");
    }

    [Test]
    public void AnUnsetBufferIsNamedAndTheDispatchSkipped()
    {
        ComputeShader shader = Compute(TwoKernels, "Sums");
        using GraphicsBuffer values = Floats(7, 7, 7);
        shader.SetInt("_Count", 3);
        shader.SetBuffer(1, "_Values", values);
        shader.Dispatch(1, 1, 1, 1);
        Assert.That(TakeErrors(), Has.Some.Contains("Compute shader (Sums): Property (_Source) at kernel index (1) is not set"));
        Assert.That(Read(values), Is.EqualTo(new float[] { 7, 7, 7 }));
    }

    [Test]
    public void AReleasedBufferCountsAsUnset()
    {
        ComputeShader shader = Compute(TwoKernels, "Sums");
        GraphicsBuffer values = Floats(7, 7, 7);
        shader.SetInt("_Count", 3);
        shader.SetBuffer(0, "_Values", values);
        values.Release();
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(TakeErrors(), Has.Some.Contains("Property (_Values) at kernel index (0) is not set"));
    }

    [TestCase(0, 1, 1)]
    [TestCase(1, -1, 1)]
    [TestCase(65536, 1, 1)]
    public void BadGroupCountsAreErrors(int x, int y, int z)
    {
        ComputeShader shader = Compute(TwoKernels);
        shader.Dispatch(0, x, y, z);
        Assert.That(TakeErrors(), Has.Some.Contains("group count"));
    }

    [Test]
    public void InstancesOfAShaderAreApart()
    {
        ComputeShader shader = Compute(TwoKernels);
        using GraphicsBuffer a = Floats(new float[8]);
        using GraphicsBuffer b = Floats(new float[8]);
        shader.SetInt("_Count", 8);
        ComputeShader copy = UnityEngine.Object.Instantiate(shader);
        copy.SetInt("_Count", 4);
        shader.SetBuffer(0, "_Values", a);
        copy.SetBuffer(0, "_Values", b);
        shader.Dispatch(0, 1, 1, 1);
        copy.Dispatch(0, 1, 1, 1);
        Assert.That(Read(a)[7], Is.EqualTo(7f));
        Assert.That(Read(b), Is.EqualTo(new float[] { 0, 1, 2, 3, 0, 0, 0, 0 }));
    }

    [Test]
    public void CompileErrorsComeInUnitysForm()
    {
        ComputeShader shader = Compute("#pragma kernel Main\n[numthreads(1,1,1)]\nvoid Main()\n{\n    nothing = 1;\n}\n");
        Assert.That(shader.IsSupported(0), Is.False);
        Assert.That(TakeErrors(), Has.Some.Matches(@"Shader error in '.*\.compute'.*\.compute\(5\)"));
    }

    [Test]
    public void TexturesAreWrittenInTheirOwnFormat()
    {
        ComputeShader shader = Compute("""
            #pragma kernel Main
            RWTexture2D<float4> _Target;
            Texture2D<float4> _Source;
            SamplerState my_point_clamp_sampler;
            [numthreads(4, 4, 1)]
            void Main(uint3 id : SV_DispatchThreadID)
            {
                _Target[id.xy] = _Source.SampleLevel(my_point_clamp_sampler, (id.xy + 0.5) / 4.0, 0) * float4(1, 0.5, 1, 1);
            }
            """);
        var source = new Texture2D(4, 4, TextureFormat.RGBA32, false, true);
        source.SetPixels([.. Enumerable.Range(0, 16).Select(i => new Color(i / 15f, 1f, 0f, 1f))]);
        source.Apply();
        foreach (RenderTextureFormat format in (RenderTextureFormat[])[RenderTextureFormat.ARGB32, RenderTextureFormat.ARGBHalf, RenderTextureFormat.ARGBFloat])
        {
            var target = new RenderTexture(4, 4, 0, format, RenderTextureReadWrite.Linear) { enableRandomWrite = true };
            shader.SetTexture(0, "_Source", source);
            shader.SetTexture(0, "_Target", target);
            shader.Dispatch(0, 1, 1, 1);
            RenderTexture.active = target;
            var read = new Texture2D(4, 4, TextureFormat.RGBAFloat, false, true);
            read.ReadPixels(new Rect(0, 0, 4, 4), 0, 0);
            RenderTexture.active = null;
            Color pixel = read.GetPixel(3, 1);
            Assert.That(pixel.r, Is.EqualTo(7f / 15f).Within(0.003f), format.ToString());
            Assert.That(pixel.g, Is.EqualTo(0.5f).Within(0.003f), format.ToString());
            target.Release();
        }
    }
}
