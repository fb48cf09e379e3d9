namespace SphFluid
{
    /// <summary>How the numbers of a PLY file are written.</summary>
    internal enum PlyEncoding
    {
        Ascii,
        LittleEndian,
        BigEndian,
    }

    /// <summary>Types of numbers in a PLY file.</summary>
    internal enum PlyType
    {
        Int8,
        UInt8,
        Int16,
        UInt16,
        Int32,
        UInt32,
        Float32,
        Float64,
    }

    /// <summary>A property of an element.</summary>
    internal struct PlyProperty
    {
        /// <summary>Place in <see cref="PlyHeader.FieldNames"/>; −1: nothing that a particle has.</summary>
        public int Field;

        public PlyType Type;
        public bool IsList;

        /// <summary>Type of a list's length.</summary>
        public PlyType CountType;
    }

    /// <summary>An element: rows of properties.</summary>
    internal struct PlyElement
    {
        /// <summary>Number of rows.</summary>
        public long Count;

        /// <summary>Place of its first property in <see cref="PlyHeader.Properties"/>.</summary>
        public int First;

        /// <summary>Number of its properties.</summary>
        public int Properties;
    }
}
