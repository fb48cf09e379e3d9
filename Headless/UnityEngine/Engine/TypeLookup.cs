using System;
using System.Reflection;

namespace Headless.Engine;

/// <summary>Finds a class by its full or short name in the loaded assemblies.</summary>
static class TypeLookup
{
    public static Type? Find(string name, Type baseType)
    {
        foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
        {
            if (assembly.IsDynamic) continue;
            if (assembly.GetType(name) is { } exact && baseType.IsAssignableFrom(exact)) return exact;
        }
        foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
        {
            if (assembly.IsDynamic) continue;
            foreach (Type type in Types(assembly))
                if (type.Name == name && baseType.IsAssignableFrom(type)) return type;
        }
        return null;
    }

    public static Type[] Types(Assembly assembly)
    {
        try
        {
            return assembly.GetTypes();
        }
        catch (ReflectionTypeLoadException exception)
        {
            return Array.FindAll(exception.Types, t => t is not null)!;
        }
    }
}
