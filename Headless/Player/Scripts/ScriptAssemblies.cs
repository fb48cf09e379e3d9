using System.Reflection;
using System.Runtime.Loader;

namespace Headless.Player.Scripts;

/// <summary>
/// The project's compiled scripts: one .dll an .asmdef, in one folder. What the player itself has (the engine, NUnit) is
/// never loaded twice, so the folder may hold copies of it.
/// </summary>
public sealed class ScriptAssemblies
{
    public const string DefaultFolder = "ScriptAssemblies";

    private readonly Loader loader;
    private readonly string folder;
    private readonly Dictionary<string, Assembly?> known = new(StringComparer.Ordinal);

    public ScriptAssemblies(string? folder)
    {
        this.folder = Path.GetFullPath(folder ?? Path.Combine(AppContext.BaseDirectory, DefaultFolder));
        loader = new Loader(this.folder);
    }

    /// <summary>By name without extension; null when the folder has no such file.</summary>
    public Assembly? Find(string name)
    {
        if (known.TryGetValue(name, out Assembly? assembly)) return assembly;
        // Names come from files of the project.
        if (name.Length == 0 || !name.All(c => char.IsLetterOrDigit(c) || c is '.' or '_' or '-' or ' ' or '+')) return null;
        string file = Path.Combine(folder, name + ".dll");
        return known[name] = Loader.OfThePlayer(new AssemblyName(name)) ?? (File.Exists(file) ? loader.LoadFromAssemblyPath(file) : null);
    }

    /// <summary>All assemblies of the folder, in ordinal order.</summary>
    public IReadOnlyList<Assembly> LoadAll() =>
        Directory.Exists(folder)
            ? [.. Directory.EnumerateFiles(folder, "*.dll").Order(StringComparer.Ordinal).Select(f => Find(Path.GetFileNameWithoutExtension(f))!)]
            : [];

    /// <summary>A static method without parameters by <c>Namespace.Class.Method</c>, as Unity's -executeMethod takes it.</summary>
    public MethodInfo FindMethod(string flag, string name)
    {
        int dot = name.LastIndexOf('.');
        if (dot <= 0) throw new UsageException($"{flag} must be Namespace.Class.Method, found '{name}'.");
        Type[] types = [.. LoadAll().Select(a => a.GetType(name[..dot])).OfType<Type>()];
        if (types.Length == 0) throw new UsageException($"{flag}: no class '{name[..dot]}' in the script assemblies of '{folder}'.");
        return types[0].GetMethod(name[(dot + 1)..], BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic, Type.EmptyTypes)
            ?? throw new UsageException($"{flag}: '{types[0].FullName}' has no static method '{name[(dot + 1)..]}' without parameters.");
    }

    private sealed class Loader(string folder) : AssemblyLoadContext("Scripts")
    {
        public static Assembly? OfThePlayer(AssemblyName name)
        {
            try
            {
                return Default.LoadFromAssemblyName(new AssemblyName(name.Name!));
            }
            catch (Exception e) when (e is FileNotFoundException or FileLoadException)
            {
                return null;
            }
        }

        protected override Assembly? Load(AssemblyName name)
        {
            if (OfThePlayer(name) is { } shared) return shared;
            string file = Path.Combine(folder, name.Name + ".dll");
            return File.Exists(file) ? LoadFromAssemblyPath(file) : null;
        }
    }
}
