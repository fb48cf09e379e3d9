using System.Diagnostics;
using System.Text.Json;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>./run export, then Debian's PySPH on what it wrote, then the sequence for playback, as a user does it.</summary>
[Category("Gpu")]
public sealed class PysphExportTests
{
    private const int ParticleBytes = 28;
    private const string Debian = "/usr/bin/python3"; // the interpreter that Debian's packages are for
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(10);

    private string folder = "", damBreak = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("exported-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    [OneTimeTearDown]
    public void Clean()
    {
        if (damBreak.Length > 0) Directory.Delete(damBreak, recursive: true);
    }

    [Test]
    public void TheDamBreakIsWritten()
    {
        TakeDamBreak();
        JsonElement manifest = Json("manifest.json");
        Assert.That(manifest.GetProperty("liquidParticles").GetInt64(), Is.InRange(200, 400));
        foreach (JsonElement file in manifest.GetProperty("files").EnumerateArray())
        {
            byte[] contents = File.ReadAllBytes(PathOf(file.GetProperty("name").GetString()!));
            Assert.That(contents, Has.Length.EqualTo(file.GetProperty("bytes").GetInt64()));
            Assert.That(Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(contents)), Is.EqualTo(file.GetProperty("sha256").GetString()));
        }
    }

    [Test]
    public void AMovingPaddleIsABody()
    {
        PlayerProcess run = Export("--scene", "Packages/com.sphfluid/Samples~/WaveTank/WaveTank.unity", "--particles", "500", "--seconds", "0.75", "--frame-rate", "20");
        Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
        JsonElement body = Json("manifest.json").GetProperty("bodies").EnumerateArray().First();
        Assert.That(body.GetProperty("poses").GetInt32(), Is.InRange(15, 17));
        Assert.That(body.GetProperty("particles").GetInt64(), Is.Positive);
    }

    [Test]
    public void StrictWritesNothingOfASceneThatIsNotExportedWhole()
    {
        PlayerProcess run = Export("--scene", "Packages/com.sphfluid/Samples~/Fountain/Fountain.unity", "--particles", "500", "--seconds", "0.05", "--strict");
        Assert.That(run.ExitCode, Is.EqualTo(1));
        Assert.That(run.Output + run.Errors, Does.Contain("is not exported").And.Contain("nothing is written, because --strict is given"));
        Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
    }

    [Test]
    public void AMissingSceneIsExitCode2()
    {
        PlayerProcess run = Export("--scene", "Assets/NoSuchScene.unity");
        Assert.That(run.ExitCode, Is.EqualTo(2), run.Output + run.Errors);
        Assert.That(run.Output + run.Errors, Does.Contain("NoSuchScene"));
    }

    [Test]
    public void PysphRunsTheDamBreakOnTwoProcesses()
    {
        const int ranks = 2; // the paddle is moved on one
        RequirePysph();
        TakeDamBreak();
        Run(PathOf("run.sh"), ranks, "--max-steps", "40"); // the first are short

        JsonElement sequence = Json("sequence/sequence.json");
        Assert.That(sequence.GetProperty("format").GetString(), Is.EqualTo("sphfluid-sequence"));
        Assert.That(sequence.GetProperty("source").GetString(), Does.StartWith("PySPH 1.0b1, scheme WCSPH, " + ranks + " rank"));
        JsonElement[] frames = [.. sequence.GetProperty("frames").EnumerateArray()];
        Assert.That(frames, Has.Length.GreaterThanOrEqualTo(3), "the start, a fortieth of a second, and where the steps end");
        long particles = Json("manifest.json").GetProperty("liquidParticles").GetInt64();
        foreach (JsonElement frame in frames)
        {
            byte[] contents = File.ReadAllBytes(PathOf("sequence/" + frame.GetProperty("file").GetString()));
            Assert.That(frame.GetProperty("particles").GetInt64(), Is.EqualTo(particles));
            Assert.That(contents, Has.Length.EqualTo(frame.GetProperty("bytes").GetInt64()));
            Assert.That($"{Crc32(contents):x8}", Is.EqualTo(frame.GetProperty("crc32").GetString()));
            uint[] ids = [.. Enumerable.Range(0, (int)particles).Select(i => BitConverter.ToUInt32(contents, contents.Length - (int)(particles - i) * ParticleBytes + 24))];
            Assert.That(ids, Is.EqualTo(Enumerable.Range(0, (int)particles).Select(i => (uint)i)));
        }
        float[] heights = [.. frames.Select(f => MeanHeight(PathOf("sequence/" + f.GetProperty("file").GetString()), (int)particles))];
        Assert.That(heights[^1], Is.LessThan(heights[0]), "it falls");
    }

    [Test]
    public void PysphMovesThePaddleAndReadsTheInstruments()
    {
        RequirePysph();
        PlayerProcess run = Export("--scene", "Packages/com.sphfluid/Samples~/WaveTank/WaveTank.unity", "--particles", "300", "--seconds", "0.2", "--frame-rate", "20");
        Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
        Run(PathOf("run.sh"), 1, "--max-steps", "3");
        Assert.That(Json("sequence/sequence.json").GetProperty("frames").GetArrayLength(), Is.EqualTo(2));
        string[] rows = File.ReadAllLines(PathOf("readings.csv"));
        Assert.That(rows[0], Is.EqualTo("time_s,Wall Probe.p,Wave Gauge.height_m"));
        Assert.That(double.Parse(rows[1].Split(',')[2], System.Globalization.CultureInfo.InvariantCulture), Is.InRange(0.1, 0.4), "the water is 0.24 m deep, and a spacing is a quarter of that");
    }

    // What a file does not have is left out, and playback is told: zeros would stop every particle at every frame.
    [TestCase(true, true)]
    [TestCase(false, false)]
    public void VtkFilesBecomeASequence(bool velocities, bool ids)
    {
        Require("meshio", "python3-meshio");
        TakeDamBreak();
        for (int frame = 0; frame < 2; frame++) File.WriteAllText(PathOf($"other-{frame}.vtu"), Vtu(frame, velocities, ids));

        string said = RunScript(0, PathOf("to_sequence.py"), "--vtk", PathOf("other-*.vtu"), "--frame-rate", "20", PathOf("sequence"));

        Assert.That(said.Contains("has no velocities"), Is.EqualTo(!velocities), said);
        Assert.That(said.Contains("has no numbers of particles"), Is.EqualTo(!ids), said);
        JsonElement[] frames = [.. Json("sequence/sequence.json").GetProperty("frames").EnumerateArray()];
        Assert.That(frames.Select(f => f.GetProperty("time").GetDouble()), Is.EqualTo(new[] { 0.0, 0.05 }));
        byte[] contents = File.ReadAllBytes(PathOf("sequence/frame-00001.ply"));
        string head = System.Text.Encoding.ASCII.GetString(contents, 0, contents.AsSpan().IndexOf("end_header\n"u8));
        Assert.That(head.Contains("property float vy"), Is.EqualTo(velocities));
        Assert.That(head.Contains("property uint id"), Is.EqualTo(ids));
        int row = 12 + (velocities ? 12 : 0) + (ids ? 4 : 0);
        float[] heights = [.. Enumerable.Range(0, 3).Select(i => BitConverter.ToSingle(contents, contents.Length - (3 - i) * row + 4))];
        Assert.That(heights, Is.EqualTo(ids ? new[] { 0.12f, 0.13f, 0.11f } : [0.11f, 0.12f, 0.13f]), "by their numbers");
    }

    [Test]
    public void VtkFilesWithTwoParticlesOfANumberAreRefused()
    {
        Require("meshio", "python3-meshio");
        TakeDamBreak();
        File.WriteAllText(PathOf("other-0.vtu"), Vtu(0, true, true).Replace("2 0 1", "2 0 0"));

        string said = RunScript(1, PathOf("to_sequence.py"), "--vtk", PathOf("other-*.vtu"), PathOf("sequence"));

        Assert.That(said, Does.Contain("3 points, but 2 different numbers of particles"));
        Assert.That(File.Exists(PathOf("sequence/sequence.json")), Is.False);
    }

    // Three points as other programs write them, in text.
    private static string Vtu(int frame, bool velocities, bool ids)
    {
        static string Array(string type, string name, int components, string numbers) =>
            $"<DataArray type=\"{type}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">{numbers}</DataArray>";
        string data = (velocities ? Array("Float32", "Velocity", 3, "0 1 0  0 2 0  0 3 0") : "") + (ids ? Array("Int32", "id", 1, "2 0 1") : "");
        return $"""
            <?xml version="1.0"?><VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid><Piece NumberOfPoints="3" NumberOfCells="3">
            <Points>{Array("Float32", "Points", 3, $"0 0.{frame}1 0  0 0.{frame}2 0  0 0.{frame}3 0")}</Points>
            <Cells>{Array("Int32", "connectivity", 1, "0 1 2")}{Array("Int32", "offsets", 1, "1 2 3")}{Array("UInt8", "types", 1, "1 1 1")}</Cells>
            <PointData>{data}</PointData></Piece></UnstructuredGrid></VTKFile>
            """;
    }

    private static float MeanHeight(string file, int particles)
    {
        byte[] contents = File.ReadAllBytes(file);
        return Enumerable.Range(0, particles).Average(i => BitConverter.ToSingle(contents, contents.Length - (particles - i) * ParticleBytes + 4));
    }

    private static uint Crc32(byte[] contents)
    {
        uint crc = ~0u;
        foreach (byte value in contents)
        {
            crc ^= value;
            for (int bit = 0; bit < 8; bit++) crc = (crc & 1) != 0 ? 0xEDB88320u ^ crc >> 1 : crc >> 1;
        }
        return ~crc;
    }

    private static void RequirePysph() => Require("pysph, mpi4py, pyzoltan", "python3-pysph python3-mpi4py python3-pyzoltan openmpi-bin");

    private static void Require(string modules, string packages)
    {
        if (!File.Exists(Debian) || Run(new ProcessStartInfo(Debian, ["-c", "import " + modules])).ExitCode != 0)
            Assert.Ignore($"Python has no {modules}: apt-get install {packages} (setup.sh does it where Debian serves it)");
    }

    private static void Run(string script, int ranks, params string[] flags)
    {
        var start = new ProcessStartInfo("bash", [script, .. flags]);
        start.Environment["RANKS"] = ranks.ToString(System.Globalization.CultureInfo.InvariantCulture);
        start.Environment["PYTHON"] = Debian;
        start.Environment["OMPI_MCA_mpi_yield_when_idle"] = "1"; // other tests run beside these
        (int code, string said) = Run(start);
        Assert.That(code, Is.Zero, said);
    }

    private static string RunScript(int expectedExitCode, params string[] words)
    {
        (int code, string said) = Run(new ProcessStartInfo(Debian, words));
        Assert.That(code, Is.EqualTo(expectedExitCode), said);
        return said;
    }

    private static (int ExitCode, string Said) Run(ProcessStartInfo start)
    {
        (start.RedirectStandardError, start.RedirectStandardOutput) = (true, true);
        using var process = Process.Start(start)!;
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        Assert.That(process.WaitForExit(Patience), Is.True, "it takes too long");
        return (process.ExitCode, output + errors.Result);
    }

    private string PathOf(string name) => Path.Combine(folder, name);

    private JsonElement Json(string name) => JsonDocument.Parse(File.ReadAllText(PathOf(name))).RootElement;

    // Exported once, and then copied: nothing of it hangs on the test.
    private void TakeDamBreak()
    {
        if (damBreak.Length == 0)
        {
            PlayerProcess run = Export("--particles", "300", "--seconds", "0.1", "--frame-rate", "40");
            Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
            damBreak = folder;
            folder = Directory.CreateTempSubdirectory("exported-").FullName;
        }
        foreach (string file in Directory.EnumerateFiles(damBreak, "*", SearchOption.AllDirectories))
        {
            string copy = PathOf(Path.GetRelativePath(damBreak, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
    }

    private PlayerProcess Export(params string[] flags)
    {
        string root = FuzzProject.Repository;
        return PlayerProcess.Run(
        [
            "exec", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--executeMethod", "SphFluid.Validation.CommandLine.Export", "--", .. flags, "--out", folder,
        ]);
    }
}
