using System.Collections.Generic;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Collects vertices and triangles of a primitive.</summary>
internal sealed class ShapeBuilder
{
    private readonly List<Vector3> vertices = [];
    private readonly List<Vector3> normals = [];
    private readonly List<Vector2> uvs = [];
    private readonly List<int> triangles = [];

    public int Add(Vector3 position, Vector3 normal, Vector2 uv)
    {
        vertices.Add(position);
        normals.Add(normal);
        uvs.Add(uv);
        return vertices.Count - 1;
    }

    public void Triangle(int a, int b, int c) => triangles.AddRange([a, b, c]);

    /// <summary>Two triangles; corners run clockwise as seen from the front.</summary>
    public void Quad(int a, int b, int c, int d)
    {
        Triangle(a, b, c);
        Triangle(a, c, d);
    }

    /// <summary>A surface of rows and columns; its front lies where rows x columns points.</summary>
    public void Grid(int rows, int columns, Func<int, int, (Vector3 Position, Vector3 Normal, Vector2 UV)> vertex)
    {
        int first = vertices.Count;
        for (int r = 0; r <= rows; r++)
        {
            for (int c = 0; c <= columns; c++)
            {
                (Vector3 position, Vector3 normal, Vector2 uv) = vertex(r, c);
                Add(position, normal, uv);
            }
        }

        int width = columns + 1;
        for (int r = 0; r < rows; r++)
        {
            for (int c = 0; c < columns; c++)
            {
                int i = first + (r * width) + c;
                Quad(i, i + width, i + width + 1, i + 1);
            }
        }
    }

    public Mesh Build()
    {
        var mesh = new Mesh();
        mesh.SetVertices(vertices);
        mesh.SetNormals(normals);
        mesh.SetUVs(0, uvs);
        mesh.SetTriangles(triangles, 0);
        mesh.RecalculateTangents();
        return mesh;
    }
}
