using System.Reflection;
using System.Runtime.Loader;

namespace Headless.Checks.Documents.Facts;

/// <summary>The compiled package, loaded beside the stand-in for Unity, so that it can be asked itself.</summary>
internal sealed class PackageProgram
{
    private const BindingFlags OfObjects = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance;
    private const BindingFlags OfTypes = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static;

    private readonly AssemblyLoadContext context = new("package");
    private readonly List<Assembly> assemblies;

    public PackageProgram(params string[] folders)
    {
        var places = folders.Select(Path.GetFullPath).ToList();
        context.Resolving += (_, name) => places.Select(f => Path.Combine(f, name.Name + ".dll")).FirstOrDefault(File.Exists) is { } file ? context.LoadFromAssemblyPath(file) : null;
        var product = places.SelectMany(f => new[] { "SphFluid.dll", "SphFluid.Thesis.dll" }.Select(n => Path.Combine(f, n))).Where(File.Exists).ToList();
        assemblies = product.Count > 0 ? [.. product.Select(context.LoadFromAssemblyPath)] : throw new UnknownFactException("the package is not built: ./run build makes it");
    }

    public Type Type(string name) => assemblies.Select(a => a.GetType("SphFluid." + name)).FirstOrDefault(t => t is not null) ?? throw new UnknownFactException($"the package has no type '{name}'");

    /// <summary>An object of each type of a kind, made with the argument where it takes one.</summary>
    public IEnumerable<object> Each(string baseType, object argument) => assemblies.SelectMany(a => a.GetTypes()).Where(t => !t.IsAbstract && t.IsSubclassOf(Type(baseType)))
        .Select(t => t.GetConstructors(OfObjects)[0]).Select(c => c.Invoke(c.GetParameters().Length == 0 ? [] : [argument]));

    public object Make(string type, params object?[] arguments) => Type(type).GetConstructors(OfObjects).First(c => c.GetParameters().Length == arguments.Length).Invoke(arguments);

    public object Constant(string type, string field) =>
        Type(type).GetField(field, OfTypes)?.GetValue(null) ?? throw new UnknownFactException($"{type} has no '{field}'");

    public object Static(string type, string property) => Type(type).GetProperty(property, OfTypes)!.GetValue(null)!;

    public object CallOf(string type, string method, params object?[] arguments) => Type(type).GetMethods(OfTypes).First(m => m.Name == method).Invoke(null, arguments)!;

    /// <summary>Opens the graphics device, by whose limits buffers are checked, also those that are only planned.</summary>
    public void OpenDevice()
    {
        var device = context.LoadFromAssemblyName(new AssemblyName("UnityEngine")).GetType("Headless.Engine.GraphicsDevice")!;
        if (device.GetProperty("IsReady", OfTypes)!.GetValue(null) is true) return;
        var open = device.GetMethods(OfTypes).First(m => m.Name == "Initialize" && m.GetParameters()[0].ParameterType.Name == "GpuDeviceOptions");
        open.Invoke(null, [Activator.CreateInstance(open.GetParameters()[0].ParameterType), null]);
    }

    public static object? Get(object target, string member) =>
        target.GetType().GetProperty(member, OfObjects)?.GetValue(target) ?? target.GetType().GetField(member, OfObjects)?.GetValue(target);

    public static void Set(object target, string field, object value) => target.GetType().GetField(field, OfObjects)!.SetValue(target, value);

    public static object? Call(object target, string method, params object?[] arguments) => target.GetType().GetMethods(OfObjects)
        .First(m => m.Name == method && m.GetParameters().Length == arguments.Length).Invoke(target, arguments);
}
