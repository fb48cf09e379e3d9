using System;
using System.Collections.Generic;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>Takes objects that Unity has destroyed out of what is known of them.</summary>
    internal static class GoneKeys
    {
        /// <summary>Forgets them; no garbage while there are none.</summary>
        /// <param name="known">What is known by object.</param>
        /// <param name="release">Gets what was known of each.</param>
        public static void Forget<TKey, TValue>(Dictionary<TKey, TValue> known, Action<TValue> release = null) where TKey : Object
        {
            List<TKey> gone = null;
            foreach (TKey key in known.Keys)
                if (key == null) (gone ??= new List<TKey>()).Add(key);
            if (gone == null) return;
            foreach (TKey key in gone)
            {
                release?.Invoke(known[key]);
                known.Remove(key);
            }
        }
    }
}
