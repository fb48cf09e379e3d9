using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The package's shaders by path, without the assets that users edit.</summary>
    public static class TestShaders
    {
        const string Package = "Packages/com.sphfluid/";

        /// <summary>A shader set with the blocks of both methods; destroy it after use.</summary>
        public static FluidShaderSet CreateSet()
        {
            GpuTest.Require();
            var set = ScriptableObject.CreateInstance<FluidShaderSet>();
            set.CalculateParticleCellValue = Thesis("CalculateParticleCellValue");
            set.BitonicSort = Thesis("BitonicSort");
            set.ResetGridIndices = Thesis("ResetGridIndices");
            set.SetGridIndices = Thesis("SetGridIndices");
            set.SortParticles = Thesis("SortParticles");
            set.CalculateDensity = Thesis("CalculateDensity");
            set.CalculateForce = Thesis("CalculateForce");
            set.CalculateAcceleration = Thesis("CalculateAcceleration");
            set.CalculateNewPosition = Thesis("CalculateNewPosition");
            set.MeasureStatistics = Load("Shaders/Diagnostics/MeasureStatistics.compute");
            set.LoadParticles = Load("Shaders/Solver/Standard/LoadParticles.compute");
            set.ScanCells = Load("Shaders/Solver/Standard/ScanCells.compute");
            set.ScatterParticles = Load("Shaders/Solver/Standard/ScatterParticles.compute");
            set.StandardDensity = Load("Shaders/Solver/Standard/StandardDensity.compute");
            set.MoveParticles = Load("Shaders/Solver/Standard/MoveParticles.compute");
            set.GatherWalls = Load("Shaders/Solver/Standard/GatherWalls.compute");
            set.FindContacts = Load("Shaders/Solver/Standard/FindContacts.compute");
            set.ResolveContacts = Load("Shaders/Solver/Standard/ResolveContacts.compute");
            set.DampVelocities = Load("Shaders/Solver/Standard/DampVelocities.compute");
            set.PublishParticles = Load("Shaders/Solver/Standard/PublishParticles.compute");
            return set;
        }

        /// <summary>A compute shader of the package.</summary>
        public static ComputeShader Load(string path)
        {
            GpuTest.Require();
            return TestAssets.Load<ComputeShader>(Package + path);
        }

        static ComputeShader Thesis(string block)
        {
            return Load($"Shaders/Solver/Thesis/{block}.compute");
        }
    }
}
