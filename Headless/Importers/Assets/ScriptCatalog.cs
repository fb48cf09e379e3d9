using System.Reflection;
using Headless.Engine;
using Headless.Importers.Project;

namespace Headless.Importers.Assets;

/// <summary>Script assets: GUID to class. The file's name is the class's name, its assembly that of the nearest .asmdef.</summary>
internal sealed class ScriptCatalog(ProjectIndex index, Func<string, Assembly?> assemblies, Action<string> report)
{
    private readonly Dictionary<string, Type?> types = [];
    private AssemblyDefinitions? definitions;

    /// <summary>Null when the script, its assembly or its class is missing, which is reported.</summary>
    public Type? Find(string guid, Type baseType, string where)
    {
        if (types.TryGetValue(guid, out Type? known)) return known;
        return types[guid] = Search(guid, baseType, where);
    }

    private Type? Search(string guid, Type baseType, string where)
    {
        if (UnityScripts.TryFind(guid, assemblies, out Type? type, out string? missing))
        {
            if (missing is not null) report($"{where}: Unity's class {missing} has no stand-in; its objects are left out.");
            return type is not null && baseType.IsAssignableFrom(type) && !type.IsAbstract ? type : null;
        }
        if (index.PathOf(guid) is not { } path)
        {
            report($"{where}: the script with GUID {guid} is missing from the project; the component is left out. Install the package that has it, or restore the script with its .meta.");
            return null;
        }
        definitions ??= new AssemblyDefinitions(index);
        string assemblyName = definitions.AssemblyOf(path), className = Path.GetFileNameWithoutExtension(path);
        if (assemblies(assemblyName) is not { } assembly)
        {
            report($"{where}: '{path}' belongs to the assembly '{assemblyName}', which is not among the script assemblies; the component is left out. Build the assembly and name its folder with --assemblies.");
            return null;
        }
        Type[] found = [.. TypeLookup.Types(assembly).Where(t => t.Name == className && baseType.IsAssignableFrom(t) && !t.IsAbstract)];
        if (found.Length == 1)
        {
            int order = MetaFile.Read(index.FileOf(path) + ".meta").Settings.Int("executionOrder");
            if (order != 0) ScriptType.SetProjectOrder(found[0], order);
            return found[0];
        }
        report(found.Length == 0
            ? $"{where}: '{path}' has no {baseType.Name} class named '{className}' in '{assemblyName}'; file and class must have the same name. The component is left out."
            : $"{where}: '{assemblyName}' has several classes named '{className}' ({string.Join(", ", found.Select(t => t.FullName))}); rename all but one. The component is left out.");
        return null;
    }
}
