using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Reads the contents of a section of a save, in the order in which they were written.</summary>
    internal sealed class SaveReader
    {
        private readonly string section;
        private readonly byte[] bytes;
        private readonly List<string> missing;
        private int place;

        /// <param name="section">Name of the section.</param>
        /// <param name="bytes">Its contents.</param>
        /// <param name="missing">Receives what the scene does not have.</param>
        public SaveReader(string section, byte[] bytes, List<string> missing)
        {
            this.section = section;
            this.bytes = bytes;
            this.missing = missing;
        }

        /// <summary>Whether all has been read.</summary>
        public bool IsAtEnd => place == bytes.Length;

        /// <summary>Reads a value.</summary>
        /// <exception cref="InvalidDataException">The section ends before it.</exception>
        public T Read<T>() where T : unmanaged => MemoryMarshal.Read<T>(ReadBytes(SizeOf<T>()));

        /// <summary>Reads items and their number.</summary>
        /// <exception cref="InvalidDataException">The section ends before them.</exception>
        public T[] ReadItems<T>() where T : unmanaged
        {
            int count = Read<int>();
            if (count < 0) throw Ended();
            return MemoryMarshal.Cast<byte, T>(ReadBytes((long)count * SizeOf<T>())).ToArray();
        }

        /// <summary>Reads a text.</summary>
        /// <exception cref="InvalidDataException">The section ends before it.</exception>
        public string ReadText() => Encoding.UTF8.GetString(ReadItems<byte>());

        /// <summary>Reads the key of a component and finds what the scene has of it; what it has not is noted.</summary>
        /// <param name="present">What the scene has, by key.</param>
        /// <param name="found">That of the component.</param>
        /// <returns>False where the scene has none.</returns>
        /// <exception cref="InvalidDataException">The section ends before the key.</exception>
        public bool TryFind<T>(IReadOnlyDictionary<string, T> present, out T found)
        {
            string key = ReadText();
            if (present.TryGetValue(key, out found)) return true;
            if (key.Length > 0 && !missing.Contains(key)) missing.Add(key);
            return false;
        }

        /// <summary>Reads or passes over what <see cref="SaveWriter.WritePart"/> wrote.</summary>
        /// <exception cref="InvalidDataException">The section ends before it does.</exception>
        public SaveReader ReadPart() => new SaveReader(section, ReadItems<byte>(), missing);

        /// <summary>What a scene has, by the keys under which a save names it.</summary>
        public static Dictionary<string, T> ByKey<T>(IReadOnlyList<T> items, Func<T, Component> component)
        {
            var found = new Dictionary<string, T>();
            for (int i = 0; i < (items?.Count ?? 0); i++)
                if (component(items[i]) != null) found.TryAdd(ScenePath.GetPath(component(items[i])), items[i]);
            return found;
        }

        private ReadOnlySpan<byte> ReadBytes(long count)
        {
            if (count > bytes.Length - place) throw Ended();
            place += (int)count;
            return new ReadOnlySpan<byte>(bytes, place - (int)count, (int)count);
        }

        private static int SizeOf<T>() where T : unmanaged => MemoryMarshal.AsBytes(stackalloc T[1]).Length;

        private InvalidDataException Ended() => new InvalidDataException($"its section {section} is shorter than what it should hold");
    }
}
