using System;

namespace UnityEngine.Rendering;

public struct VertexAttributeDescriptor : IEquatable<VertexAttributeDescriptor>
{
    public VertexAttributeDescriptor(
        VertexAttribute attribute = VertexAttribute.Position, VertexAttributeFormat format = VertexAttributeFormat.Float32, int dimension = 3, int stream = 0)
    {
        this.attribute = attribute;
        this.format = format;
        this.dimension = dimension;
        this.stream = stream;
    }

    public VertexAttribute attribute { get; set; }
    public VertexAttributeFormat format { get; set; }
    public int dimension { get; set; }
    public int stream { get; set; }

    public static bool operator ==(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => lhs.Equals(rhs);

    public static bool operator !=(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => !lhs.Equals(rhs);

    public bool Equals(VertexAttributeDescriptor other) =>
        attribute == other.attribute && format == other.format && dimension == other.dimension && stream == other.stream;

    public override bool Equals(object? other) => other is VertexAttributeDescriptor d && Equals(d);

    public override int GetHashCode() => HashCode.Combine(attribute, format, dimension, stream);

    public override string ToString() => $"(attr={attribute} fmt={format} dim={dimension} stream={stream})";
}
