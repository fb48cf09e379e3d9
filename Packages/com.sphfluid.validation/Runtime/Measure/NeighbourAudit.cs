using System;
using System.Collections.Generic;
using SphFluid.Laboratory;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// What a neighbour search finds against brute force over all pairs and nearest images. For whoever writes a search: give it
    /// the lists, or a kernel that fills NeighbourAudit.compute's two tables, and read what is missing. Waits for the GPU.
    /// </summary>
    public sealed class NeighbourAudit
    {
        // A pair at distance R is one or not by rounding; its weight is below 1e-9 of the nearest's.
        private const double Border = 1e-5;

        private static readonly int FoundId = Shader.PropertyToID("_Found");
        private static readonly int TwiceId = Shader.PropertyToID("_Twice");
        private static readonly int RowWordsId = Shader.PropertyToID("_RowWords");
        private static readonly int ParticleCountId = Shader.PropertyToID("_ParticleCount");

        private readonly List<NeighbourAuditError> missing = new List<NeighbourAuditError>();
        private readonly List<NeighbourAuditError> strangers = new List<NeighbourAuditError>();
        private readonly List<NeighbourAuditError> oneWay = new List<NeighbourAuditError>();
        private readonly List<NeighbourAuditError> doubled = new List<NeighbourAuditError>();

        private NeighbourAudit()
        {
        }

        /// <summary>Ordered pairs (i, j), i ≠ j, nearer than the radius, by brute force.</summary>
        public int Pairs { get; private set; }

        /// <summary>Pairs in reach that i does not find.</summary>
        public IReadOnlyList<NeighbourAuditError> Missing => missing;

        /// <summary>Pairs that i finds although they are out of reach.</summary>
        public IReadOnlyList<NeighbourAuditError> Strangers => strangers;

        /// <summary>Pairs that i finds and j does not: the force on i has no counterforce.</summary>
        public IReadOnlyList<NeighbourAuditError> OneWay => oneWay;

        /// <summary>Pairs that i finds more than once.</summary>
        public IReadOnlyList<NeighbourAuditError> Double => doubled;

        /// <summary>Cells whose range is not that of the particles that are in them now; −1 where no grid was looked at.</summary>
        public int WrongCells { get; private set; } = -1;

        /// <summary>Whether everything is as brute force has it.</summary>
        public bool IsRight => missing.Count == 0 && strangers.Count == 0 && oneWay.Count == 0 && doubled.Count == 0 && WrongCells <= 0;

        /// <summary>The failures that the errors are: a grid of other positions first, since it makes every other error.</summary>
        public IReadOnlyList<FluidFinding> Findings
        {
            get
            {
                var findings = new List<FluidFinding>();
                if (WrongCells > 0 || doubled.Count > 0)
                {
                    findings.Add(new FluidFinding(FluidFailure.StaleGrid, Math.Max(WrongCells, doubled.Count), 0.0,
                        $"{Math.Max(0, WrongCells)} cells do not hold the particles that are in them, and {doubled.Count} of {Pairs} " +
                        "pairs are met more than once.",
                        "Empty the ranges of all cells before each sort, and sort at the present positions."));
                }
                else if (oneWay.Count > 0)
                {
                    findings.Add(new FluidFinding(FluidFailure.AsymmetricPairs, oneWay.Count, 0.0,
                        $"{oneWay.Count} pairs are found by one particle only, and {missing.Count} of {Pairs} are missing.",
                        "Search 27 cells of the support radius, or the octant's 8 of twice that."));
                }
                return findings;
            }
        }

        /// <summary>Compares lists of neighbours, in any order.</summary>
        /// <param name="positions">Positions [m].</param>
        /// <param name="radius">Reach R [m].</param>
        /// <param name="period">Length of the box along periodic axes [m]; zero along the others.</param>
        /// <param name="found">For each particle the indices that its search finds; itself may be among them.</param>
        /// <exception cref="ArgumentException">There is not a list for each position, or it names a particle that is not there.</exception>
        public static NeighbourAudit Of(IReadOnlyList<Vector3> positions, float radius, Vector3 period,
            IReadOnlyList<IReadOnlyList<int>> found)
        {
            if (found.Count != positions.Count)
            {
                throw new ArgumentException($"{found.Count} lists are given for {positions.Count} particles; each needs one.",
                    nameof(found));
            }
            var times = new byte[positions.Count, positions.Count];
            for (int i = 0; i < positions.Count; i++)
            {
                foreach (int j in found[i])
                {
                    if (j < 0 || j >= positions.Count)
                    {
                        throw new ArgumentException($"The list of particle {i} names particle {j}; there are {positions.Count}.",
                            nameof(found));
                    }
                    times[i, j] = (byte)Math.Min(2, times[i, j] + 1);
                }
            }
            var audit = new NeighbourAudit();
            audit.Compare(positions, radius, period, times, null);
            return audit;
        }

        /// <summary>Looks at a solver's search as its last neighbour setup left it, by the search's own loop on the GPU.</summary>
        /// <param name="solver">The solver.</param>
        /// <param name="shader">NeighbourAudit.compute, or another with its kernel and tables.</param>
        /// <exception cref="FluidDeviceException">The device cannot run the kernel or hold its tables (2 bits a pair of
        /// particles).</exception>
        public static NeighbourAudit Of(FluidSolver solver, ComputeShader shader)
        {
            int count = solver.ParticleCount;
            int words = (count + 31) / 32;
            var found = new uint[(long)words * count];
            var twice = new uint[(long)words * count];
            GraphicsBuffer foundBuffer = null, twiceBuffer = null;
            try
            {
                foundBuffer = GpuLaboratory.CreateBuffer("Found", found.LongLength, sizeof(uint));
                twiceBuffer = GpuLaboratory.CreateBuffer("Twice", twice.LongLength, sizeof(uint));
                foundBuffer.SetData(found);
                twiceBuffer.SetData(twice);
                var kernel = new ComputeKernel(shader, "NeighbourAudit");
                using (var cmd = new CommandBuffer { name = "Neighbour Audit" })
                {
                    solver.BindNeighbours(cmd, kernel);
                    kernel.SetInt(cmd, ParticleCountId, count);
                    kernel.SetInt(cmd, RowWordsId, words);
                    kernel.SetBuffer(cmd, FoundId, foundBuffer);
                    kernel.SetBuffer(cmd, TwiceId, twiceBuffer);
                    kernel.DispatchThreads(cmd, count);
                    Graphics.ExecuteCommandBuffer(cmd);
                }
                foundBuffer.GetData(found);
                twiceBuffer.GetData(twice);
            }
            finally
            {
                GpuLaboratory.Dispose(ref foundBuffer);
                GpuLaboratory.Dispose(ref twiceBuffer);
            }
            return FromTables(solver, found, twice, words);
        }

        private static NeighbourAudit FromTables(FluidSolver solver, uint[] found, uint[] twice, int words)
        {
            var particles = new FluidParticle[solver.ParticleCount];
            solver.Particles.GetData(particles);
            particles = Array.FindAll(particles, p => !p.IsRemoved); // those stand behind all others
            Vector3[] positions = Array.ConvertAll(particles, p => p.Position);
            var times = new byte[positions.Length, positions.Length];
            for (int i = 0; i < positions.Length; i++)
            {
                for (int j = 0; j < positions.Length; j++)
                {
                    int bit = i * words + j / 32;
                    times[i, j] = (byte)((found[bit] >> (j % 32) & 1u) + (twice[bit] >> (j % 32) & 1u));
                }
            }
            var audit = new NeighbourAudit { WrongCells = CountWrongCells(solver, positions) };
            audit.Compare(positions, solver.Settings.SupportRadius, solver.Settings.PeriodLength, times,
                Array.ConvertAll(particles, p => p.Id));
            return audit;
        }

        private void Compare(IReadOnlyList<Vector3> positions, double radius, Vector3 period, byte[,] times, uint[] ids)
        {
            for (int i = 0; i < positions.Count; i++)
            {
                for (int j = 0; j < positions.Count; j++)
                {
                    if (i == j) continue;
                    double distance = Distance(positions[i], positions[j], period);
                    bool near = distance < radius;
                    Pairs += near ? 1 : 0;
                    if (Math.Abs(distance - radius) < Border * radius) continue;
                    var error = new NeighbourAuditError(ids == null ? (uint)i : ids[i], ids == null ? (uint)j : ids[j], distance);
                    if (near && times[i, j] == 0) missing.Add(error);
                    if (!near && times[i, j] > 0) strangers.Add(error);
                    if (times[i, j] > 0 && times[j, i] == 0) oneWay.Add(error);
                    if (times[i, j] > 1) doubled.Add(error);
                }
            }
        }

        private static double Distance(Vector3 a, Vector3 b, Vector3 period)
        {
            double x = Along(a.x, b.x, period.x), y = Along(a.y, b.y, period.y), z = Along(a.z, b.z, period.z);
            return Math.Sqrt(x * x + y * y + z * z);
        }

        // Box of 1 m: from 0.4 to −0.45 it is 0.15.
        private static double Along(double a, double b, double period)
        {
            double d = a - b;
            return period > 0.0 ? d - period * Math.Round(d / period) : d;
        }

        // Each range holds particles of its cell only, and each particle is in one range.
        private static int CountWrongCells(FluidSolver solver, Vector3[] positions)
        {
            FluidGrid grid = solver.Grid;
            if (solver.GridIndices.count != grid.CellCount)
            {
                throw new NotSupportedException($"The audit reads a range for each cell, but this domain has {grid.CellCount:N0} and " +
                    "stores only those with particles. Audit the same liquid in a smaller domain.");
            }
            var ranges = new uint[2 * grid.CellCount];
            solver.GridIndices.GetData(ranges);
            var covered = new bool[positions.Length];
            int wrong = 0, inRanges = 0;
            for (int cell = 0; cell < grid.CellCount; cell++)
            {
                bool right = ranges[2 * cell + 1] <= positions.Length;
                for (uint i = ranges[2 * cell]; right && i < ranges[2 * cell + 1]; i++)
                {
                    right = !covered[i] && IsIn(grid, cell, positions[i]);
                    covered[i] |= right;
                    inRanges += right ? 1 : 0;
                }
                wrong += right ? 0 : 1;
            }
            return wrong == 0 && inRanges < positions.Length ? 1 : wrong;
        }

        // A particle on a face belongs to either cell, by rounding; one on the box's face to the last.
        private static bool IsIn(in FluidGrid grid, int cell, Vector3 position)
        {
            Vector3 p = position - grid.Origin;
            int x = cell % grid.Counts.x, y = cell / grid.Counts.x % grid.Counts.y, z = cell / (grid.Counts.x * grid.Counts.y);
            return IsIn(x, p.x / grid.CellSize.x) && IsIn(y, p.y / grid.CellSize.y) && IsIn(z, p.z / grid.CellSize.z);
        }

        private static bool IsIn(int cell, float place) => place >= cell - Border && place <= cell + 1 + Border;
    }
}
