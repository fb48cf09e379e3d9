using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Settings for tests.</summary>
    public static class TestSettings
    {
        /// <summary>Of the thesis method by rule for a box of liquid as high as the domain.</summary>
        public static FluidSolverSettings ByRule(Vector3 domainSize, float spacing)
        {
            FluidRuleInput input = FluidRuleInput.ThesisWater;
            input.DomainSize = domainSize;
            input.Spacing = spacing;
            input.LiquidHeight = domainSize.y;
            input.LiquidDepth = 0.5f * domainSize.y;
            return FluidRules.Derive(input);
        }
    }
}
