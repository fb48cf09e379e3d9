using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Asks a liquid that moves only by steps of a test, from a domain that is turned and elsewhere.</summary>
    internal sealed class QueryRig : IDisposable
    {
        public static readonly Vector3 Place = new Vector3(3f, -2f, 1f);
        public static readonly Quaternion Turn = Quaternion.Euler(20f, 130f, -40f);

        private readonly FluidSolver solver;

        public QueryRig(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            Shaders = TestShaders.CreateSet();
            solver = new FluidSolver(settings, Shaders, particles);
        }

        public FluidShaderSet Shaders { get; }

        public FluidSolver Solver => solver;

        public static Vector3 World(Vector3 place) => Place + Turn * place;

        /// <summary>Records the answers behind <paramref name="first"/> others and reads them.</summary>
        public T[] Ask<T>(QueryWord[] words, int count, int first, Action<CommandBuffer, QueryTarget, GraphicsBuffer> record)
            where T : struct
        {
            using (GraphicsBuffer asked = GpuBuffers.Create("Queries", Math.Max(1, words.Length), QueryWord.Stride),
                answers = GpuBuffers.Create("Results", first + count, QueryReadback.Stride))
            {
                if (words.Length > 0) asked.SetData(words);
                GpuTest.Run(cmd =>
                {
                    solver.RecordNeighbourSetup(cmd);
                    record(cmd, new QueryTarget { Solver = solver, Position = Place, Rotation = Turn, Results = answers }, asked);
                });
                var found = new T[count];
                if (count > 0) answers.GetData(found, 0, first, count);
                return found;
            }
        }

        public void Dispose()
        {
            solver.Dispose();
            UnityEngine.Object.DestroyImmediate(Shaders);
        }
    }
}
