using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Makes finished binaries of the compiler's SPIR-V: linked, D3D layouts, renumbered, reflected.</summary>
internal static class BinaryBuilder
{
    /// <param name="stages">A kernel alone, or the stages of a pass in pipeline order.</param>
    public static IReadOnlyList<ShaderBinary> Build(IReadOnlyList<(StageJob Job, byte[] SpirV)> stages)
    {
        foreach ((StageJob job, byte[] spirV) in stages)
        {
            WaveOperations.Check(job, new SpirVModule(spirV));
        }
        List<SpirVIndex> modules = [.. stages.Select(s => new SpirVIndex(new SpirVModule(s.SpirV)))];
        IReadOnlyList<VertexInput> inputs = [];
        List<ShaderBinary> binaries = [];
        for (int i = 0; i < stages.Count; i++)
        {
            StageJob job = stages[i].Job;
            try
            {
                inputs = job.Stage == ShaderStage.Vertex ? StageLinker.NumberVertexInputs(modules[i]) : [];
                if (i + 1 < stages.Count)
                {
                    StageLinker.Link(modules[i], job.Stage, modules[i + 1], stages[i + 1].Job.Stage);
                }
                if (job.Stage == ShaderStage.Fragment)
                {
                    StageLinker.NumberTargets(modules[i]);
                }
                binaries.Add(Finish(job, modules[i], inputs));
            }
            catch (InvalidDataException e)
            {
                throw new ShaderCompileException(job.Source.Files[0], 0, $"{e.Message} ({job.Owner})");
            }
        }
        return binaries;
    }

    private static ShaderBinary Finish(StageJob job, SpirVIndex index, IReadOnlyList<VertexInput> inputs)
    {
        int set = job.Stage switch { ShaderStage.Geometry => 1, ShaderStage.Fragment => 2, _ => 0 };
        D3DLayout layout = new(index);
        layout.Apply(keepConstantOffsets: job.Text.Contains("packoffset", StringComparison.Ordinal));
        DescriptorNumbers.Assign(index, set);
        AtomicOperands.Repair(index.Module);
        WaveOperations.MakePrefixesExclusive(index.Module);
        Remainders.Truncate(index.Module);
        GatherBias.Remove(index.Module);
        EntryPointName.Set(index.Module, job.EntryPoint);
        Precision.MakeFull(index.Module);
        return new ShaderReflector(
                index, layout, SourceNames.RawBuffers(job.Declarations), SourceNames.Sized(job.Text), SourceNames.WriteRegisters(job.Text))
            .Read(job.Stage, job.EntryPoint, inputs);
    }
}
