using Headless.Checks.Shaders;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Checks.Gpu;

/// <summary>The child process: compiles every variant for the family that its environment names, and prints a line for each result.</summary>
internal static class FamilyCompiler
{
    public const int NoDriver = 3;
    public const string Driver = "driver ", Begin = "begin ", Program = "program ", Loop = "loop ", Problem = "problem ", End = "end";

    private const string Listing = "Assembly";

    public static int Run(GpuFamily family, ProjectPackages packages, string shaderCache)
    {
        var folder = Directory.CreateTempSubdirectory("radv");
        try
        {
            using var device = GpuCompiler.Create(adapter: null, folder.FullName);
            if (!device.Adapter.Name.Contains(family.Name, StringComparison.OrdinalIgnoreCase))
                return Refuse($"the driver compiles for '{device.Adapter.Name}', not for {family.Name}");
            Console.WriteLine(Driver + device.Adapter.Driver);
            var includes = new IncludeResolver(packages.Project);
            var compiler = new ShaderCompiler(shaderCache, includes);
            foreach (var variant in ShaderVariants.Read(packages, includes, [])) Compile(device, compiler, family, variant);
            Console.WriteLine(End);
            return 0;
        }
        catch (GpuException e) { return Refuse(e.Message); }
        finally { folder.Delete(recursive: true); }
    }

    private static int Refuse(string reason)
    {
        Console.Error.WriteLine(reason);
        return NoDriver;
    }

    private static void Compile(GpuCompiler device, ShaderCompiler compiler, GpuFamily family, ShaderVariant variant)
    {
        Console.WriteLine(Begin + variant.Name);
        try
        {
            var key = $"{variant.File},{variant.Entry},{variant.Keywords}";
            var binaries = variant.Compile(compiler);
            var programs = variant.IsKernel ? device.Compile(binaries[0]) : device.Compile(DrawSetup.For(binaries, variant.Name));
            foreach (var program in programs)
            {
                Console.WriteLine(Program + CompiledTables.ProgramLine(family, key, program));
                if (!variant.IsKernel || HotLoop.All.FirstOrDefault(h => h.Kernel == variant.Entry) is not { } hot) continue;
                foreach (var (name, loop) in hot.Find(IsaListing.Parse(program.Listings[Listing])))
                    Console.WriteLine(Loop + CompiledTables.LoopLine(family, key, name, loop));
            }
        }
        catch (Exception e) when (e is GpuException or ShaderCompileException or KeyNotFoundException or FormatException)
        {
            Console.WriteLine($"{Problem}{variant.Name}: {e.Message.ReplaceLineEndings(" ")}");
        }
    }
}
