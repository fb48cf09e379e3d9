using System.Reflection;

namespace SphFluid.Tests
{
    /// <summary>Calls of the package with arguments that they should not get.</summary>
    public sealed class ArgumentContractTests : ArgumentContract
    {
        protected override Assembly Package => typeof(FluidSimulation).Assembly;

        protected override (string call, string reason)[] Exempt => new[]
        {
            (@"^Fluid(Message|Finding)\.new", "says what was found"),
            (@"^FluidReading\.new", "has no number while nothing was read"),
            (@"^FluidStatistics\.RmsSpeed", "goes by what was measured"),
            (@"^FluidDetectors\.", "looks for what is wrong with constants and measurements"),
            (@"^ComputeKernel\.", "hands on what a shader is to get, as a CommandBuffer does"),
            (@"^FluidParticle\.new", "is checked where a liquid takes it"),
            (@" (initial|particles)\.(VelT0|VelT1|Removed) ", "is counted and stopped by the guards of the steps"),
            (@"^TriangleMesh\.(Contains|Winding|IsNear)", "is nowhere without numbers"),
            (@"^TriangleMesh\.GetTriangle", "is an index of an array, in inner loops"),
            (@"^TriangleMesh\.(Box|Transformed|Deformed)", "makes triangles without numbers, left out and named where a liquid takes them"),
            (@"^SurfaceMesh\.", "holds what a surface was found to be"),
            (@"\.WithSoundSpeed", "is checked where a liquid takes the settings"),
            (@"^(FluidRules\.(Advise|EffectiveSoundSpeed|ActingViscosity)|SurfaceFieldSettings|FluidGrid\.For).* settings\.",
                "goes by settings that a liquid has"),
            (@"^TimeStepAdvice\.", "compares a number of the caller's"),
            (@"^FluidQueries\..* (length|distance) = Infinity", "has no end"),
            (@" options\.", "are settings: what is out of range is brought into it, or thrown where they are used"),
        };
    }
}
