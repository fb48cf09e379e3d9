using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine.TestTools;

namespace Headless.Engine;

/// <summary>Set-up and tear-down methods of a fixture class: base class first for set-up, last for tear-down.</summary>
sealed class FixtureMethods
{
    static readonly Dictionary<Type, FixtureMethods> s_Cache = new();

    FixtureMethods(Type type)
    {
        SetUp = Find<SetUpAttribute>(type, true);
        TearDown = Find<TearDownAttribute>(type, false);
        UnitySetUp = Find<UnitySetUpAttribute>(type, true);
        UnityTearDown = Find<UnityTearDownAttribute>(type, false);
        OneTimeSetUp = Find<OneTimeSetUpAttribute>(type, true);
        OneTimeTearDown = Find<OneTimeTearDownAttribute>(type, false);
    }

    public IReadOnlyList<MethodInfo> SetUp { get; }
    public IReadOnlyList<MethodInfo> TearDown { get; }
    public IReadOnlyList<MethodInfo> UnitySetUp { get; }
    public IReadOnlyList<MethodInfo> UnityTearDown { get; }
    public IReadOnlyList<MethodInfo> OneTimeSetUp { get; }
    public IReadOnlyList<MethodInfo> OneTimeTearDown { get; }

    public static FixtureMethods Of(Type type)
    {
        if (!s_Cache.TryGetValue(type, out FixtureMethods? methods)) s_Cache.Add(type, methods = new FixtureMethods(type));
        return methods;
    }

    static MethodInfo[] Find<T>(Type type, bool baseFirst) where T : Attribute
    {
        const BindingFlags flags = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.FlattenHierarchy;
        IEnumerable<MethodInfo> found = type.GetMethods(flags).Where(m => m.IsDefined(typeof(T), true));
        return (baseFirst ? found.OrderBy(Depth) : found.OrderByDescending(Depth)).ToArray();
    }

    static int Depth(MethodInfo method)
    {
        int depth = 0;
        for (Type? t = method.DeclaringType; t is not null; t = t.BaseType) depth++;
        return depth;
    }

    public static object? Call(MethodInfo method, object? fixture) =>
        method.Invoke(method.IsStatic ? null : fixture, BindingFlags.DoNotWrapExceptions, null, null, null);
}
