using UnityEngine;

namespace SphFluid
{
    /// <summary>Base of the components that draw a simulation themselves, for every camera.</summary>
    public abstract class FluidRenderer : FluidView
    {
        [SerializeField, Tooltip("Whether the liquid casts shadows.")]
        bool castShadows = true;

        /// <summary>Whether the liquid casts shadows.</summary>
        public bool CastShadows { get => castShadows; set => castShadows = value; }

        /// <summary>Where and how a drawing of <paramref name="drawn"/> goes.</summary>
        /// <param name="drawn">The simulation.</param>
        /// <param name="margin">How far the drawing reaches beyond the domain [m].</param>
        internal DrawPlacement Placement(FluidSimulation drawn, float margin)
        {
            return new DrawPlacement(drawn.LocalToWorld, drawn.Solver.Settings.DomainSize, margin, gameObject.layer, castShadows);
        }
    }
}
