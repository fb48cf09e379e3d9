using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering;

/// <summary>What passes of one frame share, by type.</summary>
public class ContextContainer : IDisposable
{
    private readonly Dictionary<Type, ContextItem> items = [];

    public T Get<T>()
        where T : ContextItem, new() =>
        items.TryGetValue(typeof(T), out ContextItem? item) ? (T)item : throw new InvalidOperationException($"Type {typeof(T).FullName} has not been created yet.");

    public T Create<T>()
        where T : ContextItem, new()
    {
        if (items.ContainsKey(typeof(T)))
        {
            throw new InvalidOperationException($"Type {typeof(T).FullName} has already been created.");
        }

        var item = new T();
        item.Reset();
        items[typeof(T)] = item;
        return item;
    }

    public T GetOrCreate<T>()
        where T : ContextItem, new() => Contains<T>() ? Get<T>() : Create<T>();

    public bool Contains<T>()
        where T : ContextItem, new() => items.ContainsKey(typeof(T));

    public void Dispose()
    {
        foreach (ContextItem item in items.Values)
        {
            item.Reset();
        }

        items.Clear();
        GC.SuppressFinalize(this);
    }
}
