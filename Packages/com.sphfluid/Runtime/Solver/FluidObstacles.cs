using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What the liquid of a <see cref="FluidSolver"/> without components collides with: colliders and meshes, for any method. Add
    /// them, give this to <see cref="FluidSolver.SetObstacles"/>, and call <see cref="Update"/> once a frame before the steps are
    /// recorded: the next steps take the obstacles to where they are then, and the liquid feels their motion.
    /// </summary>
    /// <example>
    /// <code>
    /// var obstacles = new FluidObstacles(solver.Settings);
    /// int gate = obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.1f, 1f, 1f))), Matrix4x4.identity);
    /// obstacles.Update(Matrix4x4.identity);
    /// solver.SetObstacles(obstacles);
    /// </code>
    /// </example>
    public sealed class FluidObstacles : IDisposable
    {
        private readonly CollisionScene scene;
        private readonly CollisionBodies bodies; // null with methods that take triangles
        private readonly FluidSolverSettings settings;
        private readonly List<Entry> entries = new List<Entry>();
        private readonly List<FluidMessage> messages = new List<FluidMessage>();
        private List<ColliderState> states = new List<ColliderState>();
        private List<ColliderState> previous = new List<ColliderState>();

        /// <summary>No obstacles yet.</summary>
        /// <param name="settings">The liquid's, as of <see cref="FluidSolver.Settings"/>: method, domain, spacing and support radius
        /// count.</param>
        /// <exception cref="ArgumentException">A constant is out of range.</exception>
        public FluidObstacles(in FluidSolverSettings settings)
            : this(settings, new CollisionScene())
        {
            FluidMethods.Get(settings.Method).Check(settings);
        }

        /// <summary>The colliders of a scene, which is taken over.</summary>
        internal FluidObstacles(in FluidSolverSettings settings, CollisionScene scene)
        {
            this.settings = settings;
            this.scene = scene;
            if (FluidMethods.Has(settings.Method, FluidMethodFeatures.BodyContact)) bodies = new CollisionBodies(settings);
        }

        /// <summary>What takes part, as of the last update.</summary>
        public IReadOnlyList<FluidObstacle> Found => scene.Solids;

        /// <summary>Why something was left out or could not be followed, as of the last update.</summary>
        public IReadOnlyList<FluidMessage> Messages => messages;

        /// <summary>
        /// Times an obstacle moved or changed more than the liquid can follow since the start; it was put at its new place at once.
        /// </summary>
        public int Jumps => bodies?.Jumps ?? 0;

        /// <summary>Number of triangles that the solver tests against.</summary>
        public int TriangleCount => bodies?.TriangleCount ?? scene.Triangles.Count;

        /// <summary>GPU memory [bytes].</summary>
        public long GpuBytes => scene.GpuBytes + (bodies?.Bytes ?? 0);

        internal CollisionScene Scene => scene;

        /// <summary>The obstacles for methods that prove motion free; null for other methods.</summary>
        internal CollisionBodies Bodies => bodies;

        /// <summary>
        /// Adds a Mesh, Box, Sphere, Capsule, Terrain or Wheel Collider or a Character Controller, active or not; it is followed wherever
        /// it goes.
        /// </summary>
        /// <param name="collider">The collider.</param>
        /// <param name="friction">0 free slip to 1 no slip; null: as the domain's faces. Methods without friction of their own ignore
        /// it.</param>
        /// <exception cref="ArgumentNullException">There is no collider.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The friction is not between 0 and 1.</exception>
        public void Add(Collider collider, float? friction = null)
        {
            if (collider == null) throw new ArgumentNullException(nameof(collider));
            entries.Add(new Entry { Collider = collider, Friction = FrictionOf(friction) });
        }

        /// <summary>Adds a mesh.</summary>
        /// <param name="mesh">Its triangles, in a space of its own.</param>
        /// <param name="pose">That space to simulation space; scale and shear may differ from none.</param>
        /// <param name="friction">0 free slip to 1 no slip; null: as the domain's faces. Methods without friction of their own ignore
        /// it.</param>
        /// <returns>A number to call <see cref="MoveTo"/> with.</returns>
        /// <exception cref="ArgumentException">The mesh is missing or has no triangles, or a number of the pose is not finite.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The friction is not between 0 and 1.</exception>
        public int Add(TriangleMesh mesh, in Matrix4x4 pose, float? friction = null)
        {
            Require.Finite(pose, nameof(pose));
            entries.Add(new Entry { Mesh = Checked(mesh, nameof(mesh)), Pose = pose, Friction = FrictionOf(friction) });
            return entries.Count - 1;
        }

        /// <summary>
        /// Adds a mesh that gravity and the liquid move, as a rigid body: it floats, sinks and is carried. Floating meshes do not touch
        /// each other.
        /// </summary>
        /// <param name="mesh">Its triangles, in a space of its own: the origin is the centre of mass, the axes are the principal
        /// ones.</param>
        /// <param name="centre">Centre of mass at the start [m], simulation space.</param>
        /// <param name="rotation">Principal axes to simulation space at the start.</param>
        /// <param name="mass">Mass [kg].</param>
        /// <param name="inertia">Moments of inertia about the principal axes [kg m²]; 0: it does not turn about the axis.</param>
        /// <param name="friction">0 free slip to 1 no slip; null: as the domain's faces.</param>
        /// <returns>A number to call <see cref="Push"/> and <see cref="ReadPoseNow"/> with.</returns>
        /// <exception cref="NotSupportedException">The method moves no bodies.</exception>
        /// <exception cref="ArgumentException">The mesh is missing or has no triangles, or its place has numbers that are not
        /// finite.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Mass, inertia or friction are out of range.</exception>
        public int AddFloating(TriangleMesh mesh, Vector3 centre, Quaternion rotation, float mass, Vector3 inertia, float? friction = null)
        {
            if (bodies == null)
            {
                throw new NotSupportedException(
                    $"The method {settings.Method} moves no bodies. Use the method {FluidMethodKind.Standard} or " +
                    $"{FluidMethodKind.Robust}, or Add and MoveTo.");
            }
            if (!(mass > 0f) || !AffineMath.IsFinite(mass))
            {
                throw new ArgumentOutOfRangeException(nameof(mass), mass, "The mass of a floating mesh is greater than 0 and finite [kg].");
            }
            if (!(Mathf.Min(inertia.x, Mathf.Min(inertia.y, inertia.z)) >= 0f) || !AffineMath.IsFinite(inertia.sqrMagnitude))
            {
                throw new ArgumentOutOfRangeException(nameof(inertia), inertia, "Moments of inertia are 0 or greater, and finite [kg m²].");
            }
            Require.Place(centre, rotation);
            int number = Add(mesh, Matrix4x4.TRS(centre, rotation, Vector3.one), friction);
            Float(number, new FloatingBody(new FloatingMass(mass, inertia, settings.Gravity), new FloatingPose(centre, rotation)));
            return number;
        }

        /// <summary>Changes a floating mesh's velocity, spread over the steps up to the next <see cref="Update"/>.</summary>
        /// <param name="mesh">The number that <see cref="AddFloating"/> returned.</param>
        /// <param name="velocity">Added to the velocity of the centre of mass [m/s].</param>
        /// <param name="angularVelocity">Added to the angular velocity [rad/s].</param>
        /// <exception cref="ArgumentException">A velocity is not finite, or no floating mesh has that number.</exception>
        public void Push(int mesh, Vector3 velocity, Vector3 angularVelocity) =>
            FloatingOf(mesh)
                .Push(Require.Finite(velocity, nameof(velocity)), Require.Finite(angularVelocity, nameof(angularVelocity)), Vector3.zero,
                    Vector3.zero);

        /// <summary>Where the recorded steps that were submitted leave a floating mesh; waits for the GPU.</summary>
        /// <param name="mesh">The number that <see cref="AddFloating"/> returned.</param>
        /// <param name="rotation">Its axes to simulation space.</param>
        /// <returns>Its centre of mass [m], simulation space.</returns>
        /// <exception cref="ArgumentOutOfRangeException">No floating mesh has that number.</exception>
        public Vector3 ReadPoseNow(int mesh, out Quaternion rotation)
        {
            FloatingBody body = FloatingOf(mesh);
            // Before its first update the GPU knows nothing of it.
            FloatingPose pose = bodies.Floating.NumberOf(body) > 0 && bodies.Floating.Frame > 0 ? bodies.Floating.ReadNow(body).Pose
                : body.Pose;
            rotation = pose.Rotation;
            return pose.Centre;
        }

        /// <summary>Moves a mesh; <see cref="Update"/> takes it over.</summary>
        /// <param name="mesh">The number that <see cref="Add(TriangleMesh, in Matrix4x4, float?)"/> returned.</param>
        /// <param name="pose">Where it is now: its own space to simulation space.</param>
        /// <exception cref="ArgumentException">There is no such mesh, or a number of the pose is not finite.</exception>
        /// <exception cref="InvalidOperationException">The mesh floats.</exception>
        public void MoveTo(int mesh, in Matrix4x4 pose)
        {
            Entry entry = EntryOf(mesh);
            if (entry.Body != null)
            {
                throw new InvalidOperationException("The liquid moves this mesh. Call Push, or Add it instead of AddFloating.");
            }
            Require.Finite(pose, nameof(pose));
            entry.Pose = pose;
        }

        /// <summary>
        /// Gives a mesh other corners; <see cref="Update"/> takes them over, and the next steps take them there on straight lines.
        /// </summary>
        /// <param name="mesh">The number that <see cref="Add(TriangleMesh, in Matrix4x4, float?)"/> returned.</param>
        /// <param name="shape">The mesh now, from <see cref="TriangleMesh.Deformed"/>. One of other triangles is put in place at
        /// once.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such mesh.</exception>
        /// <exception cref="ArgumentException">The shape is missing or has no triangles.</exception>
        public void Reshape(int mesh, TriangleMesh shape) => EntryOf(mesh).Mesh = Checked(shape, nameof(shape));

        /// <summary>
        /// Lets a rectangle on which the liquid's force is summed go with a mesh within the steps of a frame. Keep both together:
        /// call <see cref="WallForces.Move"/> when <see cref="MoveTo"/> is called. On a floating mesh it stays as placed on the mesh at its
        /// start.
        /// </summary>
        /// <param name="mesh">The number that <see cref="Add(TriangleMesh, in Matrix4x4, float?)"/> or <see cref="AddFloating"/>
        /// returned.</param>
        /// <param name="patch">The rectangle.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such mesh.</exception>
        /// <exception cref="ArgumentNullException">There is no rectangle.</exception>
        public void Carry(int mesh, WallPatch patch)
        {
            if (patch == null) throw new ArgumentNullException(nameof(patch));
            patch.Carrier = EntryOf(mesh);
        }

        /// <summary>Lets the liquid move a mesh with a rigid body; several meshes may have the same.</summary>
        /// <param name="mesh">The number that <see cref="Add(TriangleMesh, in Matrix4x4, float?)"/> returned.</param>
        /// <param name="body">The body; null: the mesh goes where <see cref="MoveTo"/> puts it.</param>
        internal void Float(int mesh, FloatingBody body) => entries[mesh].Body = body;

        /// <summary>Forgets all colliders and meshes; <see cref="Update"/> takes them away.</summary>
        public void Clear() => entries.Clear();

        /// <summary>Takes over where everything is now. Once a frame, before the steps are recorded.</summary>
        /// <param name="worldToSimulation">World space to simulation space, for colliders.</param>
        /// <exception cref="ArgumentException">A number is not finite.</exception>
        /// <exception cref="FluidDeviceException">The device cannot hold the triangles.</exception>
        public void Update(in Matrix4x4 worldToSimulation)
        {
            Require.Finite(worldToSimulation, nameof(worldToSimulation));
            (states, previous) = (previous, states);
            states.Clear();
            foreach (Entry entry in entries)
            {
                if (entry.Mesh != null) states.Add(new ColliderState(entry, entry.Mesh, entry.Friction, entry.Pose).With(entry.Body));
                else if (entry.Collider !=
                    null) states
                        .Add(scene.States.Get(entry.Collider, null, entry.Friction, worldToSimulation, settings.DomainSize,
                            settings.Spacing));
            }

            if (!IsSame())
            {
                scene.SetColliders(states, new CollisionQuery { DomainSize = settings.DomainSize, Spacing = settings.Spacing });
                Share();
            }

            messages.Clear();
            messages.AddRange(scene.Messages);
            foreach (BodyJump jump in TrackMotion()) messages.Add(jump.Message);
            if (bodies != null) messages.AddRange(bodies.Floating.Messages);
        }

        /// <summary>Releases the GPU memory; no solver may use the obstacles after it.</summary>
        public void Dispose()
        {
            bodies?.Dispose();
            scene.Dispose();
        }

        /// <summary>Hands changed triangles to methods that take them.</summary>
        internal void Share()
        {
            if (bodies == null) scene.Upload();
        }

        /// <summary>Hands the colliders' motion to methods that follow it.</summary>
        /// <returns>Those that could not be followed.</returns>
        internal IReadOnlyList<BodyJump> TrackMotion()
        {
            if (bodies == null) return Array.Empty<BodyJump>();
            bodies.Update(scene.Solids);
            return bodies.NewJumps;
        }

        /// <summary>Checks that a liquid can use the obstacles.</summary>
        /// <exception cref="ArgumentException">They were made for another one.</exception>
        internal void Check(in FluidSolverSettings liquid)
        {
            bool takesBodies = FluidMethods.Has(liquid.Method, FluidMethodFeatures.BodyContact);
            if (takesBodies != (bodies != null) || liquid.DomainSize != settings.DomainSize ||
                liquid.SupportRadius != settings.SupportRadius ||
                liquid.Spacing != settings.Spacing || liquid.Boundaries.Periodic != settings.Boundaries.Periodic)
            {
                throw new ArgumentException("The obstacles were made for a liquid of another method, domain, spacing or support radius. " +
                    "Make them with the settings of the solver that they are given to.");
            }
        }

        private bool IsSame()
        {
            if (states.Count != previous.Count) return false;
            for (int i = 0; i < states.Count; i++)
                if (!states[i].Equals(previous[i])) return false;
            return true;
        }

        private FloatingBody FloatingOf(int mesh) => mesh >= 0 && mesh < entries.Count && entries[mesh].Body != null
            ? entries[mesh].Body
            : throw new ArgumentOutOfRangeException(nameof(mesh), mesh,
                "There is no floating mesh of that number. Use the one that AddFloating returned.");

        private Entry EntryOf(int mesh)
        {
            if (mesh < 0 || mesh >= entries.Count || entries[mesh].Mesh == null)
            {
                throw new ArgumentOutOfRangeException(nameof(mesh), mesh,
                    "There is no mesh of that number. Use the one that Add returned.");
            }
            return entries[mesh];
        }

        private static TriangleMesh Checked(TriangleMesh mesh, string name) => mesh == null || mesh.TriangleCount == 0
            ? throw new ArgumentException("An obstacle needs a mesh of one triangle or more.", name)
            : mesh;

        private static float FrictionOf(float? friction)
        {
            if (friction is float given && !(given >= 0f && given <= 1f))
            {
                throw new ArgumentOutOfRangeException(nameof(friction), given, "Friction is between 0, free slip, and 1, no slip.");
            }
            return friction ?? ColliderSettings.DomainFriction;
        }

        // Known by itself: a mesh may be added more than once.
        private sealed class Entry
        {
            public Collider Collider;
            public TriangleMesh Mesh;
            public Matrix4x4 Pose;
            public float Friction;
            public FloatingBody Body;
        }
    }
}
