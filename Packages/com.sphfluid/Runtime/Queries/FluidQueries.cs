using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>
    /// Questions to a liquid that the GPU answers without a stall: all of a frame in one dispatch and one read-back, whose answers come
    /// some frames later. Requests stay until they are removed and are answered again each frame; they outlive a new start, their answers
    /// do not.
    /// </summary>
    public sealed class FluidQueries : IDisposable
    {
        private readonly Object owner;
        private readonly Action<FluidMessage> report;
        private readonly QuerySet asked = new QuerySet();
        private readonly QueryAnswers answers;
        private bool disposed;
        private double now;

        internal FluidQueries(Object owner, Action<FluidMessage> report)
        {
            this.owner = owner;
            this.report = report;
            answers = new QueryAnswers(asked, () => Received?.Invoke(this));
        }

        /// <summary>Raised on the main thread when answers have arrived.</summary>
        public event Action<FluidQueries> Received;

        /// <summary>Number of requests.</summary>
        public int Count => asked.Count;

        /// <summary>GPU memory [bytes].</summary>
        public long GpuBytes => asked.GpuBytes + answers.GpuBytes;

        /// <summary>Frames since the state that the present answers are of; -1 while there are none.</summary>
        public int AgeInFrames => Current == null ? -1 : Time.frameCount - Current.Frame;

        /// <summary>Simulated time since the state that the present answers are of [s]; -1 while there are none.</summary>
        public double AgeInSeconds => Current == null ? -1.0 : now - Current.Time;

        /// <summary>Simulated time of the state that the present answers are of [s]; -1 while there are none.</summary>
        public double AnsweredTime => Current == null ? -1.0 : Current.Time;

        /// <summary>Number of the request that the present answers are of; 0 while there are none.</summary>
        internal long Answer => Current?.Number ?? 0;

        /// <summary>
        /// All present answers of points, by <see cref="FluidQuery.Index"/>, for jobs that end within the frame; empty while there are
        /// none. Only <see cref="TryGet"/> knows whose they are.
        /// </summary>
        public NativeArray<FluidPointResult>.ReadOnly Points => Current == null ? default
            : Current.GetAnswers<FluidPointResult>(QueryKind.Point).AsReadOnly();

        private QueryReadback Current => answers.Current;

        /// <summary>Asks what the liquid is at a point.</summary>
        /// <param name="world">World position [m].</param>
        /// <returns>The request.</returns>
        /// <exception cref="ArgumentException">The position is not finite.</exception>
        public FluidQuery AddPoint(Vector3 world)
        {
            Require.Finite(world, nameof(world));
            FluidQuery query = asked.Add(QueryKind.Point);
            asked[QueryKind.Point].Set(query, world);
            return query;
        }

        /// <summary>Asks where a ray meets the liquid's surface; a ray downwards asks for the height of the water.</summary>
        /// <param name="origin">World position at which it begins [m].</param>
        /// <param name="direction">World direction, of any length but 0.</param>
        /// <param name="length">How far it goes [m]; beyond the domain there is nothing to find.</param>
        /// <returns>The request.</returns>
        /// <exception cref="ArgumentException">A number is not finite, the direction is 0, or the length is not positive.</exception>
        public FluidQuery AddRay(Vector3 origin, Vector3 direction, float length)
        {
            QueryWord second = QueryRules.Ray(origin, direction, length);
            FluidQuery query = asked.Add(QueryKind.Ray);
            Set(query, origin, second);
            return query;
        }

        /// <summary>Asks how much liquid a box holds.</summary>
        /// <param name="centre">World position of its centre [m].</param>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <returns>The request.</returns>
        /// <exception cref="ArgumentException">A number is not finite, or an edge length is not positive.</exception>
        public FluidQuery AddBox(Vector3 centre, Vector3 size, Quaternion rotation)
        {
            QueryRules.Check(centre, size, rotation);
            FluidQuery query = asked.Add(QueryKind.Box);
            SetBox(query, centre, size, rotation);
            return query;
        }

        /// <summary>Asks for the particle of the liquid that is nearest to a place. Each request costs a look at every particle.</summary>
        /// <param name="world">World position [m].</param>
        /// <param name="distance">How far to look [m].</param>
        /// <returns>The request.</returns>
        /// <exception cref="ArgumentException">The position is not finite, or the distance is not positive.</exception>
        public FluidQuery AddNearest(Vector3 world, float distance)
        {
            QueryWord second = QueryRules.Reach(world, distance);
            FluidQuery query = asked.Add(QueryKind.Nearest);
            Set(query, world, second);
            return query;
        }

        /// <summary>Asks how much liquid goes through a rectangle from now on.</summary>
        /// <param name="centre">World position of its centre [m].</param>
        /// <param name="size">Edge lengths along its x and y axes [m].</param>
        /// <param name="rotation">World rotation; what goes along its forward axis counts as forward.</param>
        /// <returns>The request.</returns>
        /// <exception cref="ArgumentException">A number is not finite, or an edge length is not positive.</exception>
        public FluidQuery AddPatch(Vector3 centre, Vector2 size, Quaternion rotation)
        {
            QueryRules.Check(centre, size, rotation);
            FluidQuery query = asked.Add(QueryKind.Patch);
            SetEdges(query, centre, size, rotation);
            return query;
        }

        /// <summary>Asks at another place from now on. Until the answer of that place arrives, that of the last one stays.</summary>
        /// <param name="query">The request of a point.</param>
        /// <param name="world">World position [m].</param>
        /// <exception cref="ArgumentException">The position is not finite, or the request was removed or is of another kind.</exception>
        public void Move(FluidQuery query, Vector3 world)
        {
            Require.Finite(world, nameof(world));
            asked.Require(query, QueryKind.Point);
            asked[QueryKind.Point].Set(query, world);
        }

        /// <summary>Asks along another ray from now on. Until the answer of that one arrives, that of the last one stays.</summary>
        /// <param name="query">The request of a ray.</param>
        /// <param name="origin">World position at which it begins [m].</param>
        /// <param name="direction">World direction, of any length but 0.</param>
        /// <param name="length">How far it goes [m].</param>
        /// <exception cref="ArgumentException">As <see cref="AddRay"/>, or the request was removed or is of another kind.</exception>
        public void Move(FluidQuery query, Vector3 origin, Vector3 direction, float length)
        {
            QueryWord second = QueryRules.Ray(origin, direction, length);
            asked.Require(query, QueryKind.Ray);
            Set(query, origin, second);
        }

        /// <summary>Asks about another box from now on. Until the answer of that one arrives, that of the last one stays.</summary>
        /// <param name="query">The request of a box.</param>
        /// <param name="centre">World position of its centre [m].</param>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <exception cref="ArgumentException">As <see cref="AddBox"/>, or the request was removed or is of another kind.</exception>
        public void Move(FluidQuery query, Vector3 centre, Vector3 size, Quaternion rotation)
        {
            QueryRules.Check(centre, size, rotation);
            asked.Require(query, QueryKind.Box);
            SetBox(query, centre, size, rotation);
        }

        /// <summary>
        /// Asks for the particle nearest to another place from now on. Until the answer of that one arrives, that of the last one stays.
        /// </summary>
        /// <param name="query">The request of a nearest particle.</param>
        /// <param name="world">World position [m].</param>
        /// <param name="distance">How far to look [m].</param>
        /// <exception cref="ArgumentException">As <see cref="AddNearest"/>, or the request was removed or is of another kind.</exception>
        public void Move(FluidQuery query, Vector3 world, float distance)
        {
            QueryWord second = QueryRules.Reach(world, distance);
            asked.Require(query, QueryKind.Nearest);
            Set(query, world, second);
        }

        /// <summary>
        /// Moves a rectangle, in a straight line from its place at the last look. What it passes over meanwhile went through it.
        /// </summary>
        /// <param name="query">The request of a rectangle.</param>
        /// <param name="centre">World position of its centre [m].</param>
        /// <param name="size">Edge lengths along its x and y axes [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <exception cref="ArgumentException">As <see cref="AddPatch"/>, or the request was removed or is of another kind.</exception>
        public void Move(FluidQuery query, Vector3 centre, Vector2 size, Quaternion rotation)
        {
            QueryRules.Check(centre, size, rotation);
            asked.Require(query, QueryKind.Patch);
            SetEdges(query, centre, size, rotation);
        }

        /// <summary>Ends a request; one that is none or was removed before is left as it is.</summary>
        /// <param name="query">The request.</param>
        public void Remove(FluidQuery query) => asked.Remove(query);

        /// <summary>The latest answer to a request of a point.</summary>
        /// <param name="query">The request.</param>
        /// <param name="result">The answer, a copy.</param>
        /// <returns>False until the first answer, for removed requests and those of other kinds, and while the liquid does not
        /// run.</returns>
        public bool TryGet(FluidQuery query, out FluidPointResult result) => TryFind(QueryKind.Point, query, out result) &&
            result.Generation == query.Generation;

        /// <summary>The latest answer to a request of a ray.</summary>
        /// <param name="query">The request.</param>
        /// <param name="result">The answer, a copy.</param>
        /// <returns>False until the first answer, for removed requests and those of other kinds, and while the liquid does not
        /// run.</returns>
        public bool TryGetRay(FluidQuery query, out FluidRayResult result) => TryFind(QueryKind.Ray, query, out result) &&
            result.Generation == query.Generation;

        /// <summary>The latest answer to a request of a box.</summary>
        /// <param name="query">The request.</param>
        /// <param name="result">The answer, a copy.</param>
        /// <returns>False until the first answer, for removed requests and those of other kinds, and while the liquid does not
        /// run.</returns>
        public bool TryGetBox(FluidQuery query, out FluidBoxResult result) => TryFind(QueryKind.Box, query, out result) &&
            result.Generation == query.Generation;

        /// <summary>The latest answer to a request of a nearest particle.</summary>
        /// <param name="query">The request.</param>
        /// <param name="result">The answer, a copy.</param>
        /// <returns>False until the first answer, for removed requests and those of other kinds, and while the liquid does not
        /// run.</returns>
        public bool TryGetNearest(FluidQuery query, out FluidNearestResult result) =>
            TryFind(QueryKind.Nearest, query, out result) && result.Generation == query.Generation;

        /// <summary>The latest answer to a request of a rectangle.</summary>
        /// <param name="query">The request.</param>
        /// <param name="result">The answer, a copy.</param>
        /// <returns>False until the first answer, for removed requests and those of other kinds, and while the liquid does not
        /// run.</returns>
        public bool TryGetPatch(FluidQuery query, out FluidPatchResult result) =>
            TryFind(QueryKind.Patch, query, out result) && result.Generation == query.Generation;

        /// <summary>Waits for the answers that are under way; for tools and tests.</summary>
        public void Complete() => answers.Complete();

        /// <summary>Frees all memory; no request is answered after that.</summary>
        public void Dispose()
        {
            answers.Dispose();
            disposed = true;
        }

        /// <summary>Records this frame's questions; nothing where there are none.</summary>
        internal void Ask(FluidSolver liquid, FluidShaderSet shaders, double time, Vector3 position, Quaternion rotation)
        {
            now = time;
            if (Count == 0 || disposed) return;
            if (!answers.IsOf(liquid)) Attach(liquid, shaders);
            answers.Ask(time, position, rotation);
        }

        /// <summary>The liquid is gone: its answers too, and the GPU memory.</summary>
        internal void Detach() => answers.Detach();

        private void Set(FluidQuery query, Vector3 place, in QueryWord second)
        {
            QuerySlots slots = asked[query.Kind];
            slots.Set(query, place);
            slots.Set(query, 1, second);
        }

        private void SetBox(FluidQuery query, Vector3 centre, Vector3 size, Quaternion rotation)
        {
            SetEdges(query, centre, size, rotation);
            asked[QueryKind.Box].Set(query, 3, new QueryWord(rotation * Vector3.forward, 0.5f * size.z));
        }

        private void SetEdges(FluidQuery query, Vector3 centre, Vector2 size, Quaternion rotation)
        {
            Set(query, centre, new QueryWord(rotation * Vector3.right, 0.5f * size.x));
            asked[query.Kind].Set(query, 2, new QueryWord(rotation * Vector3.up, 0.5f * size.y));
        }

        private bool TryFind<T>(QueryKind kind, FluidQuery query, out T result) where T : struct
        {
            result = default;
            return Current != null && asked[kind].Has(query) && Current.TryGet(kind, query.Index, out result);
        }

        // A liquid whose device or shaders cannot answer is not asked again; the next start is.
        private void Attach(FluidSolver liquid, FluidShaderSet shaders)
        {
            try
            {
                answers.Attach(liquid, shaders);
            }
            catch (FluidDeviceException exception)
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.QueriesUnavailable, owner,
                    "Fluid queries are not answered: " + exception.Message,
                    "Use the package's shader set and a device that can read back without waiting."));
            }
        }
    }
}
