using System.Collections.Generic;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Every living object by instance id. Ids grow with creation, so that sorting by id is creation order.</summary>
static class ObjectRegistry
{
    static readonly object s_Lock = new();
    static readonly Dictionary<int, Object> s_Objects = new();
    static int s_Next = 1000;

    public static int Count { get { lock (s_Lock) return s_Objects.Count; } }

    public static int Register(Object instance)
    {
        lock (s_Lock)
        {
            s_Next += 2;
            s_Objects.Add(s_Next, instance);
            return s_Next;
        }
    }

    public static void Unregister(int id)
    {
        lock (s_Lock) s_Objects.Remove(id);
    }

    public static Object? Find(int id)
    {
        lock (s_Lock) return s_Objects.GetValueOrDefault(id);
    }

    public static Object[] Snapshot()
    {
        lock (s_Lock)
        {
            var all = new Object[s_Objects.Count];
            s_Objects.Values.CopyTo(all, 0);
            return all;
        }
    }
}
