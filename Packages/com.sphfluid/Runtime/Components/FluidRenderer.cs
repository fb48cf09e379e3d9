using UnityEngine;

namespace SphFluid
{
    /// <summary>Base of the components that draw a simulation themselves, for every camera.</summary>
    public abstract class FluidRenderer : FluidView
    {
        [SerializeField, Tooltip("Whether the liquid casts shadows.")]
        private bool castShadows = true;

        [SerializeField, Tooltip("Whether the main directional light's shadows fall on the liquid. Shadows of other lights never do.")]
        private bool receiveShadows = true;

        /// <summary>Whether the liquid casts shadows.</summary>
        public bool CastShadows { get => castShadows; set => castShadows = value; }

        /// <summary>Whether the main directional light's shadows fall on the liquid. Shadows of other lights never do.</summary>
        public bool ReceiveShadows { get => receiveShadows; set => receiveShadows = value; }

        /// <inheritdoc/>
        protected override void OnDisable()
        {
            MainLightShadows.Remove(this);
            base.OnDisable();
        }

        /// <inheritdoc/>
        protected override void DrawNothing() => MainLightShadows.Remove(this);

        /// <summary>Where and how a drawing of <paramref name="drawn"/> goes.</summary>
        /// <param name="drawn">The simulation.</param>
        /// <param name="margin">How far the drawing reaches beyond the domain [m].</param>
        /// <param name="waterShadow">Strength of the shadow that it casts as water, 0 to 1.</param>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        internal DrawPlacement Placement(FluidSimulation drawn, float margin, float waterShadow = 0f)
        {
            FluidSolverSettings settings = drawn.Solver.Settings;
            var placement = new DrawPlacement(drawn.LocalToWorld, settings.DomainSize, margin, gameObject.layer, castShadows,
                receiveShadows, settings.Spacing,
                waterShadow);
            if (placement.ReceiveShadows)
                MainLightShadows.Add(this, drawn.Profile.Shaders);
            else
                MainLightShadows.Remove(this);
            return placement;
        }
    }
}
