using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A running liquid: its particles on the GPU and the order of the steps. Records into the caller's command buffer;
    /// command buffers must be executed in the order in which they were recorded. Simulation space: metres from the centre
    /// of the domain box, along its axes.
    /// </summary>
    public sealed class FluidSolver : IDisposable
    {
        /// <summary>Most steps of one recording.</summary>
        public const int MostSteps = 100_000;

        /// <summary>
        /// Particle-steps of a submission: drivers take for hung what works for 2 s (Windows), and a slow card has done so many in a tenth.
        /// </summary>
        public const int WorkPerSubmission = 1 << 22;

        private readonly FluidMethod method;
        private readonly IFluidStepper stepper;
        private readonly FluidState state;
        private readonly CounterReadback counters;
        private readonly LoadedParticles particles;
        private readonly StepRecorder recorder;
        private readonly FluidShaderSet shaderSet;
        private float? flowSpeed, peakSpeed;
        private int obstacleChanges;

        /// <summary>Uploads the particles and prepares the method.</summary>
        /// <param name="settings">The physics and its method; <see cref="FluidMethodKind.ThesisPrinted"/> sets its switches as
        /// printed.</param>
        /// <param name="shaders">The compute shaders.</param>
        /// <param name="initial">Particles at the start, inside the domain; one or more, or none where the method brings particles into a
        /// running liquid.</param>
        /// <exception cref="ArgumentException">A constant or the particles cannot be computed with.</exception>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel or hold a buffer.</exception>
        public FluidSolver(in FluidSolverSettings settings, FluidShaderSet shaders, IReadOnlyList<FluidParticle> initial)
            : this(settings, shaders, initial, 0)
        {
        }

        internal FluidSolver(in FluidSolverSettings settings, FluidShaderSet shaders, IReadOnlyList<FluidParticle> initial, int capacity)
        {
            method = FluidMethods.Get(settings.Method);
            method.Check(settings);
            FluidParticle[] first =
                LoadedParticles.Check(settings, initial, !method.Has(FluidMethodFeatures.ChangingCount), nameof(initial));
            if (shaders == null)
            {
                throw new ArgumentException("No fluid shader set is given. Assign one in the fluid profile.", nameof(shaders));
            }
            shaderSet = shaders;
            stepper = method.Start(method.Prepare(settings), shaders, LoadedParticles.SlotsFor(method, first.Length, capacity));
            state = stepper.State;
            counters = new CounterReadback(state.Published.Counters, settings.RestDensity);
            particles = new LoadedParticles(stepper, counters);
            particles.Upload(first);
            recorder = new StepRecorder(stepper, counters, particles);
        }

        /// <summary>The method.</summary>
        public FluidMethodKind Kind => state.Settings.Method;

        /// <summary>
        /// Particles of <see cref="Particles"/> to look at, 1 or more: live ones come first, and <see cref="FluidParticle.Removed"/> marks
        /// the rest. The number of live ones where none was born and none left. Ask again after each recording.
        /// </summary>
        public int ParticleCount => state.ParticleCount;

        /// <summary>Live particles as of the last finished read-back; only the GPU knows of births and removals since.</summary>
        public long LiveCount => particles.LiveCount;

        /// <summary>Particles that the buffers hold before larger ones are made.</summary>
        public int Capacity => state.Capacity;

        /// <summary>The physics, a copy.</summary>
        public FluidSolverSettings Settings => state.Settings;

        /// <summary>The neighbour grid.</summary>
        public FluidGrid Grid => state.Grid;

        /// <summary>Cells of the method's neighbour search.</summary>
        public int CellCount => state.CellCount;

        /// <summary>Whether the method keeps a list of each particle's neighbours from the density to the forces.</summary>
        public bool ListsNeighbours => state.ListsNeighbours;

        /// <summary>
        /// FluidParticle a particle, in the order of the last neighbour setup, live ones first; see <see cref="ParticleCount"/>. Ask again
        /// after each recording: it may be another buffer.
        /// </summary>
        public GraphicsBuffer Particles => state.Published.Particles;

        /// <summary>Density [kg/m³], float a particle, in the order of <see cref="Particles"/>, as of the last neighbour setup.</summary>
        public GraphicsBuffer Density => state.Published.Density;

        /// <summary>Pressure [Pa], float a particle, in the order of <see cref="Particles"/>, as of the last neighbour setup.</summary>
        public GraphicsBuffer Pressure => state.Published.Pressure;

        /// <summary>
        /// First and end of each cell's particles in <see cref="Particles"/>, uint2 a cell, as of the last neighbour setup.
        /// In a domain of very many cells it has only those with particles: Shaders/GridCells.hlsl.
        /// </summary>
        public GraphicsBuffer GridIndices => state.Published.GridIndices;

        /// <summary>The first of the ranges of cells in <see cref="GridIndices"/>, and their number.</summary>
        internal (int First, int Count) CellRanges =>
            state.Sparse.AreUsed ? state.Sparse.PublishedRanges(state.Capacity) : (0, Grid.CellCount);

        /// <summary>Steps recorded since the start.</summary>
        public long StepCount => recorder.StepCount;

        /// <summary>Time recorded since the start [s].</summary>
        public double SimulatedTime => recorder.SimulatedTime;

        /// <summary>
        /// Changes with every step that is recorded and whenever particles or physics are set: while it stays, so does what a surface
        /// shows.
        /// </summary>
        internal long StateVersion => StepCount + SettingsChanges + ParticleChanges;

        /// <summary>Whether the GPU memory is released.</summary>
        internal bool IsDisposed { get; private set; }

        /// <summary>Length of the last recorded step [s]: velocities are half of it older than positions; 0 before the first.</summary>
        internal float LastTimeStep => recorder.PreviousStep;

        /// <summary>
        /// Speed at which bodies of the liquid move [m/s], for methods whose neighbour setup serves several steps: the faster, the fewer.
        /// By default the speed that the settings are made for; whoever measures it gives a speed of a fixed age, so that equal runs stay
        /// equal.
        /// </summary>
        public float FlowSpeed
        {
            get => flowSpeed ?? state.Settings.MaxSpeed;
            set => flowSpeed = NotNegative(value);
        }

        /// <summary>
        /// Speed of the fastest particle [m/s], for methods whose steps are the more thorough the farther it goes in one. By default the
        /// speed that the settings are made for; whoever measures it gives a speed of a fixed age, so that equal runs stay equal.
        /// </summary>
        public float PeakSpeed
        {
            get => peakSpeed ?? state.Settings.MaxSpeed;
            set => peakSpeed = NotNegative(value);
        }

        /// <summary>
        /// The longest step of late [s], for methods that are the softer the longer a step is: where steps vary they stay as soft as that
        /// one makes them, and what rests goes on resting. 0, the default: each step decides alone.
        /// </summary>
        internal float LongestStep { get; set; }

        /// <summary>
        /// Neighbour setups recorded since the start: no more than one a step, and one for drawing that the next step uses.
        /// </summary>
        public long SetupCount => recorder.SetupCount;

        /// <summary>Events counted on the GPU, as of the last finished read-back.</summary>
        public FluidCounters Counters => counters.Counters;

        /// <summary>The bodies that left a particle no place last, as <see cref="CounterReadback.Squeezers"/>.</summary>
        internal uint Squeezers => counters.Squeezers;

        /// <summary>Particles that left through faces of the domain, since this solver was made.</summary>
        internal long LeftThroughFaces => counters.LeftThroughFaces;

        /// <summary>Bytes of GPU memory that the solver holds.</summary>
        public long GpuBytes => state.Bytes + (recorder.Exchange?.GpuBytes ?? 0) + (state.Zones?.GpuBytes ?? 0) +
            (state.WallForces?.GpuBytes ?? 0);

        /// <summary>Grows with each change of physics, obstacles or particles from outside the steps.</summary>
        internal int Changes => obstacleChanges + SettingsChanges + ParticleChanges;

        /// <summary>Grows when other settings are applied.</summary>
        internal int SettingsChanges { get; private set; }

        /// <summary>Grows when particles are put in the place of the present ones.</summary>
        internal int ParticleChanges { get; private set; }

        internal FluidState State => state;

        /// <summary>All that sleeps wakes at once.</summary>
        internal void WakeAll()
        {
            if (state.Wake(true)) recorder.Forget();
        }

        /// <summary>What sleeps where <see cref="FluidState.KeepAwake"/> keeps liquid awake wakes at once, before the next step.</summary>
        internal void WakeKept()
        {
            if (state.Wake(false)) recorder.Forget();
        }

        /// <summary>Births recorded since the start, whatever becomes of them.</summary>
        internal long BirthCount => recorder.Exchange?.Births.Taken ?? 0;

        /// <summary>Whether something has come or gone, or is to.</summary>
        internal bool HasExchange => recorder.Exchange != null;

        /// <summary>Whether particles can come and go.</summary>
        internal bool Exchanges => stepper is IExchangingStepper;

        /// <summary>What brings particles into the liquid and takes them out, made when it is first asked for.</summary>
        /// <exception cref="InvalidOperationException">The method's number of particles is fixed.</exception>
        internal ParticleExchange Exchange => recorder.Exchange ??= stepper is IExchangingStepper exchanging
            ? new ParticleExchange(state, exchanging, particles.NextId)
            : throw new InvalidOperationException(
                $"The method {Kind} has a fixed number of particles: nothing is born or drained. Use the method Standard or Robust.");

        internal IFluidStepper Stepper => stepper;

        /// <summary>Whether the method sums the liquid's force on walls, so that <see cref="WallForces"/> can be asked for.</summary>
        public bool MeasuresWallForces => method.Has(FluidMethodFeatures.WallForces);

        /// <summary>
        /// Why the device cannot sum the force on walls; null where it can. Where there are sums the device is not asked again.
        /// </summary>
        internal string WallForcesShortfall => state.WallForces == null ? WallForces.Shortfall() : null;

        /// <summary>The force of the liquid on rectangles of its walls; costs nothing while there is none.</summary>
        /// <exception cref="NotSupportedException">The method does not sum what walls do to the liquid: see
        /// <see cref="MeasuresWallForces"/>.</exception>
        /// <exception cref="FluidDeviceException">The method does, and the device cannot: see
        /// <see cref="FluidSupport.WallForces"/>.</exception>
        public WallForces WallForces
        {
            get
            {
                ThrowIfDisposed();
                if (!MeasuresWallForces)
                {
                    throw new NotSupportedException(
                        $"The method {Kind} does not sum the force on walls. Use the method {FluidMethodKind.Standard}.");
                }
                return state.WallForces ??= WallForces.Start(shaderSet);
            }
        }

        /// <summary>
        /// Gives the solver what the liquid collides with; the caller keeps it alive, updates it once a frame and disposes it.
        /// </summary>
        /// <param name="obstacles">Obstacles made with this solver's <see cref="Settings"/>; null for none.</param>
        /// <exception cref="ArgumentException">They were made for another liquid.</exception>
        public void SetObstacles(FluidObstacles obstacles)
        {
            ThrowIfDisposed();
            obstacles?.Check(state.Settings);
            obstacleChanges++;
            recorder.SetObstacles(obstacles);
            SetBodies(obstacles?.Bodies);
        }

        /// <summary>
        /// Gives the solver the scene's bodies; the caller keeps them alive, updates them once a frame and disposes them. Methods with
        /// <see cref="FluidMethodFeatures.BodyContact"/> only.
        /// </summary>
        internal void SetBodies(CollisionBodies bodies)
        {
            ThrowIfDisposed();
            if (bodies == state.Bodies) return;
            obstacleChanges++;
            if (bodies != null && !method.Has(FluidMethodFeatures.BodyContact))
            {
                throw new ArgumentException($"The method {Kind} takes triangles, not bodies. Give it the scene by SetObstacles.",
                    nameof(bodies));
            }
            state.Bodies = bodies;
            recorder.Forget();
        }

        /// <summary>
        /// Gives the solver force zones; the caller keeps them alive and disposes them. Methods without force zones leave them out.
        /// </summary>
        internal void SetZones(ForceZones zones)
        {
            ThrowIfDisposed();
            state.Zones = zones;
        }

        /// <summary>Changes the physics between steps.</summary>
        /// <param name="settings">New constants; domain size, support radius, neighbour search and periodic axes must stay, the grid
        /// depends on them.</param>
        /// <exception cref="ArgumentException">A constant is out of range, or the grid would change.</exception>
        public void ApplySettings(in FluidSolverSettings settings)
        {
            ThrowIfDisposed();
            if (settings.Method != Kind)
            {
                throw new ArgumentException(
                    $"The solver computes by {Kind}, and the settings are for {settings.Method}. Start a new solver for another method.");
            }
            method.Check(settings);
            FluidSolverSettings prepared = method.Prepare(settings);
            FluidGrid.CheckKept(state.Settings, prepared);
            SettingsChanges++;
            state.Settings = prepared;
            counters.RestDensity = settings.RestDensity;
            recorder.Forget();
        }

        /// <summary>Records a number of steps, and a read-back of the counters.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="steps">Number of steps, 0 to <see cref="MostSteps"/>; none records nothing.</param>
        /// <exception cref="ArgumentOutOfRangeException">The number of steps is out of range.</exception>
        public void RecordSteps(CommandBuffer cmd, int steps) => RecordSteps(cmd, steps, state.Settings.TimeStep);

        /// <summary>Records a number of steps of another length than the settings have, and a read-back of the counters.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="steps">Number of steps, 0 to <see cref="MostSteps"/>; none records nothing.</param>
        /// <param name="timeStep">Length of each [s], positive. Velocities live between the steps: the first kick after a change is
        /// the mean of both lengths.</param>
        /// <exception cref="ArgumentOutOfRangeException">An argument is out of range.</exception>
        public void RecordSteps(CommandBuffer cmd, int steps, float timeStep) => RecordSteps(cmd, steps, timeStep, null);

        /// <summary>Records steps that go to the GPU in parts.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="steps">Number of steps.</param>
        /// <param name="timeStep">Length of each [s].</param>
        /// <param name="submit">Submits what is recorded so far, and empties the command buffer: after some <see cref="WorkPerSubmission"/>
        /// particle-steps, if more steps follow; null: everything is one part.</param>
        internal void RecordSteps(CommandBuffer cmd, int steps, float timeStep, Action submit)
        {
            ThrowIfDisposed();
            if (steps < 0 || steps > MostSteps)
            {
                throw new ArgumentOutOfRangeException(nameof(steps), steps,
                    $"The number of steps must be 0 to {MostSteps}. Record more with another call.");
            }
            if (!(timeStep > 0f) || float.IsInfinity(timeStep))
            {
                throw new ArgumentOutOfRangeException(nameof(timeStep), timeStep,
                    "The length of a step must be a positive number of seconds.");
            }
            if (steps > 0) recorder.RecordSteps(cmd, steps, timeStep, FlowSpeed, PeakSpeed, LongestStep, submit);
        }

        /// <summary>
        /// Records sort, grid ranges and density at the present positions, so that <see cref="Particles"/>,
        /// <see cref="Density"/> and <see cref="GridIndices"/> agree for drawing. The next step uses it: nothing is done twice.
        /// </summary>
        /// <param name="cmd">Command buffer to record into.</param>
        public void RecordNeighbourSetup(CommandBuffer cmd)
        {
            ThrowIfDisposed();
            recorder.RecordNeighbourSetup(cmd);
        }

        /// <summary>Puts other particles in the place of the present ones. What the GPU still has to do with those is done first.</summary>
        /// <param name="particles">Inside the domain; those that are marked as removed are passed over. With a method of fixed number as
        /// many as there are.</param>
        /// <exception cref="ArgumentException">Their number differs, or one lies outside the domain.</exception>
        public void SetParticles(IReadOnlyList<FluidParticle> particles)
        {
            ThrowIfDisposed();
            if (particles == null || !Exchanges && particles.Count != ParticleCount)
            {
                throw new ArgumentException(
                    $"The solver holds {ParticleCount} particles, and {particles?.Count ?? 0} are given. Start a new solver for another " +
                    "number.",
                    nameof(particles));
            }
            FluidParticle[] live = LoadedParticles.Check(state.Settings, particles, !Exchanges, nameof(particles));
            counters.ReadNow();
            recorder.Replace(live);
            if (HasExchange) Exchange.Births.NextId = this.particles.NextId;
            ParticleChanges++;
        }

        /// <summary>
        /// Puts other particles in the place of the present ones as a step that led to them would: what follows the liquid from frame to
        /// frame goes on, unless this is a jump. Methods with <see cref="FluidMethodFeatures.ChangingCount"/> only.
        /// </summary>
        /// <param name="shown">The particles, inside the domain; where there are none one that is marked as removed.</param>
        /// <param name="count">Number of them, no more than <see cref="Capacity"/>.</param>
        /// <param name="time">Time of the liquid [s].</param>
        /// <param name="isJump">Whether they do not follow from those before.</param>
        internal void Show(NativeArray<FluidParticle> shown, int count, double time, bool isJump)
        {
            ThrowIfDisposed();
            recorder.Show(shown, count, time);
            if (isJump) ParticleChanges++;
        }

        /// <summary>How far the liquid has come, besides its particles; for saves.</summary>
        internal SolverProgress Progress => recorder.Progress;

        /// <summary>Goes on from a save: no read-back is under way, and order and neighbours are found anew.</summary>
        internal void Continue(FluidParticle[] live, in SolverProgress progress)
        {
            ThrowIfDisposed();
            recorder.Continue(live, progress);
        }

        /// <summary>Records the globals and the keyword of a kernel that includes Shaders/Solver/GridNeighbours.hlsl.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="kernel">The kernel.</param>
        public void BindNeighbours(CommandBuffer cmd, ComputeKernel kernel)
        {
            ThrowIfDisposed();
            GridNeighbours.Set(cmd, kernel, state);
        }

        /// <summary>
        /// Records the method's list of neighbours (Shaders/Solver/Cells/NeighbourList.hlsl) for a kernel that can search instead; of
        /// length 0 where the method has none.
        /// </summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="kernel">The kernel.</param>
        internal void BindNeighbourList(CommandBuffer cmd, ComputeKernel kernel)
        {
            ThrowIfDisposed();
            state.BindNeighbourList(cmd, kernel);
        }

        /// <summary>
        /// Records the walls of triangles near particles (Shaders/Solver/Cells/PackedWall.hlsl) for a kernel with FLUID_MESH_WALLS,
        /// which is off where the method gathers none.
        /// </summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="kernel">The kernel.</param>
        internal void BindNearWalls(CommandBuffer cmd, ComputeKernel kernel)
        {
            ThrowIfDisposed();
            state.BindNearWalls(cmd, kernel);
        }

        /// <summary>Waits for the GPU and reads the counters; for tools and tests.</summary>
        /// <returns>The counters now.</returns>
        public FluidCounters ReadCountersNow()
        {
            ThrowIfDisposed();
            return counters.ReadNow();
        }

        /// <summary>Checks that a liquid can start from particles, as the constructor does.</summary>
        /// <param name="settings">The physics.</param>
        /// <param name="initial">The particles.</param>
        /// <returns>A copy of them.</returns>
        /// <exception cref="ArgumentException">A constant is out of range, there is no particle, or one lies outside the
        /// domain.</exception>
        public static FluidParticle[] CheckParticles(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> initial)
        {
            FluidMethods.Get(settings.Method).Check(settings);
            return LoadedParticles.Check(settings, initial, true, nameof(initial));
        }


        /// <summary>Releases the GPU memory.</summary>
        public void Dispose()
        {
            if (IsDisposed) return;
            IsDisposed = true;
            counters.Dispose();
            recorder.Exchange?.Dispose();
            state.WallForces?.Dispose();
            stepper.Dispose();
        }

        private static float NotNegative(float value) =>
            value >= 0f && value <= float.MaxValue ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "The liquid's speed must be zero or more, and finite.");

        private void ThrowIfDisposed()
        {
            if (IsDisposed) throw new ObjectDisposedException(nameof(FluidSolver));
        }
    }
}
