using UnityEngine;
using UnityEngine.Serialization;

namespace SphFluid
{
    /// <summary>
    /// Draws the particles of a simulation as textured, lit squares that face the camera. Works on every device that runs the simulation:
    /// no geometry shader.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Particle Renderer")]
    [DefaultExecutionOrder(100)]
    [ManualPage("drawing", "particles")]
    public sealed class FluidParticleRenderer : FluidRenderer
    {
        [SerializeField, Range(0.1f, 4f),
            Tooltip("Edge of a particle's square in particle spacings. 1: squares just touch in liquid at rest.")]
        private float size = 1.2f;

        [SerializeField, FormerlySerializedAs("colour"), Tooltip("Colour of a particle, or of a slow one if the speed is shown.")]
        private Color color = new Color(0.12f, 0.42f, 0.72f);

        [SerializeField, FormerlySerializedAs("colourBySpeed"), Tooltip("Whether fast particles take another colour.")]
        private bool colorBySpeed;

        [SerializeField, FormerlySerializedAs("fastColour"), Tooltip("Colour of the fastest particles, if the speed is shown.")]
        private Color fastColor = new Color(0.85f, 0.95f, 1f);

        [SerializeField, Min(0.001f), Tooltip("Speed at which a particle has the fast colour in full [m/s].")]
        private float fastSpeed = 3f;

        [SerializeField, Range(0f, 1f), Tooltip("Smoothness of the particles: how small and bright their highlights are.")]
        private float smoothness = 0.4f;

        [SerializeField, Tooltip("Picture on each square, cut out where its alpha is below a half. Empty: a round one.")]
        private Texture2D sprite;

        private ParticleSquares squares;

        /// <summary>Edge of a particle's square in particle spacings, 0.1 to 4.</summary>
        public float Size { get => Limits.Clamp(size, 0.1f, 4f); set => size = value; }

        /// <summary>Colour of a particle, or of a slow one if the speed is shown. Not a number counts as 0.</summary>
        public Color Color { get => Limits.Finite(color); set => color = value; }

        /// <summary>Whether fast particles take another colour.</summary>
        public bool ColorBySpeed { get => colorBySpeed; set => colorBySpeed = value; }

        /// <summary>Colour of the fastest particles, if the speed is shown. Not a number counts as 0.</summary>
        public Color FastColor { get => Limits.Finite(fastColor); set => fastColor = value; }

        /// <summary>Speed at which a particle has the fast colour in full [m/s], 0.001 or more.</summary>
        public float FastSpeed { get => Limits.Clamp(fastSpeed, 0.001f); set => fastSpeed = value; }

        /// <summary>Smoothness of the particles, 0 to 1.</summary>
        public float Smoothness { get => Limits.Clamp(smoothness, 0f, 1f); set => smoothness = value; }

        /// <summary>Picture on each square; null for a round one.</summary>
        public Texture2D Sprite { get => sprite; set => sprite = value; }

        /// <inheritdoc/>
        protected override void CreateResources(FluidShaderSet shaders) => squares = new ParticleSquares(shaders);

        /// <inheritdoc/>
        protected override void ReleaseResources()
        {
            squares?.Dispose();
            squares = null;
        }

        /// <inheritdoc/>
        protected override void Draw(FluidSimulation drawn)
        {
            ParticleLook look = Look(drawn);
            FluidSolver solver = drawn.Solver;
            squares.Draw(solver.Particles, solver.ParticleCount, look, Placement(drawn, look.Size));
        }

        private ParticleLook Look(FluidSimulation drawn) => new ParticleLook
        {
            Size = Size * drawn.Solver.Settings.Spacing,
            Color = Color,
            FastColor = FastColor,
            FastSpeed = colorBySpeed ? FastSpeed : 0f,
            Smoothness = Smoothness,
            Sprite = sprite,
        };
    }
}
