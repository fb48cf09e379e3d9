using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Writes the contents of a section of a save.</summary>
    internal sealed class SaveWriter
    {
        private readonly MemoryStream stream = new MemoryStream();

        /// <summary>What was written.</summary>
        public ReadOnlySpan<byte> Bytes => new ReadOnlySpan<byte>(stream.GetBuffer(), 0, (int)stream.Length);

        /// <summary>Writes a value as it lies in memory, little endian.</summary>
        public void Write<T>(T value) where T : unmanaged => Write(MemoryMarshal.AsBytes(stackalloc T[] { value }));

        /// <summary>Writes a number of items and the items.</summary>
        public void WriteItems<T>(ReadOnlySpan<T> items) where T : unmanaged
        {
            Write(items.Length);
            Write(MemoryMarshal.AsBytes(items));
        }

        /// <summary>Writes the first of some items.</summary>
        public void WriteItems<T>(T[] items, int count) where T : unmanaged => WriteItems(new ReadOnlySpan<T>(items, 0, count));

        /// <summary>Writes a text.</summary>
        public void WriteText(string text) => WriteItems(new ReadOnlySpan<byte>(Encoding.UTF8.GetBytes(text)));

        /// <summary>Writes what a component is found again by, in this session or another.</summary>
        public void WriteKey(Component component) => WriteText(component == null ? "" : ScenePath.GetPath(component));

        /// <summary>Writes what a reader may pass over as a whole.</summary>
        public void WritePart(Action<SaveWriter> write)
        {
            var part = new SaveWriter();
            write(part);
            WriteItems(part.Bytes);
        }

        /// <summary>A value as it lies in memory.</summary>
        public static ReadOnlySpan<byte> BytesOf<T>(T value)
            where T : unmanaged => MemoryMarshal.AsBytes(new ReadOnlySpan<T>(new[] { value }));

        private void Write(ReadOnlySpan<byte> bytes) => stream.Write(bytes);
    }
}
