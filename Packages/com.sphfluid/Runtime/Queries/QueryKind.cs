using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// What is asked: all that questions, answers and shaders know of a kind. A new one is a line here, a pass and its methods of
    /// <see cref="FluidQueries"/>.
    /// </summary>
    internal sealed class QueryKind
    {
        public static readonly QueryKind Point =
            new QueryKind(0, "point", 1, 1024, AnswerPointsPass.ShaderName, s => new AnswerPointsPass(s));
        public static readonly QueryKind Ray =
            new QueryKind(1, "ray", AnswerRaysPass.Words, 16, AnswerRaysPass.ShaderName, s => new AnswerRaysPass(s));
        public static readonly QueryKind Box =
            new QueryKind(2, "box", AnswerBoxesPass.Words, 16, AnswerBoxesPass.ShaderName, s => new AnswerBoxesPass(s));
        public static readonly QueryKind Nearest =
            new QueryKind(3, "nearest particle", AnswerNearestPass.Words, 16, AnswerNearestPass.ShaderName, s => new AnswerNearestPass(s));
        public static readonly QueryKind Patch =
            new QueryKind(4, "rectangle", AnswerPatchesPass.Words, 16, AnswerPatchesPass.ShaderName, s => new AnswerPatchesPass(s));

        /// <summary>All kinds, in the order of their answers.</summary>
        public static readonly IReadOnlyList<QueryKind> All = new[] { Point, Ray, Box, Nearest, Patch };

        /// <summary>Their shaders.</summary>
        public static readonly ShaderGroup Shaders = new ShaderGroup("the queries", "Shaders/Queries",
            groupThreads: 256, buffers: 8, writableBuffers: 4, groupMemory: 3072, vertexBuffers: 0,
            ShadersOf(All));

        private readonly string shader;
        private readonly Func<FluidShaderSet, QueryPass> makePass;

        private QueryKind(int index, string name, int words, int places, string shader, Func<FluidShaderSet, QueryPass> makePass)
        {
            Index = index;
            Name = name;
            Words = words;
            Places = places;
            this.shader = shader;
            this.makePass = makePass;
        }

        /// <summary>Its place in <see cref="All"/>.</summary>
        public int Index { get; }

        /// <summary>What a question of it is called in messages.</summary>
        public string Name { get; }

        /// <summary>Words of a question.</summary>
        public int Words { get; }

        /// <summary>Places for questions to begin with.</summary>
        public int Places { get; }

        /// <summary>What answers it.</summary>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public QueryPass MakePass(FluidShaderSet shaders) => makePass(shaders);

        private static string[] ShadersOf(IReadOnlyList<QueryKind> kinds)
        {
            var names = new string[kinds.Count];
            for (int i = 0; i < names.Length; i++) names[i] = kinds[i].shader;
            return names;
        }
    }
}
