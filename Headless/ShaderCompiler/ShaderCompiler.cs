using System.Collections.Concurrent;
using Headless.Files;

namespace Headless.Shaders;

/// <summary>Compiles kernels and passes; finished binaries are kept in memory and on disk. Safe for several threads.</summary>
public sealed class ShaderCompiler
{
    private const int ComputeTarget = 50;

    private readonly ConcurrentDictionary<(object Source, string Kernel, string Keywords), Lazy<IReadOnlyList<ShaderBinary>>> _made = new();
    private readonly ShaderCache _cache;
    private readonly GlslangProcess _compiler;
    private readonly string _program;
    private int _compilations;

    /// <param name="cacheDirectory">Created when something is written; may be absent.</param>
    /// <param name="compilerProgram">Name or path of glslangValidator.</param>
    public ShaderCompiler(string cacheDirectory, IncludeResolver includes, string compilerProgram = "glslangValidator")
    {
        CacheDirectory = Path.GetFullPath(cacheDirectory);
        Includes = includes;
        _program = compilerProgram;
        _cache = new ShaderCache(CacheDirectory);
        _compiler = new GlslangProcess(compilerProgram);
    }

    public string CacheDirectory { get; }
    public IncludeResolver Includes { get; }

    /// <summary>Compiles the kernels in the place of glslang, which still makes passes and what this cannot translate.</summary>
    public Direct3DFrontEnd? Direct3D { get; init; }

    /// <summary>Entry points compiled by this object, not counting those from memory or disk.</summary>
    public int Compilations => _compilations;

    /// <summary>What is compiled now, for a line of progress; null between compilations.</summary>
    public string? Activity { get; private set; }

    /// <summary>Why the cache could not be written; null when it could.</summary>
    public string? CacheProblem => _cache.WriteProblem;

    /// <param name="keywords">Enabled keywords; those that the source does not declare are ignored.</param>
    /// <exception cref="ShaderCompileException">No such kernel, a keyword set without a choice, or an error in the source.</exception>
    /// <exception cref="ShaderCompilerMissingException">Not in the cache, and no compiler.</exception>
    public ShaderBinary CompileKernel(ComputeSource source, string kernel, IReadOnlyCollection<string> keywords)
    {
        KernelDeclaration declaration = source.Kernels.FirstOrDefault(k => k.Name == kernel)
            ?? throw new ShaderCompileException(source.Path, 0, $"no \"#pragma kernel {kernel}\"");
        IReadOnlyList<string> chosen = KeywordSelection.Choose(source.KeywordSets, keywords, needsChoice: true, source.Path);
        return Once(source, kernel, chosen, () => [KernelJob(source, declaration, chosen)])[0];
    }

    /// <summary>A kernel with the line that each instruction comes from, for checks; neither linked nor kept.</summary>
    /// <param name="lineOf">File and line of a line that an OpLine names.</param>
    internal byte[] CompileWithLines(ShaderRequest request, out Func<int, (string File, int Line)> lineOf)
    {
        ComputeSource source = request.Source!;
        IReadOnlyList<string> chosen = KeywordSelection.Choose(source.KeywordSets, request.Keywords, needsChoice: true, source.Path);
        StageJob job = KernelJob(source, source.Kernels.First(k => k.Name == request.Kernel), chosen);
        lineOf = line => SourceLines.OfLine(job, line);
        return _compiler.Compile(SourceLines.CountedFromTheTop(job), lines: true);
    }

    /// <summary>Stages in pipeline order: vertex, geometry (if any), fragment.</summary>
    /// <exception cref="ShaderCompileException">An error in the source, or something the headless player does not support.</exception>
    /// <exception cref="ShaderCompilerMissingException">Not in the cache, and no compiler.</exception>
    public IReadOnlyList<ShaderBinary> CompilePass(ShaderPass pass, IReadOnlyCollection<string> keywords)
    {
        ShaderProgram program = pass.Program;
        if (pass.Unsupported is { } unsupported)
        {
            throw new ShaderCompileException(program.Path, unsupported.Line, unsupported.Message);
        }
        IReadOnlyList<string> chosen = KeywordSelection.Choose(program.KeywordSets, keywords, needsChoice: false, program.Path);
        return Once(pass, "", chosen, () => PassJobs(pass, chosen));
    }

    /// <summary>Compiles the requests on all cores, so that later calls are answered from memory.</summary>
    /// <exception cref="ShaderCompileException">The first request in order that fails; the others are compiled all the same.</exception>
    public void Prewarm(IEnumerable<ShaderRequest> requests)
    {
        List<ShaderRequest> all = [.. requests];
        Exception?[] failures = new Exception?[all.Count];
        Parallel.For(0, all.Count, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount }, i =>
        {
            try
            {
                Compile(all[i]);
            }
            catch (Exception e)
            {
                failures[i] = e;
            }
        });
        if (failures.FirstOrDefault(f => f is not null) is { } failure)
        {
            System.Runtime.ExceptionServices.ExceptionDispatchInfo.Throw(failure);
        }
    }

    private void Compile(ShaderRequest request)
    {
        if (request.Pass is not null)
        {
            CompilePass(request.Pass, request.Keywords);
        }
        else
        {
            CompileKernel(request.Source!, request.Kernel!, request.Keywords);
        }
    }

    private StageJob KernelJob(ComputeSource source, KernelDeclaration kernel, IReadOnlyList<string> keywords)
    {
        string text = StageText.Build(source.Expanded, ShaderStage.Compute, ComputeTarget, kernel.Defines, keywords);
        (text, string name) = KernelNames.Separate(text, kernel.Name);
        return new StageJob(source.Expanded, ShaderStage.Compute, kernel.Name, text, $"kernel '{kernel.Name}'")
        {
            SourceEntryPoint = name,
            Plain = () => StageText.Plain(source.Expanded, ShaderStage.Compute, ComputeTarget, kernel.Defines, keywords),
        };
    }

    private List<StageJob> PassJobs(ShaderPass pass, IReadOnlyList<string> keywords)
    {
        ShaderProgram program = pass.Program;
        string owner = pass.Name.Length > 0 ? $"pass '{pass.Name}' of '{pass.ShaderName}'" : $"a pass of '{pass.ShaderName}'";
        List<StageJob> jobs = [];
        Add(ShaderStage.Vertex, program.Vertex);
        if (program.Geometry.Length > 0)
        {
            Add(ShaderStage.Geometry, program.Geometry);
        }
        Add(ShaderStage.Fragment, program.Fragment);
        return jobs;

        void Add(ShaderStage stage, string entry)
        {
            int target = program.TargetOf(keywords);
            string text = StageText.Build(program.Expanded, stage, target, pass.Defines, keywords);
            jobs.Add(new StageJob(program.Expanded, stage, entry, text, $"{owner}, {stage} stage '{entry}'")
            {
                Plain = () => StageText.Plain(program.Expanded, stage, target, pass.Defines, keywords),
            });
        }
    }

    private IReadOnlyList<ShaderBinary> Once(
        object source, string kernel, IReadOnlyList<string> keywords, Func<IReadOnlyList<StageJob>> jobs) =>
        _made.GetOrAdd(
            (source, kernel, string.Join(' ', keywords)),
            _ => new Lazy<IReadOnlyList<ShaderBinary>>(() => Guarded(source, jobs))).Value;

    /// <summary>Code that the compiler takes and nobody has thought of here is a fault of the file too.</summary>
    private IReadOnlyList<ShaderBinary> Guarded(object source, Func<IReadOnlyList<StageJob>> jobs)
    {
        try
        {
            return Make(jobs());
        }
        catch (Exception e) when (e is FormatException or ArgumentException or KeyNotFoundException or IndexOutOfRangeException or InvalidOperationException
            or InvalidCastException or OverflowException or NotSupportedException or TimeoutException)
        {
            string file = source is ComputeSource compute ? compute.Path : ((ShaderPass)source).Program.Path;
            throw new ShaderCompileException(file, 0, $"cannot be translated for this device: {OneLine.Value(e.Message)}");
        }
    }

    private IReadOnlyList<ShaderBinary> Make(IReadOnlyList<StageJob> jobs) =>
        Direct3D is not null && jobs is [{ Stage: ShaderStage.Compute } kernel] && MakeByDirect3D(Direct3D, kernel) is { } binary
            ? [binary]
            : MakeByGlslang(jobs);

    private ShaderBinary? MakeByDirect3D(Direct3DFrontEnd compiler, StageJob job)
    {
        string key = ShaderCache.Key([job], compiler.Version);
        ShaderBinary? binary = _cache.Read(key, compiler.Version)?[0];
        if (binary is null && compiler.Compile(job) is { } made)
        {
            Interlocked.Increment(ref _compilations);
            _cache.Write(key, compiler.Version, [made]);
            binary = made;
        }
        return binary is null ? null : binary with { ByDirect3D = true };
    }

    private IReadOnlyList<ShaderBinary> MakeByGlslang(IReadOnlyList<StageJob> jobs)
    {
        string key = ShaderCache.Key(jobs);
        if (_cache.Read(key, _compiler.Version) is { } cached)
        {
            return cached;
        }
        if (_compiler.Version is not { } version)
        {
            throw new ShaderCompilerMissingException($"{jobs[0].Owner} of '{jobs[0].Source.Files[0]}'", _program, CacheDirectory);
        }
        List<(StageJob, byte[])> compiled = [];
        try
        {
            foreach (StageJob job in jobs)
            {
                Activity = $"compiling {job.Owner} ({_compilations + 1})";
                byte[] spirV = Compile(job);
                compiled.Add((SourceNames.MayHaveRawBuffers(job.Text) ? job with { Declarations = _compiler.Preprocess(job) } : job, spirV));
                Interlocked.Increment(ref _compilations);
            }
            IReadOnlyList<ShaderBinary> binaries = BinaryBuilder.Build(compiled);
            _cache.Write(key, version, binaries);
            return binaries;
        }
        finally
        {
            Activity = null;
        }
    }

    /// <summary>Where glslang refuses the text, it is preprocessed first, so that FXC's rules are written out behind macros too.</summary>
    private byte[] Compile(StageJob job)
    {
        try
        {
            return _compiler.Compile(job);
        }
        catch (ShaderCompileException e) when (e.Line > 0 && job.Plain is { } plain)
        {
            string text = FxcRules.WriteAll(_compiler.Preprocess(job with { Text = plain() }));
            (text, string name) = job.Stage == ShaderStage.Compute ? KernelNames.Separate(text, job.EntryPoint) : (text, job.EntryPoint);
            return _compiler.Compile(job with { Text = text, SourceEntryPoint = name });
        }
    }
}
